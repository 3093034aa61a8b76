"""Which slopes stand: the steepest step to a neighbour, and the limits of bare and of stabilised cells."""

from typing import NamedTuple

import numpy as np

from barchan.kernels.bed.grid import beside
from barchan.kernels.bed.state import (
    BARRED,
    EAST,
    NORTH,
    NORTHEAST,
    NORTHWEST,
    SOUTH,
    SOUTHEAST,
    SOUTHWEST,
    STABLE,
    WEST,
)
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal


class StepLimit(NamedTuple):
    """Largest step of one kind that stands, of bare and of stabilised cells."""

    bare: int
    stabilised: int
    stabilised_below: int


@internal(forceinline=True)
def has_sand(surface, sand, cell):
    """Whether a cell holds a slab; over flat ground (``sand`` None) the surface counts the slabs."""
    if sand is None:
        return surface[cell] > 0
    return sand[cell] > 0


@internal(forceinline=True)
def _limit_of(mobility, cell, sign, limit):
    """The limit that the step's height is compared with once the steepest neighbour is known.

    For slabs that slide in (``sign`` 1) each neighbour's own limit was compared before.
    """
    if mobility is None:
        return limit.bare
    if sign > 0:
        return min(limit.bare, limit.stabilised)
    return limit.stabilised if mobility[cell] <= limit.stabilised_below else limit.bare


@internal(forceinline=True)
def _least(mobility, limit):
    """The least of the limits that a step may have."""
    if mobility is None:
        return limit.bare
    return min(limit.bare, limit.stabilised)


@internal(forceinline=True)
def _sorting_key(surface, sand, mobility, cell, here, sign, code, limit):
    """A number that sorts neighbours by their step from ``here`` and, at equal steps, by their order."""
    step = (np.int64(surface[cell]) - here) * sign
    if sand is not None:
        if sign > 0 and sand[cell] == 0:
            code = np.int64(BARRED)
    if mobility is not None:
        stabilised = mobility[cell] <= limit.stabilised_below
        if sign > 0 and step <= (limit.stabilised if stabilised else limit.bare):
            code = np.int64(BARRED)
    return (step << 6) + code


@internal(forceinline=True)
def _six_about(row, col, grid):
    """A hexagon and its six neighbours, pair by pair from east to west; itself for one that is missing."""
    odd = row & 1
    itself = np.uint64(row * grid.cols + col)
    if 0 < row < grid.rows - 1 and 0 < col < grid.cols - 1:
        to_east = np.uint64(odd)
        above, below = itself + np.uint64(grid.cols) + to_east, itself - np.uint64(grid.cols) + to_east
        one = np.uint64(1)
        return itself, itself + one, itself - one, above, above - one, below, below - one
    north, south, east, west = beside(row, col, grid)
    no_west = not odd and col == 0 and not grid.wrap_along
    no_east = odd and col + 1 == grid.cols and not grid.wrap_along
    left = col if odd else west
    right = east if odd else col
    e = np.uint64(row * grid.cols + east)
    w = np.uint64(row * grid.cols + west)
    ne = itself if north == row or no_east else np.uint64(north * grid.cols + right)
    nw = itself if north == row or no_west else np.uint64(north * grid.cols + left)
    se = itself if south == row or no_east else np.uint64(south * grid.cols + right)
    sw = itself if south == row or no_west else np.uint64(south * grid.cols + left)
    return itself, e, w, ne, nw, se, sw


@internal()
def _steepest_of_six(stacks, orders, order, row, col, here, sign, at_rest, grid, repose):
    """``steepest`` for a hexagon, whose six neighbours lie at one distance and have one limit."""
    stacks, orders = borrowed((stacks, orders))
    surface, sand, mobility = stacks.surface, stacks.sand, stacks.mobility
    rest = at_rest * repose.static_face
    limit = StepLimit(repose.face_limit + rest, repose.stabilised_face_limit + rest, repose.stabilised_below)
    itself, e, w, ne, nw, se, sw = _six_about(row, col, grid)
    highest = max(
        max((np.int64(surface[e]) - here) * sign, (np.int64(surface[w]) - here) * sign),
        max(
            max((np.int64(surface[ne]) - here) * sign, (np.int64(surface[nw]) - here) * sign),
            max((np.int64(surface[se]) - here) * sign, (np.int64(surface[sw]) - here) * sign),
        ),
    )
    if highest <= _least(mobility, limit):
        return np.int64(STABLE)
    best = max(
        max(
            _sorting_key(surface, sand, mobility, e, here, sign, orders[order, EAST], limit),
            _sorting_key(surface, sand, mobility, w, here, sign, orders[order, WEST], limit),
        ),
        max(
            max(
                _sorting_key(surface, sand, mobility, ne, here, sign, orders[order, NORTHEAST], limit),
                _sorting_key(surface, sand, mobility, nw, here, sign, orders[order, NORTHWEST], limit),
            ),
            max(
                _sorting_key(surface, sand, mobility, se, here, sign, orders[order, SOUTHEAST], limit),
                _sorting_key(surface, sand, mobility, sw, here, sign, orders[order, SOUTHWEST], limit),
            ),
        ),
    )
    return np.int64(best & 7 if (best >> 6) > _limit_of(mobility, itself, sign, limit) else STABLE)


@internal(forceinline=True)
def _corners_about(row, col, grid):
    """The corner neighbours of a square cell; itself for one beyond an open edge."""
    itself = np.uint64(row * grid.cols + col)
    north, south, east, west = beside(row, col, grid)
    n, s = np.uint64(north * grid.cols), np.uint64(south * grid.cols)
    e, w = np.uint64(east), np.uint64(west)
    no_north = row + 1 == grid.rows and not grid.wrap_across
    no_south = row == 0 and not grid.wrap_across
    no_east = col + 1 == grid.cols and not grid.wrap_along
    no_west = col == 0 and not grid.wrap_along
    ne = itself if no_north or no_east else n + e
    nw = itself if no_north or no_west else n + w
    se = itself if no_south or no_east else s + e
    sw = itself if no_south or no_west else s + w
    return ne, nw, se, sw


@internal(forceinline=True)
def steepest(stacks, orders, order, row, col, here, sign, at_rest, grid, repose):
    """Direction of the steepest step up (``sign`` 1) or down (-1) from ``here`` that does not stand.

    ``orders[order]`` holds the neighbours' codes; of equally steep ones the first in order is taken, a face
    before a corner. The higher cell's limit decides; sand ``at_rest`` has the static limit. Returns
    ``STABLE`` where every step stands.
    """
    if grid.hexagonal:
        return _steepest_of_six(stacks, orders, order, row, col, here, sign, at_rest, grid, repose)
    surface, sand, mobility = stacks.surface, stacks.sand, stacks.mobility
    face_rest = at_rest * repose.static_face
    corner_rest = at_rest * repose.static_corner
    face_step = StepLimit(
        repose.face_limit + face_rest, repose.stabilised_face_limit + face_rest, repose.stabilised_below
    )
    corner_step = StepLimit(
        repose.corner_limit + corner_rest,
        repose.stabilised_corner_limit + corner_rest,
        repose.stabilised_below,
    )
    here_cell = np.uint64(row * grid.cols + col)
    north, south, east, west = beside(row, col, grid)
    n, s, level = np.uint64(north * grid.cols), np.uint64(south * grid.cols), np.uint64(row * grid.cols)
    e, w, c = np.uint64(east), np.uint64(west), np.uint64(col)
    if not repose.corners:
        highest = max(
            max((np.int64(surface[n + c]) - here) * sign, (np.int64(surface[s + c]) - here) * sign),
            max((np.int64(surface[level + e]) - here) * sign, (np.int64(surface[level + w]) - here) * sign),
        )
        if highest <= _least(mobility, face_step):
            return STABLE
    face = max(
        max(
            _sorting_key(surface, sand, mobility, n + c, here, sign, orders[order, NORTH], face_step),
            _sorting_key(surface, sand, mobility, s + c, here, sign, orders[order, SOUTH], face_step),
        ),
        max(
            _sorting_key(surface, sand, mobility, level + e, here, sign, orders[order, EAST], face_step),
            _sorting_key(surface, sand, mobility, level + w, here, sign, orders[order, WEST], face_step),
        ),
    )
    steep = (face >> 6) > _limit_of(mobility, here_cell, sign, face_step)
    if not repose.corners:
        return face & 7 if steep else STABLE
    ne, nw, se, sw = _corners_about(row, col, grid)
    corner = max(
        max(
            _sorting_key(surface, sand, mobility, ne, here, sign, orders[order, NORTHEAST], corner_step),
            _sorting_key(surface, sand, mobility, nw, here, sign, orders[order, NORTHWEST], corner_step),
        ),
        max(
            _sorting_key(surface, sand, mobility, se, here, sign, orders[order, SOUTHEAST], corner_step),
            _sorting_key(surface, sand, mobility, sw, here, sign, orders[order, SOUTHWEST], corner_step),
        ),
    )
    if (corner >> 6) > _limit_of(mobility, here_cell, sign, corner_step):
        if not steep or (corner >> 6) * repose.corner_weight > (face >> 6):
            return corner & 7
    return face & 7 if steep else STABLE
