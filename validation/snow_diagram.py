"""Which forms does snow of an age take under a wind?

Snow of 30 kg/m² and 120 kg/m³ that has lain at -10 °C for 0.1 hours to 7 days, 2 % of its cells weak, then
six hours of a wind of 7 to 20 m/s over 6.4 × 16 m; two seeds. The class of the field follows from its relief,
skewness of slopes, speed and bonded share by stated limits (`barchan.measures.snow_forms`).

![Classes of forms over wind and age, their height and speed](../_static/snow-diagram.svg)
"""

import json

from validation.pages import DOCS, RESULTS
from validation.snow_scenes import advance, field, forms
from validation.study import Row, over_seeds

TITLE = "Forms of snow over wind and age"

WINDS = (7.0, 9.0, 11.0, 13.0, 16.0, 20.0)
AGES = (0.1, 6.0, 24.0, 72.0, 168.0)


def one(wind, age, seed):
    beneath = [{"mass": 30, "density": 120, "age": age, "weak_share": 0.02}]
    simulation = field(wind, -10.0, seed, mean=0, rows=32, columns=80, beneath=beneath)
    advance(simulation, 5.5)
    found = forms(simulation)
    return {name: found[name] for name in ("form", "relief", "spacing", "skew", "speed", "bonded")}


def rows():
    cases = [(wind, age) for age in AGES for wind in WINDS]
    results = over_seeds(one, cases, (1, 2))
    kept = [{"wind": w, "age": a, **r} for (w, a), r in zip(cases, results, strict=True)]
    (RESULTS / "snow_diagram.json").write_text(json.dumps(kept), "utf-8")
    for age in AGES:
        row = [r for (_, a), r in zip(cases, results, strict=True) if a == age]
        found = "; ".join(
            f"{w:g}: {' / '.join(dict.fromkeys(r['form']))}" for w, r in zip(WINDS, row, strict=True)
        )
        relief = "; ".join(f"{100 * sum(r['relief']) / 2:.1f}" for r in row)
        yield Row(f"age {age:g} h", "", f"{found}. Relief: {relief} cm", "")


READING = """
Bonded snow lies flat at 7 m/s. Below the wind that the cover withstands (the solid line of the figure) only
its weak cells give drift, which gathers in deposits of 8 to 10 cm with slip faces; they stand still, or
move by less than 0.1 m/h: stationary at 9 m/s, later also at 11 and 13 m/s. Above that line the whole cover
travels in forms up to 20 cm high, at 2 m/h under 11 m/s and 8 m/h under 20 m/s. Their slopes are as steep
to windward as to lee or steeper (skewness 0 to 0.6), but less than a tenth of their surface has bonded, so
the stated limits call them mixed: neither deposits with slip faces nor worn bonded snow. Of the published
fields, moving and stationary forms on young snow under weak winds and worn forms on old snow under strong
ones, the stationary ones come out where they should, and the worn ones do not come out at all: a wind that
exceeds the threshold strips old snow rather than carving it. Both seeds agree in 28 of 30 cases.
"""

COLOURS = {
    "flat": "#e4e4e4",
    "depositional, stationary": "#9ecae1",
    "depositional, moving": "#3182bd",
    "mixed": "#c7b9d8",
    "erosional": "#b5523b",
}


def draw(path):
    """Draw the classes and reliefs that were found, and the winds that fallen snow and drift withstand."""
    import matplotlib.pyplot as plt
    import numpy as np

    from barchan.snow.conditions import Conditions

    cells = json.loads((RESULTS / "snow_diagram.json").read_text("utf-8"))
    figure, axes = plt.subplots(figsize=(8.0, 4.2), layout="constrained")
    for cell in cells:
        x, y = WINDS.index(cell["wind"]), AGES.index(cell["age"])
        for half, form in enumerate(cell["form"]):
            axes.barh(y, 0.5, left=x - 0.5 + 0.5 * half, height=1.0, color=COLOURS[form], linewidth=0)
        relief = 100.0 * np.mean(cell["relief"])
        speed = np.mean(cell["speed"])
        text = f"{relief:.0f} cm\n{abs(speed):.1f} m/h" if relief >= 1.0 else "–"
        axes.text(x, y, text, ha="center", va="center", fontsize=8)
    parameters = field(9.0, -10.0, 1).model.parameters
    now = Conditions(parameters, 9.0, -10.0)
    for density, name, style in ((120.0, "fallen snow", "-"), (now.drift_density, "drift", "--")):
        stress = now.threshold(np.full(len(AGES), density), np.array(AGES))
        winds = parameters.drift.speed_of(np.sqrt(stress / parameters.air_density))
        axes.plot(np.interp(winds, WINDS, range(len(WINDS))), range(len(AGES)), f"k{style}", label=name)
    axes.set(
        xticks=range(len(WINDS)),
        xticklabels=[f"{w:g}" for w in WINDS],
        yticks=range(len(AGES)),
        yticklabels=[f"{a:g} h" for a in AGES],
        xlabel="wind at 10 m (m/s), six hours",
        ylabel="age of the snow at -10 °C",
    )
    handles = [plt.Rectangle((0, 0), 1, 1, color=COLOURS[form], label=form) for form in COLOURS]
    lines = axes.get_legend_handles_labels()[0]
    axes.legend(handles=handles + lines, loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8)
    axes.margins(0.0)
    figure.savefig(path, metadata={"Date": None})


if __name__ == "__main__":
    draw(DOCS / "_static" / "snow-diagram.svg")
