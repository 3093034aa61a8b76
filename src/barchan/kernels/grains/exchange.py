"""Exchange of sand between grains in flight and the bed: parcels lifted and laid down.

A parcel is the sand of one cell, as high as one unit of the bed. A grain takes one along, from the nearest
stack, or as many as a patch of nine stacks gives. Exchange happens one grain after the other in the order of
slots, or as if it did (``territories``), however the work is shared among threads. The mesh is left as it
was: rows of it that must be recomputed before grains fly on are noted.
"""

import numpy as np

from barchan.kernels.bed.active_layer import available, class_at, put, take
from barchan.kernels.bed.grid import COL_STEP, ROW_STEP, neighbour
from barchan.kernels.core.internal import internal, woven
from barchan.kernels.grains.bonds import movable, note_change
from barchan.kernels.grains.pool import free_slot
from barchan.kernels.grains.state import CAPPED, COUNTS, LEFT, MOVED, OUT, PATCH, TRAVEL_X, TRAVEL_Y
from barchan.kernels.grains.surface import note_stale

MIDDLE = 4
"""Parcels of a patch on the middle stack, where none is missing."""


@internal(error_model="numpy", inline="always")
def pile_up(cell, parcels, ground):
    """Add parcels to a stack, or take them off it."""
    ground.sand[cell] += parcels
    ground.level[cell] += parcels * ground.scale.parcel
    ground.height[cell] = np.float32(ground.level[cell] * ground.scale.part)
    note_change(ground.bonds, cell, parcels)


@internal(error_model="numpy", forceinline=True)
def _share(direction):
    """Parcels of a patch on the neighbour in a direction."""
    return 2 if ROW_STEP[direction] * COL_STEP[direction] == 0 else 1


@internal(error_model="numpy", inline="always")
def _lay_row(west, at_sides, between, ground):
    """Lay parcels on three cells side by side."""
    pile_up(np.uint64(west), at_sides, ground)
    pile_up(np.uint64(west + 1), between, ground)
    pile_up(np.uint64(west + 2), at_sides, ground)


@internal(error_model="numpy", forceinline=True)
def _is_plain(layer, row, col, grid):
    """Whether sand is of one size and a patch has all its nine stacks about the middle one."""
    if layer is not None:
        return False
    return 0 < row < grid.rows - 1 and 0 < col < grid.cols - 1


@internal(error_model="numpy")
def _lay_shares(row, col, size_class, ground):
    """Lay a grain's parcels over a cell and its neighbours; missing ones leave their share to the cell."""
    grid, rest = ground.grid, PATCH
    cell = row * grid.cols + col
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        other = r * grid.cols + c
        if other != cell:
            pile_up(other, _share(k), ground)
            put(ground.active_layer, other, size_class, _share(k))
            rest -= _share(k)
    pile_up(cell, rest, ground)
    put(ground.active_layer, cell, size_class, rest)


@internal(error_model="numpy", forceinline=True)
def _is_deep(cell, ground, breaks):
    """Whether all nine stacks of a patch have what it may ask of any."""
    bonds, sand, cols = ground.bonds, ground.sand, ground.grid.cols
    least = movable(bonds, sand, np.uint64(cell), breaks)
    for middle in (cell - cols, cell, cell + cols):
        west, east = np.uint64(middle - 1), np.uint64(middle + 1)
        least = min(least, min(movable(bonds, sand, west, breaks), movable(bonds, sand, east, breaks)))
        least = min(least, movable(bonds, sand, np.uint64(middle), breaks))
    return least >= MIDDLE


@internal(error_model="numpy", forceinline=True)
def _given(cell, size_class, ground, breaks):
    """Parcels of a size class that a cell can give to what may or may not break bonds."""
    held = available(ground.active_layer, ground.sand, size_class, cell)
    return min(held, movable(ground.bonds, ground.sand, cell, breaks))


@internal(error_model="numpy")
def _take_shares(row, col, size_class, ground, breaks):
    """Take a grain's parcels; the cell gives what others have not. False: it cannot, nothing changed."""
    grid, rest = ground.grid, PATCH
    cell = row * grid.cols + col
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


@internal(error_model="numpy", forceinline=True)
def _lay_patch(row, col, size_class, ground):
    """Do the same as ``_lay_shares``; the usual case needs no call, which hands over the whole ground."""
    grid, cell = ground.grid, row * ground.grid.cols + col
    note_stale(row, 1, 1, ground)
    if _is_plain(ground.active_layer, row, col, grid):
        _lay_row(cell - grid.cols - 1, 1, 2, ground)
        _lay_row(cell - 1, 2, MIDDLE, ground)
        _lay_row(cell + grid.cols - 1, 1, 2, ground)
    else:
        _lay_shares(row, col, size_class, ground)


@internal(error_model="numpy", forceinline=True)
def _take_patch(row, col, size_class, ground, breaks):
    """Do the same as ``_take_shares``, the usual case without a call."""
    grid, cell = ground.grid, row * ground.grid.cols + col
    note_stale(row, 1, 1, ground)
    if _is_plain(ground.active_layer, row, col, grid) and _is_deep(cell, ground, breaks):
        _lay_row(cell - grid.cols - 1, -1, -2, ground)
        _lay_row(cell - 1, -2, -MIDDLE, ground)
        _lay_row(cell + grid.cols - 1, -1, -2, ground)
        return True
    return _take_shares(row, col, size_class, ground, breaks)


@internal(error_model="numpy", forceinline=True)
def lay_down(row, col, size_class, ground):
    """Lay the sand of a grain of some size on a cell, or over it and its neighbours."""
    if ground.scale.carried == 1:
        cell = row * ground.grid.cols + col
        pile_up(cell, 1, ground)
        put(ground.active_layer, cell, size_class, 1)
        note_stale(row, 0, 0, ground)
    else:
        _lay_patch(row, col, size_class, ground)


@internal(error_model="numpy", forceinline=True)
def take_up(row, col, size_class, ground, breaks):
    """Take the sand of a grain of some size from a cell, or from it and its neighbours; False: too little.

    Bonded snow gives none but to what ``breaks`` bonds.
    """
    if ground.scale.carried > 1:
        return _take_patch(row, col, size_class, ground, breaks)
    cell = row * ground.grid.cols + col
    if _given(cell, size_class, ground, breaks) == 0:
        return False
    pile_up(cell, -1, ground)
    take(ground.active_layer, cell, size_class, 1)
    note_stale(row, 0, 0, ground)
    return True


@woven(error_model="numpy")
def end_travel(k, landings, counts):
    """Count the way of the grain that came to rest, or left the field, by entry ``k``."""
    counts[TRAVEL_X] += landings.travel_x[k]
    counts[TRAVEL_Y] += landings.travel_y[k]
    if landings.deposit_cell[k] == OUT:
        counts[LEFT] += 1
        counts[COUNTS + class_at(landings.size_class, k)] += 1
    else:
        counts[CAPPED] += landings.capped[k]


@woven(error_model="numpy")
def deposit(k, row, col, ground, landings, counts):
    """Lay down the sand of the grain that came to rest on a cell, by entry ``k``."""
    end_travel(k, landings, counts)
    lay_down(row, col, class_at(landings.size_class, k), ground)


@woven(error_model="numpy")
def lift(k, row, col, breaks, grains, ground, landings, counts):
    """Take the sand of the grain that entry ``k`` lifts from a cell.

    A cell that has too little left by then, or too little loose, gives none, and the slot stays free.
    """
    slot = landings.slot[k]
    if take_up(row, col, class_at(grains.size_class, slot), ground, breaks):
        counts[MOVED] += 1
    else:
        free_slot(slot, grains)
