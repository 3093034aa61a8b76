"""The surface that grains meet: stacks stand at the corners of a mesh, and between four it is interpolated.

The mesh cell of a stack reaches from it to its neighbours in the east and north; places are counted from the
southwesternmost stack. At an open edge the last mesh cell goes on level. A bound and a mean for each mesh
cell let flight leave the interpolation to grains that are about to land.
"""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import lent

_QUARTER = np.float32(0.25)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def beyond(row, col, grid):
    """The next row to the north and column to the east; the same ones at an open edge."""
    north = row + 1
    if north == grid.rows:
        north = 0 if grid.wrap_across else row
    east = col + 1
    if east == grid.cols:
        east = 0 if grid.wrap_along else col
    return north, east


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def nearest_cell(x, y, grid):
    """The cell whose stack is nearest to a place."""
    row, col = np.int64(y), np.int64(x)
    north, east = beyond(row, col, grid)
    row = north if y - np.float32(row) >= np.float32(0.5) else row
    col = east if x - np.float32(col) >= np.float32(0.5) else col
    return row * grid.cols + col


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def surface_at(x, y, height, cell_size, grid):
    """Height (m) of the surface at a place, and its slopes eastwards and northwards."""
    row, col = np.int64(y), np.int64(x)
    north, east = beyond(row, col, grid)
    part_x, part_y = np.float64(x) - col, np.float64(y) - row
    sw, se = np.float64(height[row * grid.cols + col]), np.float64(height[row * grid.cols + east])
    nw, ne = np.float64(height[north * grid.cols + col]), np.float64(height[north * grid.cols + east])
    south_side = sw + part_x * (se - sw)
    north_side = nw + part_x * (ne - nw)
    slope_x = ((se - sw) * (1.0 - part_y) + (ne - nw) * part_y) / cell_size
    return south_side + part_y * (north_side - south_side), slope_x, (north_side - south_side) / cell_size


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def height_at(x, y, height, grid):
    """The height alone, by the same arithmetic as ``surface_at``."""
    row, col = np.int64(np.int32(y)), np.int64(np.int32(x))
    north, east = beyond(row, col, grid)
    part_x, part_y = np.float64(x) - col, np.float64(y) - row
    sw, se = np.float64(height[np.uint64(row * grid.cols + col)]), height[np.uint64(row * grid.cols + east)]
    nw, ne = (
        np.float64(height[np.uint64(north * grid.cols + col)]),
        height[np.uint64(north * grid.cols + east)],
    )
    south_side = sw + part_x * (np.float64(se) - sw)
    north_side = nw + part_x * (np.float64(ne) - nw)
    return south_side + part_y * (north_side - south_side)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _lifted(base, lift, cell):
    """The base of a mesh cell, lifted by plants, if there are any."""
    if lift is None:
        return base
    return base + lift[cell]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _renew(row, col, ground, grid):
    north, east = beyond(row, col, grid)
    sw, se = row * grid.cols + col, row * grid.cols + east
    nw, ne = north * grid.cols + col, north * grid.cols + east
    height, lid = ground.height, ground.lid
    ground.top[sw] = max(max(height[sw], height[se]), max(height[nw], height[ne]))
    mean = _QUARTER * ((lid[sw] + lid[se]) + (lid[nw] + lid[ne]))
    ground.base[sw] = _lifted(mean, ground.lift, sw)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _lift_span(base, first, count, lift):
    """Lift the bases of some mesh cells by plants, if there are any."""
    if lift is not None:
        part = lift[first : first + count]
        for k in range(count):
            base[k] += part[k]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _renew_span(south, north, count, ground):
    """The same of ``count`` mesh cells side by side, from the stack ``south`` and the one north of it on."""
    low, high = ground.height[south : south + count + 1], ground.height[north : north + count + 1]
    top = ground.top[south : south + count]
    for k in range(count):
        top[k] = max(max(low[k], low[k + 1]), max(high[k], high[k + 1]))
    low, high = ground.lid[south : south + count + 1], ground.lid[north : north + count + 1]
    base = ground.base[south : south + count]
    for k in range(count):
        base[k] = _QUARTER * ((low[k] + low[k + 1]) + (high[k] + high[k + 1]))
    _lift_span(base, south, count, ground.lift)


@njit(cache=True, nogil=True, error_model="numpy")
def _renew_row(row, ground, grid):
    last = grid.cols - 1
    north, _ = beyond(row, last, grid)
    _renew_span(row * grid.cols, north * grid.cols, last, ground)
    _renew(row, last, ground, grid)


@njit(cache=True, nogil=True, error_model="numpy")
def renew_mesh(ground, grid):
    """Compute bound and mean of every mesh cell."""
    for row in range(grid.rows):
        _renew_row(row, ground, grid)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def note_stale(row, before, after, ground, grid):
    """Note that stacks have changed from ``before`` rows south of a row to as many as ``after`` north of it.

    The row of mesh cells south of the first of them has corners there too.
    """
    for step in range(-before - 1, after + 1):
        r = row + step
        ground.stale[r + grid.rows if r < 0 else (r - grid.rows if r >= grid.rows else r)] = 1


@njit(cache=True, nogil=True, error_model="numpy")
def renew_stale(first, last, ground, grid):
    """Compute bound and mean of mesh cells anew in those rows, of some, of which stacks have changed."""
    ground = lent(ground)
    for row in range(first, last):
        if ground.stale[row]:
            ground.stale[row] = 0
            _renew_row(row, ground, grid)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def mesh_cell(x, y, cols):
    """The mesh cell that a place lies in."""
    return np.int32(y) * np.int32(cols) + np.int32(x)
