"""Do snow's waves and dunes lie in the ranges that are reported?

Cells and hops of 0.2 m, quanta of 1 kg/m², 9.6 × 25.6 m, periodic; five seeds. Waves: 60 kg/m² of loose
drift without bonds under 10 m/s at -10 °C for 24 hours. Cover: 12 kg/m² of drift on bare ground under 12
m/s for 10 hours, at -20 and at -5 °C, bonds growing. Speeds are from frames half an hour apart. All with
creep by impacts, the default (`creep.law` `impacts`), and with creep by the threshold. Waves also on cells
and hops of 0.1 m, 4.8 × 19.2 m.
"""

from barchan.snow.conditions import Conditions
from validation.snow_scenes import FINE, advance, field, fine, forms, part
from validation.study import Row, over_seeds, spread

TITLE = "Waves and dunes of snow"


LAWS = ("impacts", "threshold")


def waves(law, is_fine, seed):
    model = {"bonding": {"grows": False}, "creep": {"law": law}}
    if is_fine:
        model |= {"temperature": -10, "reference_wind": 10}
        simulation = fine([part(25.0, 10.0)], seed, mean=60, rows=48, columns=192, **model)
    else:
        simulation = field(10.0, -10.0, seed, **model)
    advance(simulation, 24.0)
    found = forms(simulation)
    expected = Conditions(simulation.model.parameters, 10.0, -10.0).flux / found["density"] / found["relief"]
    return {
        **found,
        "ratio": found["speed"] / (3600.0 * expected),
        "index": found["spacing"] / found["relief"],
    }


def cover(law, temperature, seed):
    simulation = field(12.0, temperature, seed, mean=12, creep={"law": law})
    advance(simulation, 10.0)
    return forms(simulation)


def _within(values, low, high):
    return f"{sum(low <= v <= high for v in values)} of {len(values)} seeds within"


def rows():
    for law in LAWS:
        for is_fine in (False, True):
            where = f"cells of {FINE:g} m, creep by {law}" if is_fine else f"creep by {law}"
            yield from _named(where, _rows_of_waves(law, is_fine))
        yield from _named(f"creep by {law}", _rows_of_cover(law))


def _named(where, rows):
    for row in rows:
        yield Row(f"{row.what}, {where}", row.published, row.found, row.verdict)


def _rows_of_waves(law, is_fine):
    (found,) = over_seeds(waves, [(law, is_fine)])
    yield Row(
        "spacing of waves", "3 to 20 m", f"{spread(found['spacing'])} m", _within(found["spacing"], 3, 20)
    )
    index = found["index"]
    yield Row("spacing over height", "20 to 50", spread(index), _within(index, 20, 50))
    yield Row("skewness of slopes", "below -0.3", spread(found["skew"]), _within(found["skew"], -9, -0.3))
    ratio = found["ratio"]
    yield Row("speed over Q/(ρ H)", "0.6 to 1.4", spread(ratio), _within(ratio, 0.6, 1.4))
    yield Row("speed", "above 0.05 m/h", f"{spread(found['speed'])} m/h", _within(found["speed"], 0.05, 99))


def _rows_of_cover(law):
    cold, warm = over_seeds(cover, [(law, -20.0), (law, -5.0)])
    yield Row(
        "height of dunes on bare ground, -20 °C",
        "0.07 to 0.55 m",
        f"{spread(cold['relief'])} m",
        _within(cold["relief"], 0.07, 0.55),
    )
    yield Row(
        "spacing of these", "3 to 20 m", f"{spread(cold['spacing'])} m", _within(cold["spacing"], 3, 20)
    )
    yield Row("skewness of their slopes", "below -0.3", spread(cold["skew"]), _within(cold["skew"], -9, -0.3))
    yield Row(
        "bare ground between them", "80 to 95 %", spread(cold["bare"]), _within(cold["bare"], 0.8, 0.95)
    )
    yield Row(
        "relief at -5 °C",
        "lower than at -20 °C",
        f"{spread(warm['relief'])} m",
        f"{sum(w < c for w, c in zip(warm['relief'], cold['relief'], strict=True))} of 5 seeds",
    )


READING = """
By impacts waves form, their spacing and speed in the reported ranges in every seed. Their shape does not
come out on cells and hops of 0.2 m: they are low for their spacing, and steeper to windward, where a slip
face should be in the lee. On cells and hops of 0.1 m they have slip faces in every seed, are higher for their
spacing than reported, and travel 2.4 times as fast as their flux and height let one expect, for which no
cause was found. By the threshold the surface stays flat on either lattice. On bare ground at 12 m/s the cover
hardly opens in ten hours, by either law, and the warmer one is the flatter in every seed. So bonding races
growth as predicted, but the forms of depositing snow need a finer lattice than the first, or another law of
creep.
"""
