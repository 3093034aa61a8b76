"""The surface of a frame as a mesh: a vertex at each cell's centre, two triangles between four of them."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.errors import ExportError
from barchan.export.source import Source
from barchan.measures.filters import gradient

MOST_VERTICES = 50_000_000
"""Vertices of a mesh: some 2 GB of file."""


@dataclass(frozen=True)
class Surface:
    """A surface over rows and columns of points, z up, its origin at the field's south-west corner."""

    x: NDArray[np.float64]
    """Eastings of the columns, in units of the mesh."""
    y: NDArray[np.float64]
    """Northings of the rows."""
    z: NDArray[np.float64]
    """Heights by row and column."""
    periodic: tuple[bool, bool]
    closed: bool

    @property
    def vertices(self) -> NDArray[np.float32]:
        """(x, y, z) of all points, row by row from the south-west corner."""
        east, north = np.meshgrid(self.x, self.y)
        return np.stack([east, north, self.z], axis=-1).reshape(-1, 3).astype("<f4")

    @property
    def normals(self) -> NDArray[np.float32]:
        """Unit vectors upwards from the surface at all points."""
        z, closing = self.z, self.closed
        inside = tuple(slice(None, -1 if closing and joined else None) for joined in self.periodic)
        east, north = gradient(z[inside], 1.0, self.periodic)
        repeated = [(0, int(closing and joined)) for joined in self.periodic]
        spacing = self.x[1] - self.x[0], self.y[1] - self.y[0]
        rise_east, rise_north = (
            np.pad(slope, repeated, mode="wrap") / side
            for slope, side in zip((east, north), spacing, strict=True)
        )
        up = 1.0 / np.sqrt(1.0 + rise_east**2 + rise_north**2)
        return np.stack([-rise_east * up, -rise_north * up, up], axis=-1).reshape(-1, 3).astype("<f4")

    @property
    def quads(self) -> NDArray[np.uint32]:
        """Numbers of the four vertices of each square, counter-clockwise from above."""
        return quads(self.z.shape)

    @property
    def triangles(self) -> NDArray[np.uint32]:
        """Numbers of the three vertices of each triangle, counter-clockwise from above."""
        return triangles(self.quads)


def quads(shape: tuple[int, ...]) -> NDArray[np.uint32]:
    """Numbers of the four vertices of each square between points, counter-clockwise from above."""
    rows, columns = shape
    number = np.arange(rows * columns, dtype="<u4").reshape(rows, columns)
    corners = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    return np.stack(corners, axis=-1).reshape(-1, 4)


def triangles(squares: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Numbers of the three vertices of each triangle, two in each square."""
    return squares[:, (0, 1, 2, 0, 2, 3)].reshape(-1, 3)


@dataclass(frozen=True)
class Part:
    """A rectangle of a surface's points; neighbours share the points along their edge."""

    row: int
    """Number of the row of parts, from the south."""
    column: int
    """Number of the column of parts, from the west."""
    points: tuple[slice, slice]
    """Its rows and columns of points."""

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of points."""
        rows, columns = self.points
        return rows.stop - rows.start, columns.stop - columns.start

    @property
    def vertices(self) -> int:
        """The number of its points."""
        return self.shape[0] * self.shape[1]

    def of(self, values: NDArray, shape: tuple[int, int]) -> NDArray:
        """Its share of values, one row for each point of a surface of this shape."""
        return values.reshape(*shape, -1)[self.points].reshape(self.vertices, -1)


def parts_of(shape: tuple[int, int], most: int | None) -> list[Part]:
    """The parts of a surface with at most ``most`` points along a side; the whole where that is None."""
    rows, columns = ([slice(0, count)] if most is None else _pieces(count, most) for count in shape)
    return [Part(r, c, (row, column)) for r, row in enumerate(rows) for c, column in enumerate(columns)]


def _pieces(count: int, most: int) -> list[slice]:
    """Runs of at most ``most`` points, the last point of each being the first of the next."""
    number = max(1, -(-(count - 1) // (most - 1)))
    ends = [round(k * (count - 1) / number) for k in range(number + 1)]
    return [slice(first, last + 1) for first, last in pairwise(ends)]


def surface_of(source: Source, level: float | None = None) -> Surface:
    """The surface of the only frame of a source, heights exaggerated and lengths scaled as it asks for.

    Heights (m) above ``level`` are exaggerated, by default above the lowest point of the frame.
    Raises ExportError for a field of one row or column, and for one of more vertices than a mesh can have.
    """
    grid, options = source.grid, source.options
    if min(grid.shape) < 2:
        raise ExportError(
            f"a mesh needs two rows and columns; this field has {grid.rows} × {grid.columns} cells"
        )
    if grid.rows * grid.columns > MOST_VERTICES:
        raise ExportError(
            f"{grid.columns} × {grid.rows} cells make more vertices than a mesh should have "
            f"({MOST_VERTICES:,}); choose fewer --cells"
        )
    z = source.only(source.steps, ["elevation"]).sheet().values.astype(np.float64)
    level, factor = float(z.min()) if level is None else level, options.scale or 1.0
    z = (level + (z - level) * (options.exaggerate or 1.0)) * factor
    return Surface(
        (grid.x - grid.west) * factor, (grid.y - grid.south) * factor, z, grid.periodic, grid.closed
    )


def mesh_facts(source: Source, axes: str) -> dict[str, Any]:
    """What the side-car file says of a mesh."""
    grid, options = source.grid, source.options
    return {
        "mesh": {
            "axes": axes,
            "origin": {"easting_m": grid.west, "northing_m": grid.south, "elevation_m": 0.0},
            "metres_a_unit": 1.0 / (options.scale or 1.0),
            "exaggeration": options.exaggerate or 1.0,
        }
    }
