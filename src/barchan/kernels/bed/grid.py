"""The lattice as kernels see it, and the eight neighbours of a cell."""

import numpy as np

from barchan.kernels.bed.state import Grid
from barchan.kernels.core.internal import internal

ROW_STEP = np.array([0, 1, 0, -1, 1, 1, -1, -1])

COL_STEP = np.array([1, 0, -1, 0, 1, -1, -1, 1])


@internal()
def neighbour(row: int, col: int, direction: int, grid: Grid) -> tuple[int, int]:
    """Row and column of a neighbour; a cell beyond an open edge is the cell itself.

    So is the one to the north or south of a hexagon, which has none there.
    """
    r = row + ROW_STEP[direction]
    c = col + COL_STEP[direction]
    if grid.hexagonal and r != row:
        if c == col:
            return row, col
        c += (row & 1) - (c > col)
    if r < 0 or r >= grid.rows:
        if not grid.wrap_across:
            return row, col
        r = r + grid.rows if r < 0 else r - grid.rows
    if c < 0 or c >= grid.cols:
        if not grid.wrap_along:
            return row, col
        c = c + grid.cols if c < 0 else c - grid.cols
    return r, c


@internal(forceinline=True)
def beside(row, col, grid):
    """Rows to the north and south of a cell, and columns to its east and west; its own at an open edge."""
    north = row + 1
    if north == grid.rows:
        north = 0 if grid.wrap_across else row
    south = row - 1
    if south < 0:
        south = grid.rows - 1 if grid.wrap_across else row
    east = col + 1
    if east == grid.cols:
        east = 0 if grid.wrap_along else col
    west = col - 1
    if west < 0:
        west = grid.cols - 1 if grid.wrap_along else col
    return north, south, east, west
