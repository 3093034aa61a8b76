"""The surface that grains meet: stacks stand at the corners of a mesh, and between four it is interpolated.

The mesh cell of a stack reaches from it to its neighbours in the east and north; places are counted from the
southwesternmost stack. At an open edge the last mesh cell goes on level. The top and the base of each mesh
cell let flight leave the interpolation to grains that are about to land.
"""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal

_QUARTER = np.float32(0.25)


@internal(error_model="numpy", forceinline=True)
def beyond(row, col, grid):
    """The next row to the north and column to the east; the same ones at an open edge."""
    north = row + 1
    if north == grid.rows:
        north = 0 if grid.wrap_across else row
    east = col + 1
    if east == grid.cols:
        east = 0 if grid.wrap_along else col
    return north, east


@internal(error_model="numpy", forceinline=True)
def nearest_stack(x, y, grid):
    """Row and column of the stack that is nearest to a place."""
    row, col = np.int64(y), np.int64(x)
    north, east = beyond(row, col, grid)
    row = north if y - np.float32(row) >= np.float32(0.5) else row
    col = east if x - np.float32(col) >= np.float32(0.5) else col
    return row, col


@internal(error_model="numpy", forceinline=True)
def nearest_cell(x, y, grid):
    """The cell whose stack is nearest to a place."""
    row, col = nearest_stack(x, y, grid)
    return row * grid.cols + col


@internal(error_model="numpy", forceinline=True)
def stack_at(cell, grid):
    """Row and column of a cell; by a short division, which takes half the time of a long one."""
    row = np.uint32(cell) // np.uint32(grid.cols)
    return np.int64(row), np.int64(cell) - np.int64(row) * grid.cols


@internal(error_model="numpy", forceinline=True)
def surface_at(x, y, ground):
    """Height (m) of the surface at a place, and its slopes eastwards and northwards."""
    height, grid, cell_size = ground.height, ground.grid, ground.scale.cell_size
    row, col = np.int64(y), np.int64(x)
    north, east = beyond(row, col, grid)
    part_x, part_y = np.float64(x) - col, np.float64(y) - row
    sw, se = np.float64(height[row * grid.cols + col]), np.float64(height[row * grid.cols + east])
    nw, ne = np.float64(height[north * grid.cols + col]), np.float64(height[north * grid.cols + east])
    south_side = sw + part_x * (se - sw)
    north_side = nw + part_x * (ne - nw)
    slope_x = ((se - sw) * (1.0 - part_y) + (ne - nw) * part_y) / cell_size
    return south_side + part_y * (north_side - south_side), slope_x, (north_side - south_side) / cell_size


@internal(error_model="numpy", forceinline=True)
def height_at(x, y, ground):
    """Height (m) of the surface at a place, by the same arithmetic as ``surface_at``."""
    height, grid = ground.height, ground.grid
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


@internal(error_model="numpy", forceinline=True)
def _displaced(base, canopy, cell):
    """Zero of the wind's height over a mesh cell, displaced by plants, if there are any."""
    if canopy is None:
        return base
    return base + canopy.displacement_height[cell]


@internal(error_model="numpy", forceinline=True)
def _renew(row, col, ground):
    """Recompute top and base of one mesh cell."""
    grid = ground.grid
    north, east = beyond(row, col, grid)
    sw, se = row * grid.cols + col, row * grid.cols + east
    nw, ne = north * grid.cols + col, north * grid.cols + east
    height, shelter = ground.height, ground.shelter_surface
    ground.top[sw] = max(max(height[sw], height[se]), max(height[nw], height[ne]))
    mean = _QUARTER * ((shelter[sw] + shelter[se]) + (shelter[nw] + shelter[ne]))
    ground.base[sw] = _displaced(mean, ground.canopy, sw)


@internal(error_model="numpy", forceinline=True)
def _displace_span(base, first, count, canopy):
    """Displace the bases of some mesh cells by plants, if there are any."""
    if canopy is not None:
        part = canopy.displacement_height[first : first + count]
        for k in range(count):
            base[k] += part[k]


@internal(error_model="numpy", forceinline=True)
def _renew_span(south, north, count, ground):
    """Recompute ``count`` mesh cells in a row; ``south`` and ``north`` are the stacks of the first one."""
    low, high = ground.height[south : south + count + 1], ground.height[north : north + count + 1]
    top = ground.top[south : south + count]
    for k in range(count):
        top[k] = max(max(low[k], low[k + 1]), max(high[k], high[k + 1]))
    shelter = ground.shelter_surface
    low, high = shelter[south : south + count + 1], shelter[north : north + count + 1]
    base = ground.base[south : south + count]
    for k in range(count):
        base[k] = _QUARTER * ((low[k] + low[k + 1]) + (high[k] + high[k + 1]))
    _displace_span(base, south, count, ground.canopy)


@internal(error_model="numpy")
def _renew_row(row, ground):
    grid = ground.grid
    last = grid.cols - 1
    north, _ = beyond(row, last, grid)
    _renew_span(row * grid.cols, north * grid.cols, last, ground)
    _renew(row, last, ground)


@njit(cache=True, nogil=True, error_model="numpy")
def renew_mesh(ground):
    """Compute top and base of every mesh cell."""
    for row in range(ground.grid.rows):
        _renew_row(row, ground)


@internal(error_model="numpy", forceinline=True)
def note_stale(row, before, after, ground):
    """Note that stacks have changed from ``before`` rows south of a row to ``after`` rows north of it.

    The row of mesh cells south of the first of them has corners there too.
    """
    grid = ground.grid
    for step in range(-before - 1, after + 1):
        r = row + step
        ground.stale[r + grid.rows if r < 0 else (r - grid.rows if r >= grid.rows else r)] = 1


@internal(error_model="numpy")
def renew_stale(first, last, ground):
    """Recompute top and base of mesh cells in the stale rows from ``first`` to before ``last``."""
    ground = borrowed(ground)
    for row in range(first, last):
        if ground.stale[row]:
            ground.stale[row] = 0
            _renew_row(row, ground)


@internal(error_model="numpy", forceinline=True)
def mesh_cell(x, y, cols):
    """The mesh cell that a place lies in."""
    return np.int32(y) * np.int32(cols) + np.int32(x)
