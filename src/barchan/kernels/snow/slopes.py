"""Slopes of snow: the higher cell's uppermost layer decides how steep a step may be."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from barchan.kernels.bed.grid import beside, neighbour
from barchan.kernels.bed.relax import BATCH, CHECKED, enqueue, enqueue_about, enqueue_all
from barchan.kernels.bed.state import (
    BARRED,
    DOWNSLOPE,
    EAST,
    NORTH,
    SOUTH,
    STABLE,
    UPSLOPE,
    WEST,
    unstable_cells,
)
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.core.progress import report
from barchan.kernels.core.random import mix
from barchan.kernels.slabs.shadow import is_near
from barchan.kernels.slabs.state import STRAYED
from barchan.kernels.snow.layers import pop, push, state_class
from barchan.kernels.snow.state import Pack, SnowRules

_CORNER = 0.7071067811865476
"""Weight of a step to a corner when the steepest is chosen."""

_PLACES = np.uint64(3)


@internal(forceinline=True)
def _limit(pack, rules, cell):
    """Largest step (µm) down to a face neighbour at which a cell's uppermost layer stands."""
    return np.int64(rules.tables.face_limit[state_class(pack.top[cell], rules.epoch, rules.tables.age_class)])


@internal(forceinline=True)
def _faces(row, col, grid):
    """The cells that share a face with a cell, in the order of directions; beyond an open edge itself."""
    north, south, east, west = beside(row, col, grid)
    level = row * grid.cols
    return (
        np.uint64(level + east),
        np.uint64(north * grid.cols + col),
        np.uint64(level + west),
        np.uint64(south * grid.cols + col),
    )


@internal(forceinline=True)
def _slides(pack, rules, cell, step, corner):
    """Whether a cell's snow slides down a step: it holds some, and it is too steep to stand."""
    if step <= rules.gentlest or pack.quanta[cell] == 0:
        return False
    limit = _limit(pack, rules, cell)
    return step > (np.int64(limit * rules.corner_factor) if corner else limit)


@internal(forceinline=True)
def _sorted_above(pack, rules, cell, here, code):
    """A number that sorts a neighbour by its step above ``here`` and then by its order; -1: it stands."""
    step = np.int64(pack.surface[cell]) - here
    if code == BARRED or not _slides(pack, rules, cell, step, False):
        return np.int64(-1)
    return (step << 6) + code


@internal()
def _corner_above(pack, rules, row, col, here, face):
    """The steepest of a cell's corners whose snow slides, and of the ``face`` found already."""
    grid, orders = rules.slabs.grid, rules.slabs.orders
    best = np.int64(-1)
    for direction in range(4, 8):
        r, c = neighbour(row, col, direction, grid)
        cell = np.uint64(r * grid.cols + c)
        step = np.int64(pack.surface[cell]) - here
        if orders[UPSLOPE, direction] != BARRED and _slides(pack, rules, cell, step, True):
            best = max(best, (step << 6) + orders[UPSLOPE, direction])
    return best if best >= 0 and (face < 0 or (best >> 6) * _CORNER > (face >> 6)) else face


@internal(forceinline=True)
def steepest_above(pack, rules, row, col):
    """Direction of the highest neighbour whose snow is too steep to stand above a cell; or ``STABLE``."""
    orders = rules.slabs.orders
    here = np.int64(pack.surface[np.uint64(row * rules.slabs.grid.cols + col)])
    east, north, west, south = _faces(row, col, rules.slabs.grid)
    best = max(
        max(
            _sorted_above(pack, rules, east, here, orders[UPSLOPE, EAST]),
            _sorted_above(pack, rules, north, here, orders[UPSLOPE, NORTH]),
        ),
        max(
            _sorted_above(pack, rules, west, here, orders[UPSLOPE, WEST]),
            _sorted_above(pack, rules, south, here, orders[UPSLOPE, SOUTH]),
        ),
    )
    if rules.corner_factor > 0.0:
        best = _corner_above(pack, rules, row, col, here, best)
    return best & 7 if best >= 0 else np.int64(STABLE)


@internal()
def _corner_below(pack, rules, row, col, here, limit, face):
    """The steepest of the steps to a cell's corners that do not stand, and of the ``face`` found already."""
    grid, orders = rules.slabs.grid, rules.slabs.orders
    best = np.int64(-1)
    for direction in range(4, 8):
        r, c = neighbour(row, col, direction, grid)
        step = here - np.int64(pack.surface[np.uint64(r * grid.cols + c)])
        if orders[DOWNSLOPE, direction] != BARRED and step > np.int64(limit * rules.corner_factor):
            best = max(best, (step << 6) + orders[DOWNSLOPE, direction])
    return best if best >= 0 and (face < 0 or (best >> 6) * _CORNER > (face >> 6)) else face


@internal(forceinline=True)
def steepest_below(pack, rules, row, col, here, limit, turn):
    """Direction of the steepest step down from ``here`` that exceeds the limit; or ``STABLE``.

    Of equally steep ones the first in the wind's order is taken, which begins ``turn`` places later.
    """
    orders = rules.slabs.orders
    east, north, west, south = _faces(row, col, rules.slabs.grid)
    best = max(
        max(
            ((here - np.int64(pack.surface[east])) << 6) + (orders[DOWNSLOPE, EAST] ^ turn),
            ((here - np.int64(pack.surface[north])) << 6) + (orders[DOWNSLOPE, NORTH] ^ turn),
        ),
        max(
            ((here - np.int64(pack.surface[west])) << 6) + (orders[DOWNSLOPE, WEST] ^ turn),
            ((here - np.int64(pack.surface[south])) << 6) + (orders[DOWNSLOPE, SOUTH] ^ turn),
        ),
    )
    if (best >> 6) <= limit:
        best = np.int64(-1)
    if rules.corner_factor > 0.0:
        best = _corner_below(pack, rules, row, col, here, limit, best)
    return best & 7 if best >= 0 else np.int64(STABLE)


@internal()
def _slide_in(pack, rules, touched, row, col, direction):
    """Let quanta slide in from above, the first one from ``direction``, until the slope stands.

    Returns the greatest height that it leaves where it has laid any; or ``STRAYED``, before it changes a row
    that is not among those that may be ``touched``.
    """
    never_inline()
    pack, rules = borrowed((pack, rules))
    grid, thickness = rules.slabs.grid, rules.tables.thickness
    highest = np.int64(0)
    while direction != STABLE:
        r, c = neighbour(row, col, direction, grid)
        if not is_near(r, touched, grid):
            return np.int64(STRAYED)
        density = pop(pack, thickness, np.uint64(r * grid.cols + c))
        cell = np.uint64(row * grid.cols + col)
        push(pack, thickness, cell, rules.epoch, density)
        highest = max(highest, np.int64(pack.surface[cell]))
        row, col = r, c
        direction = steepest_above(pack, rules, row, col)
    return highest


@internal(forceinline=True)
def feed(pack, rules, touched, row, col):
    """Let the slope above a cell that was lowered slide in, quantum by quantum; what slides loses its age.

    Returns the greatest height where any came to lie (0: none did); or ``STRAYED``, as ``_slide_in``.
    """
    direction = steepest_above(pack, rules, row, col)
    if direction != STABLE:
        return _slide_in(pack, rules, touched, row, col, direction)
    return np.int64(0)


@internal(forceinline=True)
def lay_down(pack, rules, touched, row, col, density):
    """Lay a quantum on a cell, from where it slides down the slope until it stands; the height reached.

    Returns ``STRAYED`` instead, before it reads about a row that is not among those that may be ``touched``.
    """
    grid, tables = rules.slabs.grid, rules.tables
    added = np.int64(tables.thickness[np.uint64(density >> 6)])
    loose = np.uint64((density >> 10) * (tables.face_limit.size // 64))
    limit = np.int64(tables.face_limit[loose])
    going = True
    while going:
        here = np.int64(pack.surface[np.uint64(row * grid.cols + col)]) + added
        direction = steepest_below(pack, rules, row, col, here, limit, 0)
        going = direction != STABLE
        if going:
            row, col = neighbour(row, col, direction, grid)
            if not is_near(row, touched, grid):
                return np.int64(STRAYED)
    cell = np.uint64(row * grid.cols + col)
    push(pack, tables.thickness, cell, rules.epoch, density)
    return np.int64(pack.surface[cell])


@njit(cache=True, nogil=True)
def _relax_some(pack, unstable, progress, rules):
    """Let the cells of the queue slide; where it begins, its length and the slides after a batch."""
    grid, tables = rules.slabs.grid, rules.tables
    at, length, moves = progress
    end = moves + BATCH
    while length > 0 and moves < end:
        cell = unstable.queue[at]
        at = at + 1 if at + 1 < unstable.queue.size else 0
        length -= 1
        unstable.waiting[cell] = 0
        if pack.quanta[cell] == 0:
            continue
        row, col = cell // grid.cols, cell % grid.cols
        here = np.int64(pack.surface[cell])
        limit = _limit(pack, rules, np.uint64(cell))
        turn = np.int64(mix(np.uint64(moves)) & _PLACES) << 3
        direction = steepest_below(pack, rules, row, col, here, limit, turn)
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
    return at, length, moves


def relax_pack(pack: Pack, where: NDArray[np.bool_], rules: SnowRules) -> int:
    """Let slopes slide, quantum by quantum, until all stand; returns the number of quanta that slid.

    Starts at the cells ``where`` (bool, flat) something changed and their neighbours. After each batch of
    slides a signal can be handled, and whoever listens (``progress``) is told how far it is.
    """
    unstable = unstable_cells(where.size)
    progress = 0, enqueue_all(unstable, where, rules.slabs.grid), 0
    while progress[1] > 0:
        progress = _relax_some(pack, unstable, progress, rules)
        report(f"slopes relax: {progress[2]:,} quanta have slid, {progress[1]:,} cells still to be checked")
    return int(progress[2])
