"""Wang & Hu's collapse: slopes that are too steep are smoothed by a filter over the eight neighbours.

Szabó 2019, eq. 3.10: h += G Δh where T Δh reaches the slope of repose, Δh being the weighted mean of the
neighbours less h. That rule makes or takes sand. Here whole parcels go between a cell and each neighbour
instead: their number is the neighbour's share of G Δh, and between two cells that both are too steep they
go once, for the gain by the rule of one cell is the loss by the rule of the other.
"""

import math

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import slide
from barchan.kernels.bed.grid import neighbour
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal
from barchan.kernels.grains.bonds import movable
from barchan.kernels.grains.exchange import pile_up
from barchan.kernels.grains.surface import note_stale, renew_stale

FACE_WEIGHT = (2.0 - math.sqrt(2.0)) / 4.0
CORNER_WEIGHT = (math.sqrt(2.0) - 1.0) / 4.0

_MOVES = 2
"""Mark of cells that may move sand; 1 of those that are too steep, and move less than a parcel."""

_PARCEL = 0.99
"""Parcels from which on an exchange may be one parcel, however numbers are rounded."""


@internal(error_model="numpy", forceinline=True)
def _beside(place, size, wrap):
    """The places before and after one; the place itself beyond an open edge."""
    before = place - 1 if place > 0 else (size - 1 if wrap else place)
    after = place + 1 if place + 1 < size else (0 if wrap else place)
    return before, after


@internal(error_model="numpy", forceinline=True)
def _mark(below, here, above, west, col, east, factors, least):
    """The mark of a cell of row ``here``: whether it differs too much from its neighbours' weighted mean.

    Most that do differ too little from each neighbour to move a parcel. ``factors`` make parcels of
    differences to neighbours at a face and at a corner.
    """
    middle = here[col]
    faces = here[east] + here[west] + above[col] + below[col]
    corners = above[east] + above[west] + below[east] + below[west]
    mean = FACE_WEIGHT * np.float64(faces) + CORNER_WEIGHT * np.float64(corners)
    high = max(max(here[east], here[west]), max(above[col], below[col]))
    low = min(min(here[east], here[west]), min(above[col], below[col]))
    at_faces = factors[0] * np.float64(max(high - middle, middle - low))
    high = max(max(above[east], above[west]), max(below[east], below[west]))
    low = min(min(above[east], above[west]), min(below[east], below[west]))
    at_corners = factors[1] * np.float64(max(high - middle, middle - low))
    is_sharp = abs(mean - np.float64(middle)) >= least
    return np.uint8(is_sharp) + np.uint8(is_sharp & (max(at_faces, at_corners) >= _PARCEL))


@internal(error_model="numpy")
def _mark_row(row, level, grid, factors, least, marks):
    """Mark the cells of a row, the columns at the edges first; the highest mark."""
    cols = grid.cols
    south, north = _beside(row, grid.rows, grid.wrap_across)
    below, above = level[south * cols : (south + 1) * cols], level[north * cols : (north + 1) * cols]
    here = level[row * cols : (row + 1) * cols]
    for col in (0, cols - 1):
        west, east = _beside(col, cols, grid.wrap_along)
        marks[col] = _mark(below, here, above, west, col, east, factors, least)
    for west in range(cols - 2):
        marks[west + 1] = _mark(below, here, above, west, west + 1, west + 2, factors, least)
    highest = marks[0]
    for col in range(cols):
        highest = max(highest, marks[col])
    return highest


@internal(error_model="numpy", forceinline=True)
def _exchange(cell, before, marks, ground, rule):
    """Exchange parcels between a cell and its neighbours; the number that moved."""
    grid = ground.grid
    moved = 0
    row, col = cell // grid.cols, cell % grid.cols
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        other = r * grid.cols + c
        if marks[other] and other <= cell:
            continue
        weight = FACE_WEIGHT if k < 4 else CORNER_WEIGHT
        flow = rule.gain * weight * np.float64(before[other] - before[cell]) / ground.scale.parcel
        parcels = np.int64(flow)
        mine = movable(ground.bonds, ground.sand, cell, False)
        parcels = min(max(parcels, -mine), movable(ground.bonds, ground.sand, other, False))
        if parcels != 0:
            pile_up(cell, parcels, ground)
            pile_up(other, -parcels, ground)
            note_stale(row, 0, 0, ground)
            note_stale(r, 0, 0, ground)
            slide(ground.active_layer, other, cell, parcels)
            slide(ground.active_layer, cell, other, -parcels)
            moved += abs(parcels)
    return moved


@njit(cache=True, nogil=True, error_model="numpy")
def smooth_slopes(ground, rule, before, marks):
    """Smooth the surface once where it bends too sharply; returns how many parcels moved.

    Where the filter works is found on the surface as it was; sand then moves cell by cell from the southwest
    corner on, and no cell gives more than it has. ``before`` and ``marks`` (both over the cells) are work
    space; ``marks`` is all zero afterwards.
    """
    ground, before, marks = borrowed((ground, before, marks))
    grid, parcel = ground.grid, ground.scale.parcel
    cols = grid.cols
    for cell in range(before.size):
        before[cell] = ground.level[cell]
    highest = np.empty(grid.rows, np.uint8)
    factors = rule.gain * FACE_WEIGHT / parcel, rule.gain * CORNER_WEIGHT / parcel
    for row in range(grid.rows):
        here = marks[row * cols : (row + 1) * cols]
        highest[row] = _mark_row(row, before, grid, factors, rule.least, here)
    moved = 0
    for row in range(grid.rows):
        if highest[row] == _MOVES:
            for cell in range(row * cols, (row + 1) * cols):
                if marks[cell] == _MOVES:
                    moved += _exchange(cell, before, marks, ground, rule)
    if moved > 0:
        renew_stale(0, grid.rows, ground)
    marks[:] = 0
    return moved
