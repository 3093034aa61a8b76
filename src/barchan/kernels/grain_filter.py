"""Wang & Hu's collapse: slopes that are too steep are smoothed by a filter over the eight neighbours.

Seed 003, eq. 3.10: h += G Δh where T Δh reaches the slope of repose, Δh being the weighted mean of the
neighbours less h. That makes or takes sand; here whole parcels go between a cell and each neighbour
instead, as many as its share of G Δh, and once between two cells that both are too steep: what the one gains
by its rule the other loses by its own.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.avalanche import neighbour
from barchan.kernels.grain_bed import renew_surface
from barchan.kernels.lending import lent
from barchan.kernels.mixture import slide

FACE_WEIGHT = (2.0 - math.sqrt(2.0)) / 4.0
CORNER_WEIGHT = (math.sqrt(2.0) - 1.0) / 4.0


class Filter(NamedTuple):
    """When and how strongly the filter works."""

    gain: float
    least: float
    """Difference to the neighbours' mean (parts) from which on it works."""


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _beside(place, size, wrap):
    """The places before and after one; the place itself beyond an open edge."""
    before = place - 1 if place > 0 else (size - 1 if wrap else place)
    after = place + 1 if place + 1 < size else (0 if wrap else place)
    return before, after


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _is_sharp(below, here, above, west, col, east, least):
    """Whether a cell of row ``here`` differs too much from the weighted mean of its neighbours."""
    faces = here[east] + here[west] + above[col] + below[col]
    corners = above[east] + above[west] + below[east] + below[west]
    mean = FACE_WEIGHT * np.float64(faces) + CORNER_WEIGHT * np.float64(corners)
    return abs(mean - np.float64(here[col])) >= least


@njit(cache=True, nogil=True, error_model="numpy")
def _find_sharp(level, grid, rule, sharp):
    """Mark the cells that do so, the columns at the edges first."""
    cols = grid.cols
    for row in range(grid.rows):
        south, north = _beside(row, grid.rows, grid.wrap_across)
        below, above = level[south * cols : (south + 1) * cols], level[north * cols : (north + 1) * cols]
        here, marks = level[row * cols : (row + 1) * cols], sharp[row * cols : (row + 1) * cols]
        for col in (0, cols - 1):
            west, east = _beside(col, cols, grid.wrap_along)
            marks[col] = _is_sharp(below, here, above, west, col, east, rule.least)
        for west in range(cols - 2):
            marks[west + 1] = _is_sharp(below, here, above, west, west + 1, west + 2, rule.least)


@njit(cache=True, nogil=True, error_model="numpy")
def smooth_slopes(ground, scale, grid, rule):
    """Smooth the surface once where it bends too sharply; returns how many parcels moved.

    Where the filter works is found on the surface as it was; sand then moves cell by cell from the southwest
    corner on, and no cell gives more than it has.
    """
    ground = lent(ground)
    before = ground.level.copy()
    sharp = np.zeros(before.size, np.bool_)
    _find_sharp(before, grid, rule, sharp)
    moved = 0
    for cell in range(before.size):
        if not sharp[cell]:
            continue
        for k in range(8):
            r, c = neighbour(cell // grid.cols, cell % grid.cols, k, grid)
            other = r * grid.cols + c
            if sharp[other] and other <= cell:
                continue
            weight = FACE_WEIGHT if k < 4 else CORNER_WEIGHT
            flow = rule.gain * weight * np.float64(before[other] - before[cell]) / scale.parcel
            parcels = np.int64(flow)
            parcels = min(max(parcels, -np.int64(ground.sand[cell])), np.int64(ground.sand[other]))
            ground.sand[cell] += parcels
            ground.sand[other] -= parcels
            ground.level[cell] += parcels * scale.parcel
            ground.level[other] -= parcels * scale.parcel
            slide(ground.mixture, other, cell, parcels)
            slide(ground.mixture, cell, other, -parcels)
            moved += abs(parcels)
    if moved > 0:
        renew_surface(ground, scale, grid)
    return moved
