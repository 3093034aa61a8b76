"""How far impacts may reach: what they throw out comes from nearby, what they push the wind may keep going.

That depends on the bed as it is when their turn comes. Known before is how far it can be at most: over cells
where the wind along the bed keeps grains going, in the directions of its stress, if nowhere is sheltered.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal
from barchan.kernels.grains.creep import FARTHEST, along_stress, place_beside

_PUSH_REACH = 2
"""Cells that an impact reaches whose pushed grains the wind does not keep going."""


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
            other, inside = place_beside(row, step_y, grid.rows, grid.wrap_across)
            if not inside:
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
