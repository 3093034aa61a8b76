"""Which forms does snow of an age take under a wind?

Snow of 30 kg/m² and 120 kg/m³ that has lain at -10 °C for 0.1 hours to 7 days, 2 % of its cells weak, then
six hours of a wind of 7 to 20 m/s over 6.4 × 16 m; two seeds. The class of the field follows from its relief,
skewness of slopes, speed and bonded share by stated limits (`barchan.measures.snow_forms`).
"""

import json

from validation.pages import RESULTS
from validation.snow.scenes import advance, field, forms
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
