"""Territories: strips of the field whose sand threads exchange side by side, with the bits of one thread.

Grains lay and take sand, and impacts throw out and push grains, one after the other in the order of entries.
Which of two came first can only be told where they reach a cell in common. So whoever has a territory goes
through all of them in order and does those that reach cells of it alone. One that reaches beyond is put off
until all territories are done, and so is each later one that reaches a cell which one put off may reach.
Those are done at the end, by one thread, in order: of any two that have a cell in common the earlier one is
done first.
"""

from typing import NamedTuple

import numpy as np

from barchan.kernels.bed.state import Grid
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal

LEAST_WIDTH = 64
"""Cells of a territory at least: some times as many as most impacts reach."""

ALONE = -1
"""In place of a territory's number: the whole field, by one thread."""

DEPOSIT, LIFT, IMPACT = range(3)
"""What an entry of ``Landings`` does with sand."""

KINDS = 3
"""Number of these."""

STEP_REACH = 1
"""Cells that a grain reaches which takes sand from a cell and its neighbours, or lays it there."""

_LOW_END, _HIGH_START, PUT_OFF = range(3)
"""Entries of a territory's ``marks``: from its low and its high bound on, the cells that those put off may
reach end, or begin, here; and how many are put off."""

_MARKS = 16


class Territories(NamedTuple):
    """The division of a field among threads, and what they note of it."""

    bounds: np.ndarray
    """Rows or columns at which territories begin, and where the last one ends."""
    by_columns: bool
    """Whether they are strips of columns, or of rows."""
    wraps: bool
    """Whether the last one joins the first."""
    reach: np.ndarray
    """How far an impact on each cell may reach (cells, uint8)."""
    tainted: np.ndarray
    """The last iteration, counted from the plan's first, in which one put off may reach a cell (int32)."""
    put_off: np.ndarray
    """Whether each kind of each entry was put off (uint8)."""
    marks: np.ndarray
    """Of each territory."""
    counts: np.ndarray
    """Counts of each territory, and of what was put off."""


def territories_of(grid: Grid, threads: int, slots: int, counts: int) -> Territories:
    """Divide a field across its longer side among threads, for some ``slots`` and entries of the counts.

    Impacts reach no further than grains that come to rest or are lifted; see ``find_reach``.
    """
    by_columns, cells = grid.cols >= grid.rows, grid.rows * grid.cols
    size, wraps = (grid.cols, grid.wrap_along) if by_columns else (grid.rows, grid.wrap_across)
    number = max(1, min(threads, size // LEAST_WIDTH))
    bounds = np.arange(number + 1) * size // number
    if not wraps:
        bounds[0], bounds[-1] = -cells, size + cells
    shared = number > 1
    return Territories(
        bounds=bounds,
        by_columns=by_columns,
        wraps=wraps,
        reach=np.full(cells if shared else 0, STEP_REACH, np.uint8),
        tainted=np.zeros(cells if shared else 0, np.int32),
        put_off=np.zeros(slots * KINDS if shared else 0, np.uint8),
        marks=np.zeros((number, _MARKS), np.int64),
        counts=np.zeros((number + 1, -(-counts // _MARKS) * _MARKS), np.int64),
    )


@internal(error_model="numpy", forceinline=True)
def forget_put_off(first, count, territories):
    """Prepare some entries for another iteration."""
    territories.put_off[first * KINDS : (first + count) * KINDS] = 0


@internal(error_model="numpy")
def enter(part, territories):
    """Prepare a territory for another iteration."""
    marks = territories.marks[part]
    marks[_LOW_END] = territories.bounds[part] - 1
    marks[_HIGH_START] = territories.bounds[part + 1]
    marks[PUT_OFF] = 0


@internal(error_model="numpy")
def _is_tainted(row, col, reach, stamp, grid, tainted):
    """Whether one put off may reach a cell up to ``reach`` cells from a cell."""
    never_inline()
    for r in range(row - reach, row + reach + 1):
        for c in range(col - reach, col + reach + 1):
            if tainted[(r % grid.rows) * grid.cols + c % grid.cols] == stamp:
                return True
    return False


@internal(error_model="numpy")
def _taint(row, col, reach, part, stamp, grid, territories):
    """Note that one put off may reach the cells of a territory up to ``reach`` cells from a cell."""
    low, high = territories.bounds[part], territories.bounds[part + 1]
    for r in range(row - reach, row + reach + 1):
        for c in range(col - reach, col + reach + 1):
            there_row, there_col = r % grid.rows, c % grid.cols
            if low <= (there_col if territories.by_columns else there_row) < high:
                territories.tainted[there_row * grid.cols + there_col] = stamp


@internal(error_model="numpy", forceinline=True)
def _mark(place, reach, part, territories):
    """Extend what is tainted from a territory's bounds on by cells about a ``place``, if they meet."""
    marks = territories.marks[part]
    low, high = marks[_LOW_END], marks[_HIGH_START]
    if place - reach <= low <= place + reach:
        marks[_LOW_END] = place + reach
    if place - reach <= high <= place + reach:
        marks[_HIGH_START] = place - reach


@internal(error_model="numpy")
def _put_off(entry, row, col, reach, part, stamp, grid, territories):
    """Put off what reaches beyond a territory, or what one put off may reach; ``entry`` numbers its kind."""
    never_inline()
    bounds, place = territories.bounds, col if territories.by_columns else row
    _taint(row, col, reach, part, stamp, grid, territories)
    _mark(place, reach, part, territories)
    if territories.wraps:
        _mark(place - bounds[-1], reach, part, territories)
        _mark(place + bounds[-1], reach, part, territories)
    if bounds[part] <= place < bounds[part + 1]:
        territories.put_off[entry] = 1
        territories.marks[part, PUT_OFF] += 1


@internal(error_model="numpy", forceinline=True)
def _meets(place, reach, low, high):
    return place + reach >= low and place - reach < high


@internal(error_model="numpy", forceinline=True)
def is_mine(entry, row, col, reach, part, stamp, grid, territories):
    """Whether what is done at a cell, up to ``reach`` cells from it, is now to be done by a ``part``.

    That is a territory, ``ALONE``, or as many as there are territories: then what was put off. ``entry`` is
    ``KINDS`` times the number of the landing and the kind of what it does; ``stamp`` is the number of the
    iteration.
    """
    bounds, number = territories.bounds, territories.bounds.size - 1
    if part == ALONE:
        return True
    if part == number:
        return territories.put_off[entry] != 0
    place = col if territories.by_columns else row
    low, high = bounds[part], bounds[part + 1]
    if low <= place - reach and place + reach < high:
        marks = territories.marks
        if marks[part, _LOW_END] < place - reach and place + reach < marks[part, _HIGH_START]:
            return True
        if not _is_tainted(row, col, reach, stamp, grid, territories.tainted):
            return True
    elif not _meets(place, reach, low, high):
        size = bounds[number]
        if not territories.wraps or not (
            _meets(place - size, reach, low, high) or _meets(place + size, reach, low, high)
        ):
            return False
    _put_off(entry, row, col, reach, part, stamp, grid, territories)
    return False
