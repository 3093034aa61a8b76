"""The lattice as kernels see it, and the eight neighbours of a cell."""

import numpy as np
from numba import njit

from barchan.kernels.bed.state import Grid

ROW_STEP = np.array([0, 1, 0, -1, 1, 1, -1, -1])

COL_STEP = np.array([1, 0, -1, 0, 1, -1, -1, 1])


@njit(cache=True)
def neighbour(row: int, col: int, direction: int, grid: Grid) -> tuple[int, int]:
    """Row and column of a neighbour; a cell beyond an open edge is the cell itself."""
    r = row + ROW_STEP[direction]
    c = col + COL_STEP[direction]
    if r < 0 or r >= grid.rows:
        if not grid.wrap_across:
            return row, col
        r = r + grid.rows if r < 0 else r - grid.rows
    if c < 0 or c >= grid.cols:
        if not grid.wrap_along:
            return row, col
        c = c + grid.cols if c < 0 else c - grid.cols
    return r, c
