"""Collapse of slopes above the angle of repose: sand slides to the steepest neighbour until all hold."""

import numpy as np
from numba import njit

from barchan.kernels.bed.grid import neighbour
from barchan.kernels.bed.loose import join, part_loose
from barchan.kernels.bed.relax import CHECKED, NO_END, enqueue, enqueue_about, relax_queue
from barchan.kernels.bed.state import Stacks
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal
from barchan.kernels.grains.bonds import loose_of
from barchan.kernels.grains.surface import renew_mesh


@internal(error_model="numpy", forceinline=True)
def _mark_steps(mine, other, count, limit, level, steep):
    """Mark the cells of two rows of ``count`` cells that stand too high over one another."""
    here, there = level[mine : mine + count], level[other : other + count]
    marks, others = steep[mine : mine + count], steep[other : other + count]
    for k in range(count):
        marks[k] |= here[k] - there[k] > limit
    for k in range(count):
        others[k] |= here[k] - there[k] < -limit


@internal(error_model="numpy")
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
                _mark_steps(row * cols + col, other * cols + cols - 1 - col, np.int64(1), limit, level, steep)


@internal(error_model="numpy")
def _relax(ground, slopes, key, length):
    loose, layer = loose_of(ground.bonds), ground.active_layer
    free = part_loose(loose, ground.sand)
    stacks = Stacks(ground.level, free, None, None, loose)
    grid, repose, orders, unstable = ground.grid, slopes.repose, slopes.orders, slopes.unstable
    progress = relax_queue(stacks, orders, unstable, (0, length, 0, 0), NO_END, key, grid, repose, layer)
    join(loose, free, ground.sand)
    slid = progress[3]
    if slid > 0:
        renew_surface(ground)
    return slid


@njit(cache=True, nogil=True, error_model="numpy")
def settle_steep(ground, slopes, key):
    """Let every slope slide that is too steep, until all hold; the number of parcels that slid."""
    ground, slopes = borrowed((ground, slopes))
    queue, waiting = slopes.unstable.queue, slopes.unstable.waiting
    _find_steep(ground.level, ground.grid.rows, ground.grid.cols, slopes.repose, ground.grid, waiting)
    length = np.int64(0)
    for cell in range(waiting.size):
        if waiting[cell]:
            queue[length] = cell
            waiting[cell] = CHECKED
            length += 1
    return _relax(ground, slopes, key, length)


@internal(error_model="numpy")
def _upset_about(cell, grid, slopes, length):
    """Put a cell and its neighbours into the queue of cells to be checked; the queue's length."""
    length = enqueue(slopes.unstable, cell, CHECKED, 0, length)
    return enqueue_about(slopes.unstable, cell // grid.cols, cell % grid.cols, 0, 0, length, grid)


@internal(error_model="numpy")
def settle_about(cell, other, ground, slopes, key):
    """Let slopes slide where only one grain was taken from a cell and laid on another."""
    ground, slopes = borrowed((ground, slopes))
    grid = ground.grid
    length = np.int64(0)
    for changed in (cell, other):
        length = _upset_about(changed, grid, slopes, length)
        if ground.scale.carried > 1:
            for k in range(8):
                r, c = neighbour(changed // grid.cols, changed % grid.cols, k, grid)
                length = _upset_about(r * grid.cols + c, grid, slopes, length)
    return _relax(ground, slopes, key, length)


@internal(error_model="numpy")
def renew_surface(ground):
    """Recompute every stack's height (m, float32) from its level, and the mesh."""
    for cell in range(ground.level.size):
        ground.height[cell] = np.float32(ground.level[cell] * ground.scale.part)
    renew_mesh(ground)
