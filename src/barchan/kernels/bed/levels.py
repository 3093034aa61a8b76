"""The mean height of a surface and how far cells lie from it, followed as cells change."""

import numpy as np
from numba import njit

from barchan.kernels.bed.state import DEVIATION, MEAN


@njit(cache=True)
def measure_levels(surface, levels, speedup):
    """Take the levels anew from the whole surface."""
    total = np.int64(0)
    for cell in range(surface.size):
        total += np.int64(surface[cell])
    levels[MEAN] = (total << speedup.shift) // surface.size
    levels[DEVIATION] = 0
    for cell in range(surface.size):
        levels[DEVIATION] += abs((np.int64(surface[cell]) << speedup.shift) - levels[MEAN])


@njit(cache=True, forceinline=True)
def move_level(levels, before, after, speedup):
    """Follow one cell from one height to another."""
    mean = levels[MEAN]
    levels[DEVIATION] += abs((after << speedup.shift) - mean) - abs((before << speedup.shift) - mean)
