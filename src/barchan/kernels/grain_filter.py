"""Wang & Hu's collapse: slopes that are too steep are smoothed by a filter over the eight neighbours.

Seed 003, eq. 3.10: h += G Δh where T Δh reaches the slope of repose, Δh being the weighted mean of the
neighbours less h. That makes or takes sand; here whole parcels go between a cell and each neighbour
instead, as many as its share of G Δh.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.avalanche import neighbour
from barchan.kernels.grain_bed import renew_surface

FACE_WEIGHT = (2.0 - math.sqrt(2.0)) / 4.0
CORNER_WEIGHT = (math.sqrt(2.0) - 1.0) / 4.0


class Filter(NamedTuple):
    """When and how strongly the filter works."""

    gain: float
    least: float
    """Difference to the neighbours' mean (parts) from which on it works."""


@njit(cache=True, nogil=True, error_model="numpy")
def _excess(cell, level, grid):
    """The weighted mean of the neighbours less the cell itself (parts)."""
    row, col = cell // grid.cols, cell % grid.cols
    total = 0.0
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        weight = FACE_WEIGHT if k < 4 else CORNER_WEIGHT
        total += weight * np.float64(level[r * grid.cols + c] - level[cell])
    return total


@njit(cache=True, nogil=True, error_model="numpy")
def smooth_slopes(ground, scale, grid, rule):
    """Smooth the surface once where it bends too sharply; returns how many parcels moved.

    Where the filter works is found on the surface as it was; sand then moves cell by cell from the southwest
    corner on, and no cell gives more than it has.
    """
    before = ground.level.copy()
    moved = 0
    for cell in range(before.size):
        if abs(_excess(cell, before, grid)) < rule.least:
            continue
        for k in range(8):
            r, c = neighbour(cell // grid.cols, cell % grid.cols, k, grid)
            other = r * grid.cols + c
            weight = FACE_WEIGHT if k < 4 else CORNER_WEIGHT
            flow = rule.gain * weight * np.float64(before[other] - before[cell]) / scale.parcel
            parcels = np.int64(flow)
            parcels = min(max(parcels, -np.int64(ground.sand[cell])), np.int64(ground.sand[other]))
            ground.sand[cell] += parcels
            ground.sand[other] -= parcels
            ground.level[cell] += parcels * scale.parcel
            ground.level[other] -= parcels * scale.parcel
            moved += abs(parcels)
    if moved > 0:
        renew_surface(ground, scale, grid)
    return moved
