"""Shadow lines of a wind that does not blow along the rows: where they cross the lattice."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.bed.state import Grid
from barchan.kernels.slabs.shadow_lines import RayShadow
from barchan.lattice import HEX_ROWS

_ROUNDING = 1e-9
"""Slack for crossings that lie on a cell but for rounding."""

_SIXTY = math.radians(60.0)


class _Crossings(NamedTuple):
    """Where a ray from a cell meets lines of cells upwind, and the first cell of the two that it passes."""

    distance: NDArray[np.floating]
    """Along the ray (cells)."""
    rows_away: NDArray[np.floating]
    """Rows from the sheltered cell to the crossing."""
    rows: NDArray[np.int64]
    cols: NDArray[np.int64]
    """Column by row parity of the sheltered cell (of squares there is one), and by crossing."""
    weights: NDArray[np.float64]
    """Share of the second cell in the height at the crossing."""
    second: tuple[int, int]


def ray_shadow(
    grid: Grid, angle: float, fall: float, start: float, width: int
) -> tuple[RayShadow, tuple[NDArray, ...]]:
    """The crossings of rays at an ``angle`` (rad) to the rows, and the arrays that hold them.

    Lines fall by ``fall`` units of height a cell from ``start`` cells behind the middle of what shelters;
    heights have ``width`` bytes.
    """
    found = _over_hexagons(grid, angle) if grid.hexagonal else _over_squares(grid, angle)
    rows, cols = found.rows, found.cols
    cells, inside = _cells_about(found, grid)
    if grid.wrap_across:
        rows = rows % grid.rows
    if grid.wrap_along:
        cols = cols % grid.cols
    falls = (found.distance - start) * fall
    away = np.ceil(np.abs(found.rows_away) - _ROUNDING)
    near = np.searchsorted(away, np.arange(grid.rows), side="right").astype(np.int64)
    memory = rows, found.weights, falls, near, np.ascontiguousarray(cols), cells, inside
    ray = RayShadow(
        rows=memory[0].ctypes.data,
        weights=memory[1].ctypes.data,
        falls=memory[2].ctypes.data,
        near=memory[3].ctypes.data,
        rises=angle < 0.0,
        size=falls.size,
        width=width,
        cells=cells.ctypes.data,
        inside=inside.ctypes.data,
        cols=memory[4].ctypes.data,
        next_row=found.second[0],
        next_col=found.second[1],
    )
    return ray, memory


def _cells_about(found: _Crossings, grid: Grid) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The two cells about each crossing, and how many crossings lie in the field's columns.

    Cells are flat, relative to the sheltered one, by the parity of its row; the number is by its column.
    """
    odd = (np.arange(len(found.cols))[:, np.newaxis] + found.rows) & 1 & grid.hexagonal
    beside = found.weights > 0.0
    rows = np.stack([found.rows, found.rows + beside * found.second[0]], axis=-1)
    cols = np.stack([found.cols, found.cols + beside * (found.second[1] + (odd & found.second[0]))], axis=-1)
    west = np.maximum.accumulate(-cols.min(axis=(0, 2)))
    east = np.maximum.accumulate(cols.max(axis=(0, 2)))
    col = np.arange(grid.cols)
    inside = np.minimum(
        np.searchsorted(west, col, "right"), np.searchsorted(east, grid.cols - 1 - col, "right")
    )
    return np.ascontiguousarray(rows * grid.cols + cols), inside.astype(np.int64)


def _over_squares(grid: Grid, angle: float) -> _Crossings:
    """Crossings of every column upwind, between two cells of it."""
    columns = np.arange(1, grid.cols + 1)
    offset = -columns * math.tan(angle)
    lower = np.floor(offset + _ROUNDING)
    weights = np.maximum(offset - lower, 0.0)
    rows = lower.astype(np.int64)
    return _Crossings(columns / math.cos(angle), offset, rows, -columns[np.newaxis], weights, (1, 0))


def _over_hexagons(grid: Grid, angle: float) -> _Crossings:
    """Crossings of every line upwind, of the lattice's three kinds of lines those most across the ray.

    Steps on the lattice are ``q`` along the rows and ``r`` at 60 degrees to them.
    """
    if abs(angle) <= _SIXTY + _ROUNDING:
        spacing = 1.0 / (math.cos(angle) + abs(math.sin(angle)) / math.sqrt(3.0))
    else:
        spacing = HEX_ROWS / abs(math.sin(angle))
    steep = abs(angle) > math.pi / 4
    around = grid.rows * HEX_ROWS / abs(math.sin(angle)) if steep else grid.cols / math.cos(angle)
    line = np.arange(1, math.ceil(around / spacing - _ROUNDING) + 1)
    distance = line * spacing
    r = -distance * math.sin(angle) / HEX_ROWS
    q = -distance * math.cos(angle) - r / 2
    if abs(angle) > _SIXTY + _ROUNDING:
        first, second = (np.floor(q + _ROUNDING), np.rint(r)), (0, 1)
        weights = q - first[0]
    else:
        lower = np.floor(r + _ROUNDING)
        first = (-line - lower if angle > 0.0 else -line.astype(float)), lower
        second = (1, -1) if angle > 0.0 else (1, 0)
        weights = r - lower
    rows, along = first[1].astype(np.int64), first[0].astype(np.int64)
    cols = np.stack([along + (rows >> 1), along + ((rows + 1) >> 1)])
    return _Crossings(distance, r, rows, cols, np.where(weights < _ROUNDING, 0.0, weights), second)
