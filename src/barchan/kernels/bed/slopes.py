"""Avalanches: sand that has become too steep slides down, slab by slab, until it rests.

Taking a slab from a cell lets a slab slide in from the steepest neighbour that now stands too high, and so
on up the slope; laying one down lets it slide to the steepest neighbour that lies too low, and so on down
(Werner 1995). Only the two ends of such a chain change, so a chain is a search for the cell that changes.
"""

from typing import NamedTuple

import numpy as np

from barchan.kernels.bed.grid import beside, neighbour
from barchan.kernels.bed.state import (
    BARRED,
    DOWNSLOPE,
    EAST,
    NORTH,
    NORTHEAST,
    NORTHWEST,
    SHUFFLED,
    SOUTH,
    SOUTHEAST,
    SOUTHWEST,
    STABLE,
    UPSLOPE,
    WEST,
)
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import GOLDEN, below, derive, high, mix


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
def steepest(stacks, orders, order, row, col, here, sign, at_rest, grid, repose):
    """Direction of the steepest step up (``sign`` 1) or down (-1) from ``here`` that does not stand.

    ``orders[order]`` holds the neighbours' codes; of equally steep ones the first in order is taken, a face
    before a corner. The higher cell's limit decides; sand ``at_rest`` has the static limit. Returns
    ``STABLE`` where every step stands.
    """
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
    n = np.uint64(north * grid.cols)
    s = np.uint64(south * grid.cols)
    level = np.uint64(row * grid.cols)
    e = np.uint64(east)
    w = np.uint64(west)
    c = np.uint64(col)
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
    itself = level + c
    no_north = row + 1 == grid.rows and not grid.wrap_across
    no_south = row == 0 and not grid.wrap_across
    no_east = col + 1 == grid.cols and not grid.wrap_along
    no_west = col == 0 and not grid.wrap_along
    ne = itself if no_north or no_east else n + e
    nw = itself if no_north or no_west else n + w
    se = itself if no_south or no_east else s + e
    sw = itself if no_south or no_west else s + w
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


@internal()
def shuffle_order(orders, order, key):
    """Put a random order into ``orders[SHUFFLED]``: faces among themselves, corners likewise."""
    never_inline()
    for first in range(0, 8, 4):
        for k in range(4):
            orders[SHUFFLED, first + k] = k
        for last in range(3, 0, -1):
            other = first + below(high(derive(key, first + last)), last + 1)
            mine = orders[SHUFFLED, first + last]
            orders[SHUFFLED, first + last] = orders[SHUFFLED, other]
            orders[SHUFFLED, other] = mine
        for k in range(first, first + 4):
            code = (7 - first - orders[SHUFFLED, k]) << 3 | k
            orders[SHUFFLED, k] = code if orders[order, k] >= 0 else BARRED


@internal(forceinline=True)
def next_on_slope(stacks, orders, order, row, col, state, sign, grid, repose):
    """One step towards the cell that changes height when a slab is taken (``sign`` 1) or laid down (-1).

    Goes to the steepest neighbour up or down the slope, unless every step stands. A random order is drawn
    when a slope does not stand, and the neighbours are compared again. Returns row, column, the order to
    compare neighbours in, the random state, and whether the search goes on.
    """
    plain = UPSLOPE if sign > 0 else DOWNSLOPE
    here = np.int64(stacks.surface[np.uint64(row * grid.cols + col)]) - sign * repose.slab
    direction = steepest(stacks, orders, order, row, col, here, sign, False, grid, repose)
    if direction == STABLE:
        return row, col, order, state, False
    if repose.random_order and order == plain:
        state += GOLDEN
        shuffle_order(orders, plain, mix(state))
        return row, col, SHUFFLED, state, True
    row, col = neighbour(row, col, direction, grid)
    return row, col, plain, state, True
