"""Avalanches that go on until every slope holds, over the whole bed or from where something changed.

For initial surfaces, painted sand, changed limits and dying plants, and for sand that lets go above one
angle and comes to rest at another. The order of work is fixed; equally steep neighbours are checked in
sequences that alternate without a pattern, so that a heap does not lean.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import slide
from barchan.kernels.bed.grid import neighbour
from barchan.kernels.bed.levels import move_level
from barchan.kernels.bed.slopes import has_sand, steepest
from barchan.kernels.bed.state import STABLE
from barchan.kernels.core.random import mix

CHECKED, MOVING = 1, 2
"""Why a cell waits to be looked at: a neighbour changed, or an avalanche moved its sand."""


@njit(cache=True)
def upset(cell, why, queue, waiting, at, length):
    """Put a cell on the queue of those that wait, if it does not wait yet; the queue's new length."""
    if waiting[cell] == 0:
        queue[(at + length) % queue.size] = cell
        length += 1
    waiting[cell] = max(waiting[cell], why)
    return length


@njit(cache=True)
def let_go(
    surface, sand, mobility, levels, sequences, queue, waiting, length, key, grid, speedup, repose, mixture
):
    """Let the first ``length`` cells of the queue slide, and whatever that upsets, until all slopes hold.

    Sand at rest lets go above its limit and the release, sand that moves comes to rest at its limit.
    Slabs slide one at a time; ``sequences`` are the orders in which neighbours are checked, one of which is
    drawn by ``key`` each time. Sand of several sizes takes its ``mixture`` along (None: it is alike). Returns
    how many slabs slid.
    """
    at = 0
    moves = 0
    last_sequence = np.uint64(sequences.shape[0] - 1)
    while length > 0:
        cell = queue[at]
        at = at + 1 if at + 1 < queue.size else 0
        length -= 1
        at_rest = waiting[cell] == CHECKED
        waiting[cell] = 0
        if not has_sand(surface, sand, cell):
            continue
        row = cell // grid.cols
        col = cell % grid.cols
        turn = np.int64(mix(key + np.uint64(moves)) & last_sequence)
        here = np.int64(surface[cell])
        way = steepest(surface, None, mobility, sequences, turn, row, col, here, -1, at_rest, grid, repose)
        if way == STABLE:
            continue
        r, c = neighbour(row, col, way, grid)
        lower = r * grid.cols + c
        if speedup is not None:
            there = np.int64(surface[lower])
            move_level(levels, here, here - repose.slab, speedup)
            move_level(levels, there, there + repose.slab, speedup)
        surface[cell] -= repose.slab
        surface[lower] += repose.slab
        if sand is not None:
            sand[cell] -= 1
            sand[lower] += 1
        slide(mixture, cell, lower, 1)
        moves += 1
        length = upset(lower, MOVING, queue, waiting, at, length)
        for k in range(8):
            r, c = neighbour(row, col, (k + turn) & 7, grid)
            length = upset(r * grid.cols + c, CHECKED, queue, waiting, at, length)
        length = upset(cell, MOVING, queue, waiting, at, length)
    return moves


@njit(cache=True)
def settle_field(surface, sand, mobility, where, sequences, grid, repose, mixture):
    """Let slopes that are too steep slide until they hold; returns how many slabs slid.

    Starts at the cells ``where`` (bool, flat) something changed and their neighbours and goes on wherever
    sand moves. Changes the flat ``surface`` and ``sand`` (None over flat ground) in place.
    """
    cells = grid.rows * grid.cols
    queue = np.zeros(cells, np.int64)
    waiting = np.zeros(cells, np.uint8)
    length = 0
    for cell in range(cells):
        if where[cell]:
            length = upset(cell, CHECKED, queue, waiting, 0, length)
            for k in range(8):
                r, c = neighbour(cell // grid.cols, cell % grid.cols, k, grid)
                length = upset(r * grid.cols + c, CHECKED, queue, waiting, 0, length)
    key = np.uint64(0)
    return let_go(
        *(surface, sand, mobility, None, sequences, queue, waiting, length, key, grid, None, repose, mixture)
    )
