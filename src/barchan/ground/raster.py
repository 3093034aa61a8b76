"""Heights as a file holds them, and where on Earth its cells lie.

Row 0 is the south edge and column 0 the west edge, however the file is written.
"""

import math
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from barchan.errors import BarchanError

SHEAR = 1e-3
"""Largest part of a cell by which rows or columns may lean over the whole raster."""


MOST_CELLS = 1 << 28
"""Cells of a file that are read: a small file may declare any number of them."""


class UnreadableError(BarchanError):
    """A file whose heights cannot be used, and why."""


def refuse_many_cells(rows: int, columns: int, most: int = MOST_CELLS) -> None:
    """Raise UnreadableError where a file declares more cells, or pixels, than are read."""
    if rows * columns > most:
        side = math.isqrt(most)
        raise UnreadableError(f"has {columns} × {rows} cells; allowed: as many as {side} × {side}")


@dataclass(frozen=True)
class Hints:
    """What a user says of a file that does not say it itself."""

    crs: str | None = None
    """Coordinate reference system, or ``metres`` for local coordinates."""
    variable: str | None = None
    """Name of the variable to read, in a NetCDF file."""


@dataclass(frozen=True)
class Place:
    """The south-west corner of a raster and the sides of its cells, in units of its coordinates."""

    west: float
    south: float
    width: float
    """Side of a cell from west to east."""
    height: float
    """Side of a cell from south to north."""
    crs: Any = None
    """Coordinate reference system (rasterio's ``CRS``); None where the file states none."""

    @property
    def cell_size(self) -> float:
        """Side of the square that has the area of a cell."""
        return math.sqrt(self.width * self.height)


@dataclass(frozen=True)
class Raster:
    """Numbers of a file, NaN where the file declares none, and how they give heights."""

    values: NDArray[Any]
    place: Place | None = None
    """None where the file has no coordinates."""
    full_scale: float | None = None
    """The value of white, in an image."""
    scale: float = 1.0
    """Metres that a number stands for, in an elevation model."""
    offset: float = 0.0
    """Height (m) that zero stands for."""
    unit: str | None = None
    """Unit of length that the file states for its numbers; None where it states none."""
    coloured: bool = False
    """Whether an image has colours, the luminance of which its numbers are."""


@dataclass(frozen=True)
class Outline:
    """What there is to know of a raster without its numbers; see ``Raster``."""

    shape: tuple[int, int]
    place: Place | None
    scale: float
    unit: str | None
    holes: int = 0
    """Cells without a value."""
    coloured: bool = False


def placed(
    values: NDArray[Any], transform: tuple[float, float, float, float, float, float], crs: Any
) -> tuple[NDArray[Any], Place]:
    """Values and place of a raster whose affine transform is (a, b, c, d, e, f), turned to our order.

    x = a·column + b·row + c, y = d·column + e·row + f, of a cell's outer corner. Raises UnreadableError where
    rows do not run from west to east, or columns not from south to north or back.
    """
    a, b, c, d, e, f = transform
    rows, columns = values.shape
    if abs(b) * rows > SHEAR * abs(a) or abs(d) * columns > SHEAR * abs(e):
        turned = math.degrees(math.atan2(d, a))
        raise UnreadableError(
            f"has cells that are no upright rectangles (rows turned by {turned:.3g}°); "
            "allowed: rows from west to east"
        )
    if e < 0:
        values, f = values[::-1], f + e * rows
    if a < 0:
        values, c = values[:, ::-1], c + a * columns
    return values, Place(c, f, abs(a), abs(e), crs)
