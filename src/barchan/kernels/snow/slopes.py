"""Slopes of snow: the higher cell's uppermost layer decides how steep a step may be."""

import numpy as np
from numba import njit

from barchan.kernels.bed.grid import neighbour
from barchan.kernels.bed.relax import CHECKED, enqueue, enqueue_about
from barchan.kernels.bed.state import BARRED, DOWNSLOPE, STABLE, UPSLOPE
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.snow.layers import pop, push, state_class


@internal(forceinline=True)
def _limit(pack, rules, cell):
    """Largest step (0.1 mm) down to a face neighbour at which a cell's uppermost layer stands."""
    return np.int64(rules.tables.face_limit[state_class(pack.top[cell], rules.epoch, rules.tables.age_class)])


@internal(forceinline=True)
def _beyond(pack, rules, cell, here, corner):
    """How far a neighbour's snow stands above ``here``, where it is too steep to stand; else 0."""
    step = np.int64(pack.surface[cell]) - here
    if step <= 0 or pack.quanta[cell] == 0:
        return np.int64(0)
    limit = _limit(pack, rules, cell)
    if corner:
        limit = np.int64(limit * rules.corner_factor)
    return step if step > limit else np.int64(0)


@internal()
def steepest_above(pack, rules, row, col):
    """Direction of the highest neighbour whose snow is too steep to stand above a cell; or ``STABLE``."""
    grid, orders = rules.slabs.grid, rules.slabs.orders
    here = np.int64(pack.surface[np.uint64(row * grid.cols + col)])
    best, weight = np.int64(-1), 0.0
    found = np.int64(STABLE)
    for first in range(0, 8, 4):
        for direction in range(first, first + 4):
            if orders[UPSLOPE, direction] == BARRED:
                continue
            r, c = neighbour(row, col, direction, grid)
            step = _beyond(pack, rules, np.uint64(r * grid.cols + c), here, first == 4)
            key = (step << 6) + orders[UPSLOPE, direction]
            share = 1.0 if first == 0 else 0.7071067811865476
            if step > 0 and (
                found == STABLE or ((key > best) if share == weight else step * share > (best >> 6) * weight)
            ):
                best, weight, found = key, share, direction
    return found


@internal()
def steepest_below(pack, rules, row, col, here, limit, order):
    """Direction of the lowest neighbour to which a step down from ``here`` exceeds the limit; or ``STABLE``."""
    grid, orders = rules.slabs.grid, rules.slabs.orders
    best, weight = np.int64(-1), 0.0
    found = np.int64(STABLE)
    for first in range(0, 8, 4):
        allowed = limit if first == 0 else np.int64(limit * rules.corner_factor)
        for place in range(4):
            direction = first + place
            if orders[DOWNSLOPE, direction] == BARRED:
                continue
            r, c = neighbour(row, col, direction, grid)
            step = here - np.int64(pack.surface[np.uint64(r * grid.cols + c)])
            if step <= allowed:
                continue
            rank = orders[DOWNSLOPE, direction] if order < 0 else ((place + order) & 3) << 3
            key = (step << 6) + rank
            share = 1.0 if first == 0 else 0.7071067811865476
            if found == STABLE or ((key > best) if share == weight else step * share > (best >> 6) * weight):
                best, weight, found = key, share, direction
    return found


@internal()
def feed(pack, rules, row, col):
    """Let the slope above a cell that was lowered slide in, quantum by quantum; what slides loses its age."""
    never_inline()
    grid, thickness = rules.slabs.grid, rules.tables.thickness
    direction = steepest_above(pack, rules, row, col)
    while direction != STABLE:
        r, c = neighbour(row, col, direction, grid)
        density = pop(pack, thickness, np.uint64(r * grid.cols + c))
        push(pack, thickness, np.uint64(row * grid.cols + col), rules.epoch, density)
        row, col = r, c
        direction = steepest_above(pack, rules, row, col)


@internal()
def lay_down(pack, rules, row, col, density):
    """Lay a quantum on a cell, from where it slides down the slope until it stands; the height reached."""
    grid, tables = rules.slabs.grid, rules.tables
    added = np.int64(tables.thickness[np.uint64(density >> 6)])
    loose = np.uint64((density >> 10) * (tables.face_limit.size // 64))
    limit = np.int64(tables.face_limit[loose])
    going = True
    while going:
        here = np.int64(pack.surface[np.uint64(row * grid.cols + col)]) + added
        direction = steepest_below(pack, rules, row, col, here, limit, -1)
        going = direction != STABLE
        if going:
            row, col = neighbour(row, col, direction, grid)
    cell = np.uint64(row * grid.cols + col)
    push(pack, tables.thickness, cell, rules.epoch, density)
    return np.int64(pack.surface[cell])


@njit(cache=True)
def relax_pack(pack, where, unstable, rules):
    """Let slopes slide, quantum by quantum, until all stand; returns the number of quanta that slid.

    Starts at the cells ``where`` (bool, flat) something changed and their neighbours.
    """
    grid, tables = rules.slabs.grid, rules.tables
    cells = grid.rows * grid.cols
    length = 0
    for cell in range(cells):
        if where[cell]:
            length = enqueue(unstable, cell, CHECKED, 0, length)
            length = enqueue_about(unstable, cell // grid.cols, cell % grid.cols, 0, 0, length, grid)
    at, moves = 0, 0
    while length > 0:
        cell = unstable.queue[at]
        at = at + 1 if at + 1 < unstable.queue.size else 0
        length -= 1
        unstable.waiting[cell] = 0
        if pack.quanta[cell] == 0:
            continue
        row, col = cell // grid.cols, cell % grid.cols
        here = np.int64(pack.surface[cell])
        limit = _limit(pack, rules, np.uint64(cell))
        direction = steepest_below(pack, rules, row, col, here, limit, (moves * 7) & 3)
        if direction == STABLE:
            continue
        r, c = neighbour(row, col, direction, grid)
        lower = r * grid.cols + c
        density = pop(pack, tables.thickness, np.uint64(cell))
        push(pack, tables.thickness, np.uint64(lower), rules.epoch, density)
        moves += 1
        length = enqueue(unstable, lower, CHECKED, at, length)
        length = enqueue_about(unstable, row, col, 0, at, length, grid)
        length = enqueue(unstable, cell, CHECKED, at, length)
    return moves
