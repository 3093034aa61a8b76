"""The cells of exported fields: where they lie, how large they are, which edges are joined."""

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Self

import numpy as np
from numpy.typing import NDArray

from barchan.errors import ExportError
from barchan.ground.terrain import Georeference
from barchan.lattice import Lattice
from barchan.squares import Squares

SQUARE = 1e-9
"""Relative difference of a cell's sides that rounding explains."""

MOST_SQUARES = 4096
"""Squares along a side of the field, up to which a number of them is looked for that covers it."""


@dataclass(frozen=True)
class Grid:
    """Cells in rows from south to north and columns from west to east."""

    rows: int
    columns: int
    width: float
    """Side of a cell from west to east (m)."""
    height: float
    """Side of a cell from south to north (m)."""
    west: float
    """West edge of the field (m)."""
    south: float
    """South edge of the field (m)."""
    crs: str | None
    """Coordinate reference system, by its code where it has one; None for coordinates within the field."""
    wkt: str | None
    """The same as well-known text."""
    periodic: tuple[bool, bool]
    """Whether the field is periodic south to north and west to east."""
    closed: bool = False
    """Whether the first row and column stand once more at the end of periodic directions."""

    @classmethod
    def of(cls, lattice: Lattice, place: Georeference | None) -> Self:
        """The cells of a lattice at a place on Earth, or anywhere; of hexagons the squares over them."""
        west, south, crs, wkt = (
            (0.0, 0.0, None, None) if place is None else (place.west, place.south, place.crs, place.wkt)
        )
        side, rows = lattice.cell_size, Squares(lattice).lattice.rows
        height = lattice.height / rows if lattice.hexagonal else side
        return cls(rows, lattice.columns, side, height, west, south, crs, wkt, lattice.periodic)

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)."""
        return self.rows, self.columns

    @property
    def x(self) -> NDArray[np.float64]:
        """Eastings of the cells' centres (m)."""
        return self.west + (np.arange(self.columns, dtype=np.float64) + 0.5) * self.width

    @property
    def y(self) -> NDArray[np.float64]:
        """Northings of the cells' centres (m)."""
        return self.south + (np.arange(self.rows, dtype=np.float64) + 0.5) * self.height

    @property
    def north(self) -> float:
        """North edge of the field (m)."""
        return self.south + self.rows * self.height

    @property
    def cell_size(self) -> float:
        """Side of a cell (m); raises ExportError where cells are not square."""
        if abs(self.width / self.height - 1.0) > SQUARE:
            raise ExportError(
                f"the cells are {self.width:.6g} × {self.height:.6g} m; allowed here: square ones; "
                f"{self._squares_in_words()}"
            )
        return self.width

    def _squares_in_words(self) -> str:
        """How to get square cells, or what to write in their place where none fit into the field."""
        ratio = (self.columns * self.width) / (self.rows * self.height)
        whole = Fraction(ratio).limit_denominator(MOST_SQUARES)
        if abs(whole / ratio - 1.0) > SQUARE or whole.numerator > MOST_SQUARES:
            return (
                "no whole number of squares covers the field (a field of hexagons has no such side); "
                "export .tif or .nc, which keep both sides"
            )
        times = max(1, round(self.columns / whole.numerator))
        return f"for instance --cells {times * whole.numerator} {times * whole.denominator}"

    def with_cells(self, columns: int, rows: int) -> Self:
        """The same area in another number of cells."""
        width, height = self.columns * self.width / columns, self.rows * self.height / rows
        return replace(self, rows=rows, columns=columns, width=width, height=height)

    def close(self) -> Self:
        """One row and column more where the field is periodic; raises ExportError where it nowhere is."""
        if not any(self.periodic):
            raise ExportError(
                "--close repeats the first row and column of a periodic field; this one is open"
            )
        rows, columns = self.rows + self.periodic[0], self.columns + self.periodic[1]
        return replace(self, rows=rows, columns=columns, closed=True)
