"""Obstacles along a hop: walls of ground, or also of sand as steep (Prague thesis, Alg. 7).

A wall is a cell that stands above the one the slab comes from by more than the repose limit. The surface
never lies below the ground, so ground that does not rise by that much above the *ground* before it is no
wall, however much sand comes and goes. How far the nearest such rise is from each cell is worked out once,
and most hops ask no more than that number.
"""

import numpy as np
from numba import njit

from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.simd import any_of_last_above, load_at
from barchan.kernels.core.state import SIMD_WIDTH
from barchan.kernels.slabs.hop import after_hop
from barchan.kernels.slabs.state import CELL

FARTHEST = 255
"""Cells on the way: what lies farther off is not told apart."""

_BLOCK = np.int64(SIMD_WIDTH)
_BYTE = np.uint8(0)


@njit(cache=True)
def _nearest_wall(ground, clear, nearest, row, col, next_row, next_col, limit, grid):
    """Cells that lie before the nearest wall on the way over a neighbour, if fewer than ``nearest``."""
    if next_col == grid.cols:
        if not grid.wrap_along:
            return nearest
        next_col = 0
    if next_row < 0 or next_row >= grid.rows:
        if not grid.wrap_across:
            return nearest
        next_row = grid.rows - 1 if next_row < 0 else 0
    there = next_row * grid.cols + next_col
    if ground[there] - ground[row * grid.cols + col] > limit:
        return 0
    return min(nearest, 1 + np.int64(clear[there]))


@njit(cache=True)
def _look_along(ground, clear, row, turn, grid, repose):
    """Find the nearest wall downwind of each cell of a row; whether any came nearer than was known."""
    nearer = False
    for lap in range(2 if grid.wrap_along else 1):
        for col in range(grid.cols - 1, -1, -1):
            cell = row * grid.cols + col
            known = np.int64(clear[cell])
            nearest = _nearest_wall(ground, clear, known, row, col, row, col + 1, repose.face_limit, grid)
            if turn != 0:
                side = row + turn
                nearest = _nearest_wall(ground, clear, nearest, row, col, side, col, repose.face_limit, grid)
                nearest = _nearest_wall(
                    ground, clear, nearest, row, col, side, col + 1, repose.corner_limit, grid
                )
            clear[cell] = nearest
            nearer |= nearest < known
            if lap == 1 and nearest == known:
                return nearer
    return nearer


@njit(cache=True)
def clear_distance(surface, sand, turn, grid, repose, clear):
    """Put into ``clear`` (uint8, flat) how many cells a slab may come over before ground could stop it.

    The wind blows along the rows (``turn`` 0), or also towards growing (1) or falling (-1) rows: then the
    number holds for every way of single steps along, across or both.
    """
    ground = surface.astype(np.int64)
    if sand is not None:
        ground -= sand * np.int64(repose.slab)
    clear[:] = FARTHEST
    for _ in range(2 if turn != 0 and grid.wrap_across else 1):
        nearer = False
        for k in range(grid.rows):
            row = k if turn < 0 else grid.rows - 1 - k
            nearer |= _look_along(ground, clear, row, turn, grid, repose)
        if not nearer:
            return


@njit(cache=True, error_model="numpy", forceinline=True)
def way_is_clear(heights, along, across, hop_along, hop_across, grid, rule):
    """Whether nothing can stand in the way of a hop; ``heights`` is the surface's address.

    False means that the way has to be looked at cell by cell.
    """
    if grid.hexagonal:
        return False
    row = across >> 32
    col = along >> 32
    cols = ((along + hop_along) >> 32) - col
    rows = ((across + hop_across) >> 32) - row
    cell = row * grid.cols + col
    if not rule.sand:
        place = rule.clear + cell
        if hop_along < 0:
            place = rule.clear_back + grid.rows * grid.cols - 1 - cell
        return abs(cols) + abs(rows) <= np.int64(load_at(place, _BYTE))
    if hop_along < 0 or hop_across != 0 or col + cols >= grid.cols:
        return False
    last = heights + (cell + cols) * rule.width
    while cols > 0:
        after = last - (_BLOCK - 1) * rule.width
        if any_of_last_above(after, after - rule.width, rule.limit, cols):
            return False
        last -= _BLOCK * rule.width
        cols -= _BLOCK
    return True


@njit(cache=True)
def _stands_in_the_way(surface, sand, cell, other, limit, slab, rule):
    """Whether what a slab over ``cell`` comes upon next is too high to pass."""
    top = np.int64(surface[other])
    if not rule.sand:
        top = np.int64(0)
        if sand is not None:
            top = np.int64(surface[other]) - np.int64(sand[other]) * slab
    return top - np.int64(surface[cell]) > limit


@njit(cache=True, error_model="numpy")
def hop_until_blocked(surface, sand, along, across, hop_along, hop_across, grid, repose, rule):
    """One hop, cell by cell, as far as nothing stands in its way.

    Returns the new position (negative where the slab has left), the distance flown, and whether the slab
    was stopped.
    """
    never_inline()
    pieces = (max(abs(hop_along), abs(hop_across)) + CELL - 1) >> 32
    piece_along = hop_along // pieces
    piece_across = hop_across // pieces
    a = along
    c = across
    flown_along = np.int64(0)
    flown_across = np.int64(0)
    for piece in range(1, pieces + 1):
        next_along = hop_along if piece == pieces else piece_along * piece
        next_across = hop_across if piece == pieces else piece_across * piece
        next_a, next_c = after_hop(along, across, next_along, next_across, grid)
        if next_a < 0 or next_c < 0:
            if piece < pieces:  # the way may cut the corner of an edge that is not straight
                continue
            return np.int64(-1), np.int64(-1), hop_along, hop_across, False
        cell = (c >> 32) * grid.cols + (a >> 32)
        other = (next_c >> 32) * grid.cols + (next_a >> 32)
        corner = c >> 32 != next_c >> 32 and a >> 32 != next_a >> 32
        limit = repose.corner_limit if corner else repose.face_limit
        if cell != other and _stands_in_the_way(surface, sand, cell, other, limit, repose.slab, rule):
            return a, c, flown_along, flown_across, True
        a = next_a
        c = next_c
        flown_along = next_along
        flown_across = next_across
    return a, c, flown_along, flown_across, False
