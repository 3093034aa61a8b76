"""A field that looks different from every side, and where its heights must come out again."""

import numpy as np
import xarray as xr

from barchan.entry import simulate
from tests.tiny import tiny

ROWS, COLUMNS, CELL = 14, 20, 2.0
SLAB = CELL / 3
"""Height of a slab (m) where a scenario does not say: a third of the cell's width."""

STEPS = (0, 5, 10)


def slabs(step: int) -> np.ndarray:
    """Slabs of sand: a hump in the south-west, another height in each corner, all one more each frame."""
    row, column = np.indices((ROWS, COLUMNS))
    hump = np.rint(30 * np.exp(-((row - 3) ** 2 + (column - 4) ** 2) / 6.0)).astype(int)
    hump[0, 0], hump[0, -1], hump[-1, -1], hump[-1, 0] = 2, 9, 5, 13
    return hump + step // 5


def asymmetric(**changes) -> xr.Dataset:
    """Three frames of such a field, as ``barchan.simulate`` returns them."""
    size = {"lattice__rows": ROWS, "lattice__columns": COLUMNS, "lattice__cell_size": CELL, "run__steps": 10}
    run = simulate(tiny(**size, **changes))
    for place, step in enumerate(STEPS):
        run["sand"][place] = slabs(step)
    run["elevation"][...] = run["ground"] + run["sand"] * SLAB
    return run


def told_of(run: xr.Dataset, directions=(270.0, 270.0, 270.0), **changes) -> xr.Dataset:
    """The same frames as if another scenario had made them, under winds from these directions."""
    size = {"lattice__rows": ROWS, "lattice__columns": COLUMNS, "lattice__cell_size": CELL, "run__steps": 10}
    other = run.copy(deep=True)
    other.attrs["scenario"] = tiny(**size, **changes).text()
    other["wind_direction"][...] = np.array(directions)
    return other
