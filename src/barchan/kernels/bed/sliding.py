"""Where a slab slides: to the steepest neighbour, or to one drawn so that slabs go straight down the slope.

Taking a slab from a cell lets a slab slide in from a neighbour that now stands too high, and so on up the
slope; laying one down lets it slide to a neighbour that lies too low, and so on down (Werner 1995). Only the
two ends of such a chain change, so a chain is a search for the cell that changes.
"""

import numpy as np

from barchan.kernels.bed.grid import neighbour
from barchan.kernels.bed.slopes import has_sand, steepest
from barchan.kernels.bed.state import BARRED, DOWNSLOPE, SHUFFLED, SIXFOLD, SLIDING, STABLE, UPSLOPE
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import GOLDEN, below, derive, high, mix


@internal()
def _shuffle_six(orders, order, key):
    """Put a random order of a hexagon's neighbours into ``orders[SHUFFLED]``."""
    never_inline()
    orders[SHUFFLED] = BARRED
    for k in range(6):
        orders[SHUFFLED, SIXFOLD[k]] = k
    for last in range(5, 0, -1):
        other = below(high(derive(key, last)), last + 1)
        mine = orders[SHUFFLED, SIXFOLD[last]]
        orders[SHUFFLED, SIXFOLD[last]] = orders[SHUFFLED, SIXFOLD[other]]
        orders[SHUFFLED, SIXFOLD[other]] = mine
    for k in range(6):
        code = (7 - orders[SHUFFLED, SIXFOLD[k]]) << 3 | SIXFOLD[k]
        orders[SHUFFLED, SIXFOLD[k]] = code if orders[order, SIXFOLD[k]] >= 0 else BARRED


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
def _held_by_plants(mobility, cell, step, limit, repose):
    """Whether a stabilised neighbour keeps its sand although that stands a step higher."""
    if mobility is None:
        return False
    return mobility[cell] <= repose.stabilised_below and step <= limit


@internal(error_model="numpy")
def _share(stacks, orders, order, row, col, direction, here, sign, grid, repose):
    """A neighbour's share among those to which a slab may slide: its step beyond one slab."""
    if orders[order, direction] < 0:
        return 0.0
    at_corner = direction >= 4 and not grid.hexagonal
    r, c = neighbour(row, col, direction, grid)
    cell = r * grid.cols + c
    step = (np.int64(stacks.surface[cell]) - here) * sign
    if sign > 0:
        limit = repose.stabilised_corner_limit if at_corner else repose.stabilised_face_limit
        if not has_sand(stacks.surface, stacks.sand, cell):
            return 0.0
        if _held_by_plants(stacks.mobility, cell, step, limit, repose):
            return 0.0
    return max(np.float64(step - repose.slab), 0.0) * (repose.corner_weight if at_corner else 1.0)


@internal(error_model="numpy")
def drawn_downslope(stacks, orders, order, row, col, here, sign, draw, grid, repose):
    """Direction in which a slab slides down from ``here``, or in from above, drawn by the steps.

    On a plane its mean is straight down the slope, for the steps to all neighbours that lie lower are the
    slope's parts along them. After a step of more than one slab a slab lies lower, so a chain ends.
    """
    never_inline()
    stacks, orders = borrowed((stacks, orders))
    total = 0.0
    for direction in range(8):
        total += _share(stacks, orders, order, row, col, direction, here, sign, grid, repose)
    left = np.float64(high(draw)) * 2.0**-32 * total
    chosen = np.int64(STABLE)
    for direction in range(8):
        share = _share(stacks, orders, order, row, col, direction, here, sign, grid, repose)
        if share > 0.0:
            chosen = np.int64(direction)
            left -= share
            if left < 0.0:
                break
    return chosen


@internal(forceinline=True)
def next_on_slope(stacks, orders, order, row, col, state, sign, grid, repose):
    """One step towards the cell that changes height when a slab is taken (``sign`` 1) or laid down (-1).

    Goes to the steepest neighbour up or down the slope, or to one drawn in proportion to the steps, unless
    every step stands. A random order is drawn when a slope does not stand, and the neighbours are compared
    again. Returns row, column, the order to compare neighbours in, the random state, and whether the search
    goes on.
    """
    plain = UPSLOPE if sign > 0 else DOWNSLOPE
    here = np.int64(stacks.surface[np.uint64(row * grid.cols + col)]) - sign * repose.slab
    direction = steepest(stacks, orders, order, row, col, here, sign, SLIDING, grid, repose)
    if direction == STABLE:
        return row, col, order, state, False
    if repose.downslope:
        state += GOLDEN
        direction = drawn_downslope(stacks, orders, plain, row, col, here, sign, mix(state), grid, repose)
    if repose.random_order and order == plain:
        state += GOLDEN
        if grid.hexagonal:
            _shuffle_six(orders, plain, mix(state))
        else:
            shuffle_order(orders, plain, mix(state))
        return row, col, SHUFFLED, state, True
    row, col = neighbour(row, col, direction, grid)
    return row, col, plain, state, True
