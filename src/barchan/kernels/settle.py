"""Full relaxation of a bed: slopes that no poll touches, brought to rest all at once.

For initial surfaces, painted sand, changed limits and dying plants. No randomness: the order of work is
fixed, and neighbours of equal steepness take turns so that a heap does not lean.
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


def settling_turns(corners: bool) -> np.ndarray:
    """Four checking sequences, each a quarter turn on from the one before."""
    turns = np.full((4, 8), CLOSED, np.int64)
    for start in range(4):
        for k in range(4):
            turns[start, (start + k) % 4] = turn_code((start + k) % 4, k)
            if corners:
                turns[start, 4 + (start + k) % 4] = turn_code(4 + (start + k) % 4, 4 + k)
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
        while has_sand(surface, sand, cell):
            here = np.int64(surface[cell])
            way = steepest(surface, None, turns, moves & 3, row, col, here, -1, grid, repose)
            if way == STABLE:
                break
            r, c = neighbour(row, col, way, grid)
            lower = r * grid.cols + c
            surface[cell] -= repose.slab
            surface[lower] += repose.slab
            if sand is not None:
                sand[cell] -= 1
                sand[lower] += 1
            moves += 1
            for k in range(9):
                other = _ninth(cell, k, grid) if k < 8 else lower
                if not waiting[other] and other != cell:
                    waiting[other] = True
                    queue[(at + length) % cells] = other
                    length += 1
    return moves
