"""A surface to be measured: its heights and the cells that they stand on."""

import math
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import NDArray

from barchan.errors import SurveyError
from barchan.export.grid import Grid
from barchan.measures.crest_cells import local_mean

if TYPE_CHECKING:
    from barchan.analysis.declared_measures import Value

SQUARE = 0.01
"""Part by which a cell's sides may differ: lengths along crests are wrong by less than that."""

FEWEST = 8
"""Cells to a side of the smallest surface that is measured."""


@dataclass(frozen=True)
class HeightField:
    """Heights (m) of a surface, NaN where they are unknown, and where its cells lie.

    Raises SurveyError where it is too small, has no height, or its cells are far from squares.
    """

    heights: NDArray[np.float64]
    """By row and column, row 0 at the south edge, column 0 at the west edge."""
    grid: Grid
    name: str = "array"
    wind: float = math.nan
    """Direction (degrees clockwise from north) that the resultant wind comes from; NaN where unknown."""
    seconds: float = math.nan
    """Time (s) of a frame of a run since its start; NaN where unknown."""
    known: "tuple[Value, ...]" = field(default=(), repr=False)
    """Measures of a frame that its run alone can give."""

    def __post_init__(self) -> None:
        if self.heights.ndim != 2 or min(self.heights.shape) < FEWEST:
            raise SurveyError(
                f"{self.name}: a field of {self.heights.shape}; allowed: {FEWEST} or more rows and columns"
            )
        if not np.isfinite(self.heights).any():
            raise SurveyError(f"{self.name}: no cell has a height")
        if abs(self.grid.width / self.grid.height - 1.0) > SQUARE:
            raise SurveyError(
                f"{self.name}: cells of {self.grid.width:g} × {self.grid.height:g} m; allowed: square ones; "
                "bring the file onto square cells, for instance with rio warp FILE new.tif --res METRES"
            )

    @classmethod
    def of_array(
        cls, heights: Any, cell_size: float, periodic: tuple[bool, bool] = (False, False), name: str = "array"
    ) -> Self:
        """Heights (m), row 0 in the south, on cells of a size (m); raises SurveyError where they are none."""
        try:
            values = np.array(heights, np.float64)
        except (TypeError, ValueError):
            raise SurveyError(f"{name}: no array of numbers") from None
        if values.ndim != 2:
            raise SurveyError(f"{name}: an array of {values.ndim} dimensions; allowed: rows and columns")
        if not (math.isfinite(cell_size) and cell_size > 0):
            raise SurveyError(f"{name}: cells of {cell_size:g} m; allowed: above 0")
        values[np.isinf(values)] = np.nan
        rows, columns = values.shape
        grid = Grid(rows, columns, cell_size, cell_size, 0.0, 0.0, None, None, periodic)
        return cls(values, grid, name)

    @property
    def cell_size(self) -> float:
        """Side (m) of the square that has the area of a cell."""
        return math.sqrt(self.grid.width * self.grid.height)

    @property
    def periodic(self) -> tuple[bool, bool]:
        """Whether it is periodic south to north and west to east."""
        return self.grid.periodic

    def flattened(self, extent: float) -> Self:
        """Less the mean over squares of an ``extent`` (m): relief of the ground wider than the bedforms."""
        reach = extent / self.cell_size / 2
        if not reach >= 2.0:
            raise SurveyError(f"--flatten {extent:g} m; allowed: {4 * self.cell_size:g} m (4 cells) or more")
        return replace(self, heights=self.heights - local_mean(self.heights, reach, self.periodic))

    def place(self, rows: Any, columns: Any) -> tuple[Any, Any]:
        """Eastings and northings (m) of places in cells from the centre of the south-western cell."""
        return (
            self.grid.west + (np.asarray(columns) + 0.5) * self.grid.width,
            self.grid.south + (np.asarray(rows) + 0.5) * self.grid.height,
        )

    def spoken(self) -> str:
        """Size and place, for people to read."""
        rows, columns = self.heights.shape
        voids = int(np.isnan(self.heights).sum())
        text = f"{columns} × {rows} cells of {self.cell_size:.6g} m"
        text += f", {voids} of them without a height" if voids else ""
        return text + (f", {self.grid.crs}" if self.grid.crs else "")
