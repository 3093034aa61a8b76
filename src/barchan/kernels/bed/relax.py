"""Avalanches that go on until every slope stands, over the whole bed or from where something changed.

For initial surfaces, painted sand, changed limits and dying plants, and for sand that starts to slide at one
angle and comes to rest at another. The order of work is fixed; equally steep neighbours are checked in
orders that alternate without a pattern, so that a heap does not lean.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import slide
from barchan.kernels.bed.grid import neighbour
from barchan.kernels.bed.levels import move_level
from barchan.kernels.bed.slopes import has_sand, steepest
from barchan.kernels.bed.state import STABLE, Unstable
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import mix

CHECKED, MOVING = 1, 2
"""Why a cell waits to be looked at: a neighbour changed, or an avalanche moved its sand."""


@internal(forceinline=True)
def enqueue(unstable, cell, why, at, length):
    """Put a cell on the queue that starts ``at`` if the cell does not wait yet; the queue's new length."""
    if unstable.waiting[cell] == 0:
        unstable.queue[(at + length) % unstable.queue.size] = cell
        length += 1
    unstable.waiting[cell] = max(unstable.waiting[cell], why)
    return length


@internal()
def enqueue_about(unstable, row, col, first, at, length, grid):
    """Put the neighbours of a cell on the queue, from direction ``first`` on; the queue's new length."""
    unstable = borrowed(unstable)
    for k in range(8):
        r, c = neighbour(row, col, (first + k) & 7, grid)
        length = enqueue(unstable, r * grid.cols + c, CHECKED, at, length)
    return length


@internal(forceinline=True)
def _move_slab(surface, sand, levels, cell, lower, slab):
    """Move one slab of sand from a cell to a lower one."""
    here, there = np.int64(surface[cell]), np.int64(surface[lower])
    move_level(levels, here, here - slab)
    move_level(levels, there, there + slab)
    surface[cell] -= slab
    surface[lower] += slab
    if sand is not None:
        sand[cell] -= 1
        sand[lower] += 1


@internal()
def relax_queue(stacks, orders, unstable, length, key, grid, repose, mixture):
    """Let the first ``length`` cells of the queue slide, and all that they upset, until every slope stands.

    Sand at rest slides where a step exceeds the static limit, moving sand comes to rest at the repose limit.
    Slabs slide one at a time; ``orders`` are the orders in which neighbours are checked, one of which is
    drawn by ``key`` each time. Sand of several sizes takes its ``mixture`` along (None: uniform). Returns
    the number of slabs that slid.
    """
    never_inline()
    stacks, orders, unstable, mixture = borrowed((stacks, orders, unstable, mixture))
    at = 0
    moves = 0
    last_order = np.uint64(orders.shape[0] - 1)
    while length > 0:
        cell = unstable.queue[at]
        at = at + 1 if at + 1 < unstable.queue.size else 0
        length -= 1
        at_rest = unstable.waiting[cell] == CHECKED
        unstable.waiting[cell] = 0
        if not has_sand(stacks.surface, stacks.sand, cell):
            continue
        row = cell // grid.cols
        col = cell % grid.cols
        order = np.int64(mix(key + np.uint64(moves)) & last_order)
        here = np.int64(stacks.surface[cell])
        direction = steepest(stacks, orders, order, row, col, here, -1, at_rest, grid, repose)
        if direction == STABLE:
            continue
        r, c = neighbour(row, col, direction, grid)
        lower = r * grid.cols + c
        _move_slab(stacks.surface, stacks.sand, stacks.levels, cell, lower, repose.slab)
        slide(mixture, cell, lower, 1)
        moves += 1
        length = enqueue(unstable, lower, MOVING, at, length)
        length = enqueue_about(unstable, row, col, order, at, length, grid)
        length = enqueue(unstable, cell, MOVING, at, length)
    return moves


@njit(cache=True)
def relax_field(stacks, where, orders, grid, repose, mixture):
    """Let slopes that are too steep slide until all stand; returns the number of slabs that slid.

    Starts at the cells ``where`` (bool, flat) something changed and their neighbours and goes on wherever
    sand moves. Changes the stacks in place.
    """
    cells = grid.rows * grid.cols
    unstable = Unstable(np.zeros(cells, np.int64), np.zeros(cells, np.uint8))
    length = 0
    for cell in range(cells):
        if where[cell]:
            length = enqueue(unstable, cell, CHECKED, 0, length)
            length = enqueue_about(unstable, cell // grid.cols, cell % grid.cols, 0, 0, length, grid)
    return relax_queue(stacks, orders, unstable, length, np.uint64(0), grid, repose, mixture)
