"""Which forms follow one another in a series of storms?

Bare ground, 3.2 × 12.8 m, open along the wind, cells and hops of 0.1 m, -10 °C. 12 kg/m² fall within six
hours of 8 m/s; 12 hours of 11 m/s; then calm for 4.5 days; then 12 hours of 15 m/s with drift from upwind.
Classes by `barchan.measures.snow_forms`; five seeds.
"""

from collections import Counter

from validation.snow_scenes import advance, fine, forms, part
from validation.study import Row, over_seeds, spread

TITLE = "Forms of snow after storms in order"

STAGES = (
    ("snowfall", part(6.0, 8.0, snowfall=2.0)),
    ("young", part(12.0, 11.0)),
    ("calm", part(108.0, 0.0)),
    ("old", part(12.0, 15.0)),
)


def series(seed):
    """Class, relief and skewness at the end of each stage."""
    simulation = fine([winds for _, winds in STAGES], seed, influx=0.5)
    found = {}
    for name, winds in STAGES:
        advance(simulation, winds["seconds"] / 3600.0 - 0.5)
        found |= {f"{name}_{key}": value for key, value in forms(simulation).items()}
    return found


def rows():
    (found,) = over_seeds(series, [()])
    expected = {"young": "flat or skewness below 0", "old": "skewness above 0"}
    for name, _ in STAGES:
        classes = Counter(found[f"{name}_form"])
        skew = found[f"{name}_skew"]
        held = {
            "young": [s < 0.0 or form == "flat" for s, form in zip(skew, found["young_form"], strict=True)],
            "old": [s > 0.0 for s in skew],
        }.get(name)
        relief = [100.0 * value for value in found[f"{name}_relief"]]
        text = ", ".join(f"{form} ({count})" for form, count in classes.most_common())
        yield Row(
            WORDS[name],
            expected.get(name, ""),
            f"{text}; skewness {spread(skew)}, relief {spread(relief)} cm, bonded "
            f"{spread(found[f'{name}_bonded'])}, bare {spread(found[f'{name}_bare'])}",
            f"{sum(held)} of 5 seeds" if held else "",
        )


WORDS = {
    "snowfall": "after 6 h of snowfall in 8 m/s",
    "young": "after 12 h of 11 m/s",
    "calm": "after 4.5 calm days",
    "old": "after 12 h of 15 m/s",
}

READING = """
"""
