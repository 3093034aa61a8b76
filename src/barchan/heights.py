"""Heights in the whole numbers that kernels count in, and their range in 64 bits."""

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.errors import Problem, ScenarioError

FRACTION_BITS = 20
"""Binary places of a height below one slab, over ground that is not flat."""

MOST_RELIEF = 1 << 29
"""Slabs from the lowest ground to the highest: shadow lines are distinguished over twice as much."""

MOST_TOGETHER = 1 << 42
"""Slabs that all cells' heights may come to where a mean height is kept: sums stay below 2**62."""


def above_lowest(ground: NDArray[np.float64], thickness: float) -> NDArray[np.int64]:
    """Heights above the lowest ground in 2**-``FRACTION_BITS`` slabs of this thickness (m)."""
    units = np.rint(ground / thickness * 2.0**FRACTION_BITS)
    return (units - units.min()).astype(np.int64)


def check_heights(bed: Bed, mean_kept: bool) -> None:
    """Raise ScenarioError where heights, or the sum that gives their mean, cannot be counted exactly."""
    thickness = bed.lattice.thickness
    rise = bed.ground - bed.ground.min()
    relief = float(rise.max()) / thickness
    together = float(rise.sum()) / thickness + bed.units
    message = ""
    if relief > MOST_RELIEF:
        message = (
            f"rises {rise.max():g} m, which is {relief:.3g} slabs of {thickness:g} m; "
            f"allowed: up to {MOST_RELIEF:.3g} slabs, so thicker slabs or lower ground"
        )
    elif mean_kept and together > MOST_TOGETHER:
        message = (
            f"and the sand on it come to {together:.3g} slabs of {thickness:g} m over all cells; allowed: "
            f"up to {MOST_TOGETHER:.3g} for a model that keeps a mean height, so thicker slabs"
        )
    if message:
        raise ScenarioError([Problem("ground", message)])
