"""Mixed axes against oblique hops: are barchans stretched, with unequal horns?

Nield & Baas (2008) make an oblique wind of polls along two axes of the lattice, a third along one and two
thirds along the other; their barchans are stretched across the wind and have unequal horns. Presets
`stretched-barchans` and `oblique-barchans`, the same mean direction (206.6°) and hops of 5 cells, 256²
cells, 300 steps; and a wind along an axis for comparison. Each dune that rises 1 m above the mean sand is
measured in the frame of the mean wind: width over length, slant (how much farther the left side of its
downwind edge reaches than the right, over the width; its sign gives the side, its size how unequal the
sides are) and crescent ([measures](measures.md#dunes-one-by-one)).
"""

import numpy as np

import barchan
from barchan.measures.dunes import find_dunes
from barchan.measures.horns import horns
from validation.study import Row, over_seeds, spread

TITLE = "Mixed axes and oblique hops"
LEAST = 1.0
"""Height (m) above the mean sand from which a heap counts as a dune."""
OBLIQUE = 206.565


def shapes(preset, direction, seed):
    """Means over the dunes of a run, seen along a wind."""
    scenario = barchan.load(preset, run__steps=300, run__save_every=300, run__seed=seed)
    last = barchan.simulate(scenario).isel(step=-1)
    dunes = find_dunes(last["elevation"].values, LEAST)
    seen = [horns(dune, direction, scenario.lattice.cell_size) for dune in dunes]
    slants = [s.slant for s in seen]
    return {
        "dunes": len(dunes),
        "stretch": np.exp(np.mean([np.log(s.width / s.length) for s in seen])),
        "slant": np.mean(slants),
        "unequal": np.mean(np.abs(slants)),
        "crescent": np.mean([s.crescent for s in seen]),
    }


def rows():
    cases = {
        "mixed axes": ("stretched-barchans", OBLIQUE),
        "oblique hops": ("oblique-barchans", OBLIQUE),
        "along an axis": ("barchans-p", 270.0),
    }
    found = dict(zip(cases, over_seeds(shapes, cases.values()), strict=True))
    expected = {"stretch": "mixed: stretched", "unequal": "mixed: unequal horns"}
    titles = {
        "dunes": "dunes in the field",
        "stretch": "width over length",
        "slant": "slant, with its sign",
        "unequal": "slant, its size",
        "crescent": "crescent",
    }
    for name, title in titles.items():
        values = "; ".join(f"{case} {spread(found[case][name], 2)}" for case in cases)
        yield Row(title, expected.get(name, "-"), values)


READING = """
Dunes under mixed axes are about twice as many as under the same wind with oblique hops, and smaller, and
their crescent is negative: few have horns. Stretched more than others they are not: they are as wide for
their length as dunes under a wind along an axis, and those under the oblique wind are wider. Nor are they
unequal more than others: the two sides of dunes differ as much under the oblique wind and even under one
along an axis, by chance (the mean with its sign is near zero under all three). What makes the horns of
Nield & Baas unequal this does not reproduce; their slabs are a tenth of a cell high and their hops one cell.
"""
