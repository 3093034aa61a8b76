"""Full relaxation of a bed: slopes that no poll touches, brought to rest all at once.

For initial surfaces, painted sand, changed limits and dying plants. The order of work is fixed; slabs slide
one at a time, and equally steep neighbours are checked in sequences that alternate without a pattern, so
that a heap does not lean.
"""

import numpy as np
from numba import njit

from barchan.kernels.avalanche import (
    CLOSED,
    STABLE,
    has_sand,
    neighbour,
    steepest,
    turn_code,
)
from barchan.kernels.random import mix


def settling_turns(corners: bool) -> np.ndarray:
    """Eight checking sequences: from each of four directions, one way round and the other."""
    turns = np.full((8, 8), CLOSED, np.int64)
    for sequence in range(8):
        for place in range(4):
            way = (sequence + (place if sequence < 4 else -place)) % 4
            turns[sequence, way] = turn_code(way, place)
            if corners:
                turns[sequence, 4 + way] = turn_code(4 + way, 4 + place)
    return turns


@njit(cache=True)
def _ninth(cell, k, grid):
    """The ``k``-th of a cell's eight neighbours, or with ``k`` 8 the cell itself."""
    if k == 8:
        return cell
    row, col = neighbour(cell // grid.cols, cell % grid.cols, k, grid)
    return row * grid.cols + col


@njit(cache=True)
def settle_field(surface, sand, upset, turns, grid, repose):
    """Let slopes that are too steep slide until they hold; returns how many slabs slid.

    Starts at the cells that are ``upset`` (bool, flat) and their neighbours and goes on wherever sand
    moves. Changes the flat ``surface`` and ``sand`` (None over flat ground) in place.
    """
    cells = grid.rows * grid.cols
    queue = np.zeros(cells, np.int64)
    waiting = np.zeros(cells, np.bool_)
    at = 0
    length = 0
    for cell in range(cells):
        for k in range(9):
            if upset[cell]:
                other = _ninth(cell, k, grid)
                if not waiting[other]:
                    waiting[other] = True
                    queue[length] = other
                    length += 1
    moves = 0
    while length > 0:
        cell = queue[at]
        at = at + 1 if at + 1 < cells else 0
        length -= 1
        waiting[cell] = False
        row = cell // grid.cols
        col = cell % grid.cols
        if not has_sand(surface, sand, cell):
            continue
        here = np.int64(surface[cell])
        turn = np.int64(mix(np.uint64(moves)) & np.uint64(7))
        way = steepest(surface, None, turns, turn, row, col, here, -1, grid, repose)
        if way == STABLE:
            continue
        r, c = neighbour(row, col, way, grid)
        lower = r * grid.cols + c
        surface[cell] -= repose.slab
        surface[lower] += repose.slab
        if sand is not None:
            sand[cell] -= 1
            sand[lower] += 1
        moves += 1
        for k in range(9):
            other = _ninth(cell, (k + turn) & 7 if k < 8 else 8, grid)
            if not waiting[other]:
                waiting[other] = True
                queue[(at + length) % cells] = other
                length += 1
    return moves
