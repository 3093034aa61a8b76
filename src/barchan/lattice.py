"""The lattice: its size, the shape and width of a cell, the height of a slab, and its boundaries."""

import math
from typing import Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from barchan.parameters import Parameters, parameter

Boundary = Literal["periodic", "open"]


DEFAULT_ASPECT = 1 / 3


LEAST_ASPECT, LARGEST_ASPECT = 1e-4, 10.0


HEX_ROWS = math.sqrt(0.75)
"""Distance between two rows of hexagons, in widths of a cell; also the area of one in squared widths."""


class Lattice(Parameters):
    """The lattice: its size, the shape and width of a cell, the height of a slab, and its boundaries."""

    kind: Literal["square", "hex"] = parameter(
        "square",
        unit="-",
        meaning="Shape of the cells: squares, or hexagons with six neighbours at one distance, in rows of "
        "which every second is shifted east by half a cell (slab models alone); 'from ground' takes rows, "
        "columns and cell_size from the ground's file.",
        source="hex: ours",
    )
    rows: int = parameter(
        256,
        unit="cells",
        ge=1,
        le=65536,
        meaning="Cells from south to north.",
        source="Prague thesis, Table 6.1",
    )
    columns: int = parameter(
        256,
        unit="cells",
        ge=8,
        le=65536,
        meaning="Cells from west to east.",
        source="Prague thesis, Table 6.1",
    )
    cell_size: float = parameter(
        1.0,
        unit="m",
        ge=1e-4,
        le=1e6,
        scale="log",
        meaning="Width of a cell: side of a square, distance between two opposite sides of a hexagon.",
        source="Prague thesis, §4.3",
    )
    slab_aspect: float | None = parameter(
        None,
        unit="-",
        ge=LEAST_ASPECT,
        le=LARGEST_ASPECT,
        meaning="Height of a slab as a fraction of the cell's width; 1/3 where neither this nor "
        "slab_height is given.",
        source="Momiji et al. 2000; Prague thesis, §4.3",
    )
    slab_height: float | None = parameter(
        None, unit="m", gt=0, le=1e6, meaning="Height of a slab, instead of slab_aspect."
    )
    boundary_x: Boundary = parameter(
        "periodic", unit="-", meaning="West and east edges: joined, or open so that sand may leave."
    )
    boundary_y: Boundary = parameter(
        "periodic", unit="-", meaning="South and north edges: joined, or open so that sand may leave."
    )

    @model_validator(mode="after")
    def _one_height(self) -> Self:
        if self.slab_aspect is not None and self.slab_height is not None:
            raise ValueError(
                f"slab_aspect {self.slab_aspect} and slab_height {self.slab_height} m are both given; "
                "give one of them"
            )
        if not LEAST_ASPECT <= self.aspect <= LARGEST_ASPECT:
            raise ValueError(
                f"slab_height {self.slab_height} m is {self.aspect:g} of cell_size {self.cell_size} m; "
                f"allowed: {LEAST_ASPECT:g} to {LARGEST_ASPECT:g} of it"
            )
        return self

    @model_validator(mode="after")
    def _even_rows(self) -> Self:
        if self.hexagonal and self.rows % 2:
            raise ValueError(
                f"rows {self.rows} is odd; allowed with kind hex: even numbers of rows, "
                "for every second is shifted"
            )
        return self

    @property
    def hexagonal(self) -> bool:
        """Whether the cells are hexagons."""
        return self.kind == "hex"

    @property
    def row_spacing(self) -> float:
        """Distance (m) from the centre line of a row to that of the next."""
        return self.cell_size * (HEX_ROWS if self.hexagonal else 1.0)

    @property
    def cell_area(self) -> float:
        """Area of a cell (m²)."""
        return self.cell_size * self.row_spacing

    @property
    def width(self) -> float:
        """Length of the field from west to east (m)."""
        return self.columns * self.cell_size

    @property
    def height(self) -> float:
        """Length of the field from south to north (m)."""
        return self.rows * self.row_spacing

    @property
    def aspect(self) -> float:
        """Height of a slab over the width of a cell."""
        if self.slab_height is not None:
            return self.slab_height / self.cell_size
        return DEFAULT_ASPECT if self.slab_aspect is None else self.slab_aspect

    @property
    def thickness(self) -> float:
        """Height of a slab in metres."""
        return self.aspect * self.cell_size

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)."""
        return self.rows, self.columns

    @property
    def cells(self) -> int:
        """Number of cells."""
        return self.rows * self.columns

    @property
    def size_in_words(self) -> str:
        """Columns, rows, and width of the cells; of hexagons also the field's true size."""
        if self.hexagonal:
            size = f"{self.width:.4g} × {self.height:.4g} m"
            return f"{self.columns} × {self.rows} hexagons of {self.cell_size:g} m ({size})"
        return f"{self.columns} × {self.rows} cells of {self.cell_size:g} m"

    @property
    def periodic(self) -> tuple[bool, bool]:
        """Whether the field is periodic south to north and west to east."""
        return self.boundary_y == "periodic", self.boundary_x == "periodic"

    @property
    def x(self) -> NDArray[np.float64]:
        """Distance of the cells' centres from the west edge (m), in the first row and every second one."""
        return (np.arange(self.columns, dtype=np.float64) + 0.5) * self.cell_size

    @property
    def shift(self) -> NDArray[np.float64]:
        """How far each row is shifted east (m)."""
        shift = np.zeros(self.rows)
        if self.hexagonal:
            shift[1::2] = self.cell_size / 2
        return shift

    @property
    def centres(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Distances of all cells' centres from the west and the south edge (m), by row and column."""
        x, y = np.broadcast_arrays(self.x + self.shift[:, None], self.y[:, None])
        return x, y

    def __repr__(self) -> str:
        """Size, cells, slabs and edges."""
        edges = f"{self.boundary_x} west to east, {self.boundary_y} south to north"
        if self.boundary_x == self.boundary_y:
            edges = f"{self.boundary_x} edges"
        cells = "hexagons" if self.hexagonal else "cells"
        return (
            f"<Lattice of {self.rows} × {self.columns} {cells} of {self.cell_size:g} m, "
            f"slabs of {self.thickness:.4g} m, {edges}>"
        )

    @property
    def y(self) -> NDArray[np.float64]:
        """Distance of the cells' centres from the south edge (m)."""
        return (np.arange(self.rows, dtype=np.float64) + 0.5) * self.row_spacing
