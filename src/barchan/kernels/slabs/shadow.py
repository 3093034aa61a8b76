"""The shadow zone: is a cell sheltered from the wind by anything upwind of it?

A cell lies in shadow when the line that falls from a higher cell upwind, at the shadow angle, passes
above its top. The kernels work in the wind's frame: the wind blows towards growing columns, within 45
degrees, and heights are whole numbers, so the answers are exact. Along a lattice axis the cells upwind
stand side by side in memory and are tested sixteen at a time; for an oblique wind the ray crosses each
column (of hexagons, each of the lattice's lines that lie most squarely across it) between two cells and the
height there is interpolated linearly between them. Where slabs have a place in their cell, the line from that
place meets the stacks as they are, cell by cell (``boxes``).
"""

import numpy as np
from numba import njit

from barchan.kernels.core.internal import internal
from barchan.kernels.core.simd import any_above, any_of_last_above, load_at
from barchan.kernels.core.state import SIMD_WIDTH
from barchan.kernels.slabs.boxes import in_box_shadow
from barchan.kernels.slabs.state import CELL, Rows, View

_BLOCK = np.int64(SIMD_WIDTH)


@internal(error_model="numpy")
def _across_edge(surface, row, col, here, count, grid, axis):
    """The test of ``count`` cells upwind where the field's upwind edge is among them."""
    stride = _BLOCK * axis.width
    for far in range(2 if grid.wrap_along else 1):
        start = grid.cols if far else col
        cells = min(count, grid.cols) - col if far else col
        distance = col if far else 0
        height = surface + (row * grid.cols + start - _BLOCK) * axis.width
        fall = axis.falls + (axis.size - distance - _BLOCK) * axis.width
        k = np.int64(0)
        while k < cells:
            if any_of_last_above(height, fall, here, cells - k):
                return True
            height -= stride
            fall -= stride
            k += _BLOCK
    return False


@internal(error_model="numpy")
def _in_axis_shadow(surface, row, col, here, peak, grid, axis):
    rise = ((peak - here) >> axis.shift) + 1
    count = min((((rise * axis.reach) >> 16) + _BLOCK) & -_BLOCK, axis.size)
    height = surface + (row * grid.cols + col - _BLOCK) * axis.width
    fall = axis.falls + (axis.size - _BLOCK) * axis.width
    stride = _BLOCK * axis.width
    if count > col:
        return _across_edge(surface, row, col, here, count, grid, axis)
    k = np.int64(0)
    while k < count:
        if any_above(height, fall, here):
            return True
        height -= stride
        fall -= stride
        k += _BLOCK
    return False


@internal(forceinline=True)
def whole_view(surface, grid):
    """The heights of a surface (its address), all as they are now."""
    return View(surface, surface, Rows(0, grid.rows))


@internal(forceinline=True)
def is_near(row, near, grid):
    """Whether a row is among the near ones."""
    beyond = row - near.first
    beyond += grid.rows if beyond < 0 else 0
    return beyond < near.number


@internal(error_model="numpy", forceinline=True)
def _crossings_near(view, row, grid, ray):
    """How many crossings of a ray from a near row lie among the near rows."""
    near = view.near
    if near.number == grid.rows:
        return ray.size
    beside = row - near.first
    beside += grid.rows if beside < 0 else 0
    if ray.rises:
        beside = near.number - 1 - beside
    return load_at(ray.near + 8 * beside, np.int64(0))


@internal(error_model="numpy", forceinline=True)
def _crossed_squares(row, col, k, weight, grid, ray):
    """The two cells between which a ray crosses the column ``k + 1`` upwind; negative: it has left."""
    c = col - 1 - k
    if c < 0:
        if not grid.wrap_along:
            return -1, -1
        c += grid.cols
    lower = row + load_at(ray.rows + 8 * k, np.int64(0))
    upper = lower + 1
    if grid.wrap_across:
        lower -= grid.rows if lower >= grid.rows else 0
        upper -= grid.rows if upper >= grid.rows else 0
    elif lower < 0 or upper >= grid.rows:
        if weight > 0.0 or lower < 0 or lower >= grid.rows:
            return -1, -1
        upper = lower
    return lower * grid.cols + c, upper * grid.cols + c


@internal(error_model="numpy", forceinline=True)
def _hexagon_at(row, col, grid):
    """A cell by a row and column that may lie up to once around beyond the field; negative: outside."""
    if row < 0 or row >= grid.rows:
        if not grid.wrap_across:
            return -1
        row += grid.rows if row < 0 else -grid.rows
    if col < 0 or col >= grid.cols:
        if not grid.wrap_along:
            return -1
        col += grid.cols if col < 0 else -grid.cols
    return row * grid.cols + col


@internal(error_model="numpy", forceinline=True)
def _crossed_hexagons(row, col, k, weight, grid, ray):
    """The two cells between which a ray crosses the ``k + 1``-th line upwind; negative: it has left."""
    place = k + (ray.size if row & 1 else 0)
    first_row = row + load_at(ray.rows + 8 * k, np.int64(0))
    first_col = col + load_at(ray.cols + 8 * place, np.int64(0))
    first = _hexagon_at(first_row, first_col, grid)
    if weight == 0.0 or first < 0:
        return first, first
    second_col = first_col + ray.next_col + (first_row & 1 & ray.next_row)
    second = _hexagon_at(first_row + ray.next_row, second_col, grid)
    return (first, second) if second >= 0 else (second, second)


@internal(error_model="numpy", forceinline=True)
def _crossings_inside(row, col, grid, ray):
    """How many crossings of a ray lie inside the field, before any that lies beyond one of its edges."""
    to_edge = grid.rows - 1 - row if ray.rises else row
    across = load_at(ray.near + 8 * to_edge, np.int64(0))
    return min(across, load_at(ray.inside + 8 * col, np.int64(0)))


@internal(error_model="numpy", forceinline=True)
def _is_above(surface, lower, upper, weight, here, fall, width):
    """Whether the height between two cells exceeds ``here`` by more than the line has fallen."""
    below = load_at(surface + lower * width, here)
    above = load_at(surface + upper * width, here)
    return np.float64(below) + weight * np.float64(above - below) - np.float64(here) > fall


@internal(error_model="numpy")
def _in_ray_shadow(view, row, col, here, peak, grid, ray):
    rise = np.float64(peak - here)
    surface = view.now
    crossings_near = _crossings_near(view, row, grid, ray)
    crossings_inside = _crossings_inside(row, col, grid, ray)
    cell = row * grid.cols + col
    cells = ray.cells + (16 * ray.size if grid.hexagonal and row & 1 else 0)
    for k in range(ray.size):
        if k == crossings_near:
            surface = view.before
        fall = load_at(ray.falls + 8 * k, 0.0)
        if fall >= rise:
            return False
        weight = load_at(ray.weights + 8 * k, 0.0)
        if k < crossings_inside:
            lower = cell + load_at(cells + 16 * k, np.int64(0))
            upper = cell + load_at(cells + 16 * k + 8, np.int64(0))
        elif grid.hexagonal:
            lower, upper = _crossed_hexagons(row, col, k, weight, grid, ray)
        else:
            lower, upper = _crossed_squares(row, col, k, weight, grid, ray)
        if lower < 0:
            return False
        if _is_above(surface, lower, upper, weight, here, fall, ray.width):
            return True
    return False


@njit(cache=True, error_model="numpy")
def in_shadow(view, along, across, here, peak, grid, axis, ray, box):
    """Whether a place (fixed-point cells) on top of a stack of height ``here`` lies in shadow.

    ``here`` is of the surface's type. ``peak`` is a height that no cell exceeds: it bounds how far upwind the
    test looks. One of ``axis`` and ``ray`` is None. Only with a ``box`` it matters where in its cell the
    place lies.
    """
    shaded = False
    if box is not None:
        place = view, along, across, here, peak, grid
        shaded = in_box_shadow(box.squares, box.hexagons, box.tops, *place, box.width)
    else:
        row, col = across >> 32, along >> 32
        if axis is not None:
            shaded = peak > here and _in_axis_shadow(view.now, row, col, here, peak, grid, axis)
        if ray is not None:
            shaded = peak > here and _in_ray_shadow(view, row, col, here, peak, grid, ray)
    return shaded


@njit(cache=True, error_model="numpy")
def shadow_zone(surface, grid, axis, ray, box, zone):
    """Mark in ``zone`` (bool, flat) every cell of the bed whose middle lies in shadow."""
    peak = np.int64(surface.max())
    view = whole_view(surface.ctypes.data, grid)
    for row in range(grid.rows):
        for col in range(grid.cols):
            cell = row * grid.cols + col
            here = surface[cell]
            along, across = (col << 32) + CELL // 2, (row << 32) + CELL // 2
            zone[cell] = in_shadow(view, along, across, here, peak, grid, axis, ray, box)
