"""The mean height of a surface and how far cells lie from it."""

import numpy as np

from barchan.kernels.bed.state import DEVIATION, MEAN
from barchan.kernels.core.internal import internal


@internal()
def measure_levels(surface, levels):
    """Compute the levels from the whole surface (None: they are not kept)."""
    if levels is not None:
        total = np.int64(0)
        for cell in range(surface.size):
            total += np.int64(surface[cell])
        mean = (total << levels.shift) // surface.size
        deviation = np.int64(0)
        for cell in range(surface.size):
            deviation += abs((np.int64(surface[cell]) << levels.shift) - mean)
        levels.values[MEAN] = mean
        levels.values[DEVIATION] = deviation
