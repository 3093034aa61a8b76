"""What grains in flight do to the bed: parcels lifted and laid down, and slopes that slide.

A parcel is the sand of one cell, as high as one unit of the bed. A grain takes one along, from the nearest
stack, or as many as a patch of nine stacks gives. Exchange happens one grain after the other in the order of
slots, so it is the same however the flight was shared among threads. The mesh is left as it was: rows of it
that must be computed anew before grains fly on are noted.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import available, kind_of, put, take
from barchan.kernels.bed.grid import COL_STEP, ROW_STEP, neighbour
from barchan.kernels.bed.relax import CHECKED, enqueue, enqueue_about, relax_queue
from barchan.kernels.bed.state import Stacks, Unstable
from barchan.kernels.core.borrow import lent
from barchan.kernels.grains.slots import free_slot
from barchan.kernels.grains.state import CAPPED, COUNTS, LEFT, MOVED, NOWHERE, OUT, PATCH, TRAVEL_X, TRAVEL_Y
from barchan.kernels.grains.surface import note_stale, renew_mesh

_MIDDLE = 4
"""Parcels of a patch on the middle stack, where none is missing."""


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def pile_up(cell, parcels, ground, scale):
    """Add parcels to a stack, or take them off it."""
    ground.sand[cell] += parcels
    ground.level[cell] += parcels * scale.parcel
    ground.height[cell] = np.float32(ground.level[cell] * scale.part)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _share(direction):
    """Parcels of a patch on the neighbour in a direction."""
    return 2 if ROW_STEP[direction] * COL_STEP[direction] == 0 else 1


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _lay_row(west, at_sides, between, ground, scale):
    """Lay parcels on three cells side by side."""
    pile_up(np.uint64(west), at_sides, ground, scale)
    pile_up(np.uint64(west + 1), between, ground, scale)
    pile_up(np.uint64(west + 2), at_sides, ground, scale)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _is_plain(mixture, row, col, grid):
    """Whether sand is all alike and a patch has all its nine stacks about the middle one."""
    if mixture is not None:
        return False
    return 0 < row < grid.rows - 1 and 0 < col < grid.cols - 1


@njit(cache=True, nogil=True, error_model="numpy")
def _lay_shares(cell, kind, ground, scale, grid):
    """Lay a grain's parcels over a cell and its neighbours; missing ones leave their share to the cell."""
    row, col = cell // grid.cols, cell % grid.cols
    rest = PATCH
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        other = r * grid.cols + c
        if other != cell:
            pile_up(other, _share(k), ground, scale)
            put(ground.mixture, other, kind, _share(k))
            rest -= _share(k)
    pile_up(cell, rest, ground, scale)
    put(ground.mixture, cell, kind, rest)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _is_deep(cell, sand, grid):
    """Whether all nine stacks of a patch have what it may ask of any."""
    least = sand[np.uint64(cell)]
    for middle in (cell - grid.cols, cell, cell + grid.cols):
        least = min(least, min(sand[np.uint64(middle - 1)], sand[np.uint64(middle + 1)]))
        least = min(least, sand[np.uint64(middle)])
    return least >= _MIDDLE


@njit(cache=True, nogil=True, error_model="numpy")
def _take_shares(cell, kind, ground, scale, grid):
    """Take a grain's parcels; the cell gives what others have not. False: it cannot, nothing changed."""
    row, col = cell // grid.cols, cell % grid.cols
    rest = PATCH
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        other = r * grid.cols + c
        if other != cell:
            rest -= min(_share(k), available(ground.mixture, ground.sand, kind, other))
    if available(ground.mixture, ground.sand, kind, cell) < rest:
        return False
    pile_up(cell, -rest, ground, scale)
    take(ground.mixture, cell, kind, rest)
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        other = r * grid.cols + c
        if other != cell:
            parcels = min(_share(k), available(ground.mixture, ground.sand, kind, other))
            pile_up(other, -parcels, ground, scale)
            take(ground.mixture, other, kind, parcels)
    return True


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _lay_patch(cell, kind, ground, scale, grid):
    """The same as ``_lay_shares``; the usual case needs no call, which hands over the whole ground."""
    row, col = cell // grid.cols, cell % grid.cols
    note_stale(row, 1, 1, ground, grid)
    if _is_plain(ground.mixture, row, col, grid):
        _lay_row(cell - grid.cols - 1, 1, 2, ground, scale)
        _lay_row(cell - 1, 2, _MIDDLE, ground, scale)
        _lay_row(cell + grid.cols - 1, 1, 2, ground, scale)
    else:
        _lay_shares(cell, kind, ground, scale, grid)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _take_patch(cell, kind, ground, scale, grid):
    """The same as ``_take_shares``, made part of the caller too."""
    row, col = cell // grid.cols, cell % grid.cols
    note_stale(row, 1, 1, ground, grid)
    if _is_plain(ground.mixture, row, col, grid) and _is_deep(cell, ground.sand, grid):
        _lay_row(cell - grid.cols - 1, -1, -2, ground, scale)
        _lay_row(cell - 1, -2, -_MIDDLE, ground, scale)
        _lay_row(cell + grid.cols - 1, -1, -2, ground, scale)
        return True
    return _take_shares(cell, kind, ground, scale, grid)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def lay_down(cell, kind, ground, scale, grid):
    """Lay the sand of a grain of some size on a cell, or over it and its neighbours."""
    if scale.carried == 1:
        pile_up(cell, 1, ground, scale)
        put(ground.mixture, cell, kind, 1)
        note_stale(cell // grid.cols, 0, 0, ground, grid)
    else:
        _lay_patch(cell, kind, ground, scale, grid)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def take_up(cell, kind, ground, scale, grid):
    """Take the sand of a grain of some size from a cell, or from it and its neighbours; False: too little."""
    if scale.carried > 1:
        return _take_patch(cell, kind, ground, scale, grid)
    if available(ground.mixture, ground.sand, kind, cell) == 0:
        return False
    pile_up(cell, -1, ground, scale)
    take(ground.mixture, cell, kind, 1)
    note_stale(cell // grid.cols, 0, 0, ground, grid)
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def exchange(first, count, grains, ground, scale, grid, events, counts):
    """Lay down the sand of grains that came to rest and take that of those lifted, entry by entry.

    A cell that has too little left by then gives none, and the slot stays free.
    """
    grains, ground, events, counts = lent((grains, ground, events, counts))
    for k in range(first, first + count):
        rest, source = events.rest[k], events.source[k]
        if rest != NOWHERE:
            counts[TRAVEL_X] += events.way_x[k]
            counts[TRAVEL_Y] += events.way_y[k]
        if rest == OUT:
            counts[LEFT] += 1
            counts[COUNTS + kind_of(events.kind, k)] += 1
        elif rest != NOWHERE:
            counts[CAPPED] += events.capped[k]
            lay_down(rest, kind_of(events.kind, k), ground, scale, grid)
        if source != NOWHERE:
            if take_up(source, kind_of(grains.kind, events.slot[k]), ground, scale, grid):
                counts[MOVED] += 1
            else:
                free_slot(events.slot[k], grains)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _mark_steps(mine, other, count, limit, level, steep):
    """Mark those of ``count`` cells in a row and of as many others that stand too high over one another."""
    here, there = level[mine : mine + count], level[other : other + count]
    marks, others = steep[mine : mine + count], steep[other : other + count]
    for k in range(count):
        marks[k] |= here[k] - there[k] > limit
    for k in range(count):
        others[k] |= here[k] - there[k] < -limit


@njit(cache=True, nogil=True, error_model="numpy")
def _find_steep(level, rows, cols, repose, grid, steep):
    """Mark the cells that stand too high over one of their eight neighbours."""
    steep[:] = 0
    for row in range(rows):
        for step_row, step_col in ((0, 1), (1, 0), (1, 1), (1, -1)):
            limit = repose.face_limit if step_row * step_col == 0 else repose.corner_limit
            other = row + step_row
            if other == rows:
                if not grid.wrap_across:
                    continue
                other = 0
            low = max(0, -step_col)
            high = cols - max(0, step_col)
            _mark_steps(row * cols + low, other * cols + low + step_col, high - low, limit, level, steep)
            if step_col and grid.wrap_along:
                col = cols - 1 if step_col > 0 else 0
                _mark_steps(row * cols + col, other * cols + cols - 1 - col, 1, limit, level, steep)


@njit(cache=True, nogil=True, error_model="numpy")
def _relax(ground, scale, sequences, key, grid, repose, queue, waiting, length):
    stacks, unstable = Stacks(ground.level, ground.sand, None, None), Unstable(queue, waiting)
    slid = relax_queue(stacks, sequences, unstable, length, key, grid, repose, ground.mixture)
    if slid > 0:
        renew_surface(ground, scale, grid)
    return slid


@njit(cache=True, nogil=True, error_model="numpy")
def settle_steep(ground, scale, sequences, key, grid, repose, queue, waiting):
    """Let every slope slide that is too steep, until all hold; how many parcels slid.

    ``queue`` and ``waiting`` (both over the cells) are work space; ``waiting`` is all zero before and after.
    """
    ground, sequences, queue, waiting = lent((ground, sequences, queue, waiting))
    _find_steep(ground.level, grid.rows, grid.cols, repose, grid, waiting)
    length = 0
    for cell in range(waiting.size):
        if waiting[cell]:
            queue[length] = cell
            waiting[cell] = CHECKED
            length += 1
    return _relax(ground, scale, sequences, key, grid, repose, queue, waiting, length)


@njit(cache=True, nogil=True, error_model="numpy")
def _upset_about(cell, grid, queue, waiting, length):
    unstable = Unstable(queue, waiting)
    length = enqueue(unstable, cell, CHECKED, 0, length)
    return enqueue_about(unstable, cell // grid.cols, cell % grid.cols, 0, 0, length, grid)


@njit(cache=True, nogil=True, error_model="numpy")
def settle_about(cell, other, ground, scale, sequences, key, grid, repose, queue, waiting):
    """The same where only one grain was taken from a cell and laid on another."""
    ground, sequences, queue, waiting = lent((ground, sequences, queue, waiting))
    length = 0
    for changed in (cell, other):
        length = _upset_about(changed, grid, queue, waiting, length)
        if scale.carried > 1:
            for k in range(8):
                r, c = neighbour(changed // grid.cols, changed % grid.cols, k, grid)
                length = _upset_about(r * grid.cols + c, grid, queue, waiting, length)
    return _relax(ground, scale, sequences, key, grid, repose, queue, waiting, length)


@njit(cache=True, nogil=True, error_model="numpy")
def renew_surface(ground, scale, grid):
    """Compute every stack's height (m, float32) from its level, and the mesh."""
    for cell in range(ground.level.size):
        ground.height[cell] = np.float32(ground.level[cell] * scale.part)
    renew_mesh(ground, grid)
