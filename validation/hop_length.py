"""Hops of 1 cell against hops of 5, no erosion in shadow, 200 steps (Elder 2009, Figs. 6 and 7).

Presets `hop-1-mean-100`, `hop-5-mean-100`, `hop-1-mean-2`, `hop-5-mean-2`. Nield & Baas (2008) call hops of
one cell a mere compression along the wind; Elder (2009) compresses its picture of hops of 5 to 48 % to
match the frequency of the bedforms. Scales are the dominant spacing along the wind and, of the same
spectrum's other axis, across it. If hops only compressed the field along the wind, the scale across would
keep its size.
"""

import barchan
from barchan.measures import dominant_spacing
from validation.study import Row, number, over_seeds, spread

TITLE = "Hop length 1 against 5"


def scales(preset, seed):
    scenario = barchan.load(preset, run__seed=seed)
    surface = barchan.simulate(scenario)["elevation"].values[-1]
    return {"along": dominant_spacing(surface, 1.0, 270.0), "across": dominant_spacing(surface, 1.0, 180.0)}


def rows():
    depths = (100, 2)
    results = over_seeds(scales, [(f"hop-{hop}-mean-{depth}",) for depth in depths for hop in (1, 5)])
    for depth, short, long in zip(depths, results[::2], results[1::2], strict=True):
        for way in ("along", "across"):
            ratio = [a / b for a, b in zip(short[way], long[way], strict=True)]
            what = f"scale {way} the wind, hop 1 to hop 5, {depth} slabs a cell"
            scale = f" ({spread(short[way])} to {spread(long[way])} cells)"
            if way == "along" and depth == 100:
                row = number(what, 0.48, ratio, note="by eye")
            elif way == "along":
                row = Row(what, "about half", spread(ratio))
            else:
                row = Row(what, "1 for a mere compression", spread(ratio))
            yield Row(row.what, row.published, row.found + scale, row.verdict)


READING = """
With much sand the field is compressed along the wind as published, and across it by a sixth at most, within
the spread of the seeds: nearly the mere compression that Nield & Baas speak of. With 2 slabs a cell the
ratio is smaller, about a third, so hops of one cell change more than the scale there (Elder 2009 also finds
the differences larger with little sand).
"""
