"""Exchange of sand between grains in flight and the bed: parcels lifted and laid down.

A parcel is the sand of one cell, as high as one unit of the bed. A grain takes one along, from the nearest
stack, or as many as a patch of nine stacks gives. Exchange happens one grain after the other in the order of
slots, so it is the same however the flight was shared among threads. The mesh is left as it was: rows of it
that must be recomputed before grains fly on are noted.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import available, class_at, put, take
from barchan.kernels.bed.grid import COL_STEP, ROW_STEP, neighbour
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.grains.bonds import movable, note_change, wind_breaks
from barchan.kernels.grains.pool import free_slot
from barchan.kernels.grains.state import CAPPED, COUNTS, LEFT, MOVED, NOWHERE, OUT, PATCH, TRAVEL_X, TRAVEL_Y
from barchan.kernels.grains.surface import note_stale

MIDDLE = 4
"""Parcels of a patch on the middle stack, where none is missing."""


@njit(cache=True, nogil=True, error_model="numpy", inline="always")
def pile_up(cell, parcels, ground):
    """Add parcels to a stack, or take them off it."""
    ground.sand[cell] += parcels
    ground.level[cell] += parcels * ground.scale.parcel
    ground.height[cell] = np.float32(ground.level[cell] * ground.scale.part)
    note_change(ground.bonds, cell, parcels)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _share(direction):
    """Parcels of a patch on the neighbour in a direction."""
    return 2 if ROW_STEP[direction] * COL_STEP[direction] == 0 else 1


@njit(cache=True, nogil=True, error_model="numpy", inline="always")
def _lay_row(west, at_sides, between, ground):
    """Lay parcels on three cells side by side."""
    pile_up(np.uint64(west), at_sides, ground)
    pile_up(np.uint64(west + 1), between, ground)
    pile_up(np.uint64(west + 2), at_sides, ground)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _is_plain(layer, row, col, grid):
    """Whether sand is of one size and a patch has all its nine stacks about the middle one."""
    if layer is not None:
        return False
    return 0 < row < grid.rows - 1 and 0 < col < grid.cols - 1


@njit(cache=True, nogil=True, error_model="numpy")
def _lay_shares(cell, size_class, ground):
    """Lay a grain's parcels over a cell and its neighbours; missing ones leave their share to the cell."""
    grid = ground.grid
    row, col = cell // grid.cols, cell % grid.cols
    rest = PATCH
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        other = r * grid.cols + c
        if other != cell:
            pile_up(other, _share(k), ground)
            put(ground.active_layer, other, size_class, _share(k))
            rest -= _share(k)
    pile_up(cell, rest, ground)
    put(ground.active_layer, cell, size_class, rest)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _is_deep(cell, ground, breaks):
    """Whether all nine stacks of a patch have what it may ask of any."""
    bonds, sand, cols = ground.bonds, ground.sand, ground.grid.cols
    least = movable(bonds, sand, np.uint64(cell), breaks)
    for middle in (cell - cols, cell, cell + cols):
        west, east = np.uint64(middle - 1), np.uint64(middle + 1)
        least = min(least, min(movable(bonds, sand, west, breaks), movable(bonds, sand, east, breaks)))
        least = min(least, movable(bonds, sand, np.uint64(middle), breaks))
    return least >= MIDDLE


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _given(cell, size_class, ground, breaks):
    """Parcels of a size class that a cell can give to what may or may not break bonds."""
    held = available(ground.active_layer, ground.sand, size_class, cell)
    return min(held, movable(ground.bonds, ground.sand, cell, breaks))


@njit(cache=True, nogil=True, error_model="numpy")
def _take_shares(cell, size_class, ground, breaks):
    """Take a grain's parcels; the cell gives what others have not. False: it cannot, nothing changed."""
    grid = ground.grid
    row, col = cell // grid.cols, cell % grid.cols
    rest = PATCH
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        other = r * grid.cols + c
        if other != cell:
            rest -= min(_share(k), _given(other, size_class, ground, breaks))
    if _given(cell, size_class, ground, breaks) < rest:
        return False
    pile_up(cell, -rest, ground)
    take(ground.active_layer, cell, size_class, rest)
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        other = r * grid.cols + c
        if other != cell:
            parcels = min(_share(k), _given(other, size_class, ground, breaks))
            pile_up(other, -parcels, ground)
            take(ground.active_layer, other, size_class, parcels)
    return True


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _lay_patch(cell, size_class, ground):
    """Do the same as ``_lay_shares``; the usual case needs no call, which hands over the whole ground."""
    grid = ground.grid
    row, col = cell // grid.cols, cell % grid.cols
    note_stale(row, 1, 1, ground)
    if _is_plain(ground.active_layer, row, col, grid):
        _lay_row(cell - grid.cols - 1, 1, 2, ground)
        _lay_row(cell - 1, 2, MIDDLE, ground)
        _lay_row(cell + grid.cols - 1, 1, 2, ground)
    else:
        _lay_shares(cell, size_class, ground)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _take_patch(cell, size_class, ground, breaks):
    """Do the same as ``_take_shares``, the usual case without a call."""
    grid = ground.grid
    row, col = cell // grid.cols, cell % grid.cols
    note_stale(row, 1, 1, ground)
    if _is_plain(ground.active_layer, row, col, grid) and _is_deep(cell, ground, breaks):
        _lay_row(cell - grid.cols - 1, -1, -2, ground)
        _lay_row(cell - 1, -2, -MIDDLE, ground)
        _lay_row(cell + grid.cols - 1, -1, -2, ground)
        return True
    return _take_shares(cell, size_class, ground, breaks)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def lay_down(cell, size_class, ground):
    """Lay the sand of a grain of some size on a cell, or over it and its neighbours."""
    if ground.scale.carried == 1:
        pile_up(cell, 1, ground)
        put(ground.active_layer, cell, size_class, 1)
        note_stale(cell // ground.grid.cols, 0, 0, ground)
    else:
        _lay_patch(cell, size_class, ground)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def take_up(cell, size_class, ground, breaks):
    """Take the sand of a grain of some size from a cell, or from it and its neighbours; False: too little.

    Bonded snow gives none but to what ``breaks`` bonds.
    """
    if ground.scale.carried > 1:
        return _take_patch(cell, size_class, ground, breaks)
    if _given(cell, size_class, ground, breaks) == 0:
        return False
    pile_up(cell, -1, ground)
    take(ground.active_layer, cell, size_class, 1)
    note_stale(cell // ground.grid.cols, 0, 0, ground)
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def exchange(first, count, grains, ground, landings, counts):
    """Lay down the sand of grains that came to rest and take that of those lifted, entry by entry.

    A cell that has too little left by then, or too little loose, gives none, and the slot stays free.
    """
    grains, ground, landings, counts = borrowed((grains, ground, landings, counts))
    breaks = wind_breaks(ground.bonds)
    for k in range(first, first + count):
        deposit, lift = landings.deposit_cell[k], landings.lift_cell[k]
        if deposit != NOWHERE:
            counts[TRAVEL_X] += landings.travel_x[k]
            counts[TRAVEL_Y] += landings.travel_y[k]
        if deposit == OUT:
            counts[LEFT] += 1
            counts[COUNTS + class_at(landings.size_class, k)] += 1
        elif deposit != NOWHERE:
            counts[CAPPED] += landings.capped[k]
            lay_down(deposit, class_at(landings.size_class, k), ground)
        if lift != NOWHERE:
            if take_up(lift, class_at(grains.size_class, landings.slot[k]), ground, breaks):
                counts[MOVED] += 1
            else:
                free_slot(landings.slot[k], grains)
