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
from numba import njit

from barchan.kernels.bed.state import Grid
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.grains.creep import FARTHEST, along_stress

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

_PUSH_REACH = 2
"""Cells that an impact reaches whose pushed grains the wind does not keep going."""

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

    Impacts reach no further than takes and deposits; see ``find_reach``.
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


class Ways(NamedTuple):
    """Work space in which it is found how far the wind keeps pushed grains going; by cell, 0 or 1 (uint8)."""

    across: np.ndarray
    """Whether a grain may go along a column: the stress there is more across rows than along them."""
    along: np.ndarray
    """Whether a grain may go along a row."""
    marks: np.ndarray
    before: np.ndarray
    course: np.ndarray
    """How far grains go from a cell (cells)."""


@internal(error_model="numpy")
def _find_ways(creep, ground, ways):
    """Find along which ways the wind keeps pushed grains going.

    Returns the least and the greatest step eastwards of any, then the same northwards.
    """
    west = east = south = north = 0.0
    for cell in range(ways.course.size):
        x, y = along_stress(creep, cell, ground)
        west, east, south, north = min(west, x), max(east, x), min(south, y), max(north, y)
        ways.across[cell] = abs(x) < abs(y)
        ways.along[cell] = abs(y) < abs(x)
    return -np.int64(west < 0.0), np.int64(east > 0.0), -np.int64(south < 0.0), np.int64(north > 0.0)


@internal(error_model="numpy", forceinline=True)
def _within(place, size, wraps):
    """A row or column up to one beyond the field, on it; -1 where there is none."""
    if 0 <= place < size:
        return place
    if not wraps:
        return -1
    return size - 1 if place < 0 else 0


@internal(error_model="numpy")
def _add_beside(there, step, wraps, may, here):
    """Mark the cells of a row from which a grain may go to a marked one of a row, a ``step`` eastwards."""
    cols = here.size
    first, last = max(0, -step), cols - max(0, step)
    part, may_part, other = here[first:last], may[first:last], there[first + step : last + step]
    for col in range(last - first):
        part[col] |= other[col] & may_part[col]
    if wraps and step != 0:
        col = 0 if step < 0 else cols - 1
        here[col] |= there[cols - 1 - col] & may[col]


@internal(error_model="numpy", forceinline=True)
def _row(values, row, grid):
    return values[row * grid.cols : (row + 1) * grid.cols]


@internal(error_model="numpy")
def _go_on(before, steps, windy, grid, ways, marks):
    """Mark cells that the wind takes pushed grains on from to a marked one ``before``; whether there are any.

    Their courses grow by a step.
    """
    west, east, south, north = steps
    found = np.uint8(0)
    for row in range(grid.rows):
        here, windy_here = _row(marks, row, grid), _row(windy, row, grid)
        here[:] = 0
        for step_y in range(south, north + 1):
            other = _within(row + step_y, grid.rows, grid.wrap_across)
            if other < 0:
                continue
            there = _row(before, other, grid)
            for step_x in range(west, east + 1):
                if step_x == 0 and step_y == 0:
                    continue
                may = windy_here
                if step_x == 0:
                    may = _row(ways.across, row, grid)
                elif step_y == 0:
                    may = _row(ways.along, row, grid)
                _add_beside(there, step_x, grid.wrap_along, may, here)
        for col in range(grid.cols):
            here[col] &= windy_here[col]
            ways.course[row * grid.cols + col] += here[col]
            found |= here[col]
    return found != 0


@internal(error_model="numpy")
def _find_courses(creep, ground, ways, windy):
    """How far (cells, up to ``FARTHEST``) the wind may keep a pushed grain going that is on a cell.

    Nowhere is taken to be sheltered, for shelter changes with each grain that is moved.
    """
    steps, weakest, ustar = _find_ways(creep, ground, ways), creep.threshold.min(), ground.bed_stress.ustar
    before, marks = ways.before, ways.marks
    for cell in range(windy.size):
        windy[cell] = before[cell] = ways.course[cell] = ustar[cell] > weakest
    for _ in range(FARTHEST - 1):
        if not _go_on(before, steps, windy, ground.grid, ways, marks):
            break
        before, marks = marks, before


@internal(error_model="numpy")
def _find_greatest_about(values, grid, greatest):
    """The greatest of the values on a cell and its neighbours, also over edges that do not join."""
    rows, cols = grid.rows, grid.cols
    for row in range(rows):
        south, north = (row - 1) % rows * cols, (row + 1) % rows * cols
        here = greatest[row * cols : (row + 1) * cols]
        below, own, above = values[south:], values[row * cols :], values[north:]
        for col in range(cols):
            here[col] = max(own[col], max(below[col], above[col]))
        west, first = here[cols - 1], here[0]
        for col in range(cols):
            east = here[col + 1] if col + 1 < cols else first
            west, here[col] = here[col], max(here[col], max(west, east))


@njit(cache=True, nogil=True, error_model="numpy")
def find_reach(creep, ground, ways, reach):
    """How far (cells) each impact may reach, into ``reach``. Nothing without ``creep``.

    What an impact throws out comes from the cell that it hits and its neighbours, what it pushes goes on from
    those.
    """
    if creep is None:
        return
    creep, ground, ways, reach = borrowed((creep, ground, ways, reach))
    _find_courses(creep, ground, ways, reach)
    _find_greatest_about(ways.course, ground.grid, reach)
    for cell in range(reach.size):
        reach[cell] += _PUSH_REACH


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
def is_mine(k, kind, row, col, reach, part, stamp, grid, territories):
    """Whether what an entry does at a cell, up to ``reach`` cells from it, is now to be done by a ``part``.

    That is a territory, ``ALONE``, or as many as there are territories: then what was put off. ``stamp`` is
    the number of the iteration.
    """
    bounds, number = territories.bounds, territories.bounds.size - 1
    if part == ALONE:
        return True
    if part == number:
        return territories.put_off[k * KINDS + kind] != 0
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
    _put_off(k * KINDS + kind, row, col, reach, part, stamp, grid, territories)
    return False
