"""Which forms follow one another in a series of storms?

Bare ground, 2.4 × 11.2 m, periodic, cells and hops of 0.1 m, quanta of 2 kg/m², -10 °C. 24 kg/m² fall within
six hours of 8 m/s; then 12 hours of 11 m/s, calm for 4.5 days, and 12 hours of 15 m/s. Classes by
`barchan.measures.snow_forms`; five seeds.
"""

from collections import Counter

from validation.snow_scenes import advance, fine, forms, part
from validation.study import Row, over_seeds, spread

TITLE = "Forms of snow after storms in order"

STAGES = (
    ("snowfall", part(6.0, 8.0, snowfall=4.0)),
    ("young", part(12.0, 11.0)),
    ("calm", part(108.0, 0.0)),
    ("old", part(12.0, 15.0)),
)


def series(seed):
    """Class, relief and skewness at the end of each stage."""
    winds = [winds for _, winds in STAGES]
    simulation = fine(winds, seed, rows=24, columns=112, quantum=2)
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
            f"{sum(held)} of {len(held)} seeds" if held else "",
        )


WORDS = {
    "snowfall": "after 6 h of snowfall in 8 m/s",
    "young": "after 12 h of 11 m/s",
    "calm": "after 4.5 calm days",
    "old": "after 12 h of 15 m/s",
}

READING = """
The first storm leaves what is expected of young snow: forms with slip faces that travel, in every seed. In
the calm they bond and stand. The second storm is above what fallen snow of five days withstands and below
what drift of that age does. Two fields of five are then worn, steeper to windward and mostly bonded; in the
other three the drift that it set in motion travels over the old forms with slip faces of its own. So the
order comes out, and worn forms do in two fields of five, within the twelve hours that are reported.
"""
