"""Heights from a file brought onto the lattice: holes, scale and size, never in silence."""

import math
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, ScenarioError
from barchan.ground.raster import Raster, UnreadableError, read
from barchan.lattice import Lattice
from barchan.parameters import Parameters, parameter


class FromFile(Parameters):
    """A file of heights, and how it is made to fit the lattice."""

    kind: str
    path: str = parameter(
        unit="-",
        meaning="The file: .npy (row 0 in the south), .png (greyscale), .tif or .tiff (GeoTIFF); in a "
        "scenario file, from where that file lies.",
    )
    lowest: float | None = parameter(
        None, unit="m", ge=-1e5, le=1e5, meaning="Height that black means, in an image."
    )
    highest: float | None = parameter(
        None, unit="m", ge=-1e5, le=1e5, meaning="Height that white means, in an image."
    )
    resample: bool = parameter(
        False,
        unit="-",
        meaning="Whether a file of another size is interpolated bilinearly: a GeoTIFF at its own scale from "
        "its south-west corner, others stretched over the field.",
    )
    fill: Literal["no", "interpolate"] = parameter(
        "no",
        unit="-",
        meaning="Whether cells without a value are refused, or filled smoothly from those around them.",
    )

    def heights(self, lattice: Lattice, group: str, least: float, most: float) -> NDArray[np.float64]:
        """The file's heights on the lattice, all of them from ``least`` to ``most``.

        Raises ScenarioError with every problem, under the keys of the scenario's ``group``.
        """
        try:
            raster = read(Path(self.path))
            heights = self._filled(self._scaled(raster), least, most)
            return self._fitted(heights, raster.cell_size, lattice)
        except UnreadableError as error:
            raise ScenarioError([Problem(f"{group}.path", f"'{self.path}': {error}")]) from None

    def _scaled(self, raster: Raster) -> NDArray[np.float64]:
        if raster.full_scale is None:
            return raster.heights
        if self.lowest is None or self.highest is None:
            raise UnreadableError("is an image: state lowest and highest, the heights of black and white")
        return self.lowest + (self.highest - self.lowest) * raster.heights / raster.full_scale

    def _filled(self, heights: NDArray[np.float64], least: float, most: float) -> NDArray[np.float64]:
        holes = np.isnan(heights)
        if holes.all():
            raise UnreadableError("has no cell with a value")
        low, high = heights[~holes].min(), heights[~holes].max()
        if low < least or high > most:
            raise UnreadableError(f"has values from {low:g} to {high:g}; allowed: {least:g} to {most:g}")
        if not holes.any():
            return heights
        if self.fill == "no":
            count = f"{holes.sum()} of {holes.size} cells without a value"
            raise UnreadableError(f"has {count}; allowed: none, or fill 'interpolate'")
        return filled(heights, holes)

    def _fitted(
        self, heights: NDArray[np.float64], cell: float | None, lattice: Lattice
    ) -> NDArray[np.float64]:
        rows, columns = heights.shape
        same = cell is None or math.isclose(cell, lattice.cell_size, rel_tol=1e-6)
        if self.resample:
            if cell is None:
                return bilinear(heights, rows / lattice.rows, columns / lattice.columns, lattice)
            step = lattice.cell_size / cell
            if lattice.rows * step > rows + 1e-6 or lattice.columns * step > columns + 1e-6:
                size = f"{columns * cell:g} × {rows * cell:g} m"
                field = f"{lattice.columns * step * cell:g} × {lattice.rows * step * cell:g} m"
                raise UnreadableError(f"covers {size}; allowed: at least the field, {field}")
            return bilinear(heights, step, step, lattice)
        if not same:
            raise UnreadableError(
                f"has cells of {cell:g} m; allowed: {lattice.cell_size:g} m as lattice.cell_size, "
                "or resample true"
            )
        if heights.shape != lattice.shape:
            raise UnreadableError(
                f"is {rows} rows of {columns} cells; allowed: the lattice's {lattice.rows} rows of "
                f"{lattice.columns} cells, or resample true"
            )
        return heights


def bilinear(
    heights: NDArray[np.float64], step_y: float, step_x: float, lattice: Lattice
) -> NDArray[np.float64]:
    """Heights at the centres of the lattice's cells, whose width is a number of the file's cells."""
    from scipy.ndimage import map_coordinates

    rows = (np.arange(lattice.rows) + 0.5) * step_y - 0.5
    columns = (np.arange(lattice.columns) + 0.5) * step_x - 0.5
    places = np.meshgrid(rows, columns, indexing="ij")
    return np.asarray(map_coordinates(heights, places, order=1, mode="nearest"))


def filled(heights: NDArray[np.float64], holes: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Each hole's cells set to the mean of their four neighbours: a membrane over the hole's rim."""
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import spsolve

    number = np.full(holes.shape, -1)
    number[holes] = np.arange(holes.sum())
    count = int(holes.sum())
    rows, cols, weights = [], [], []
    diagonal, known = np.zeros(count), np.zeros(count)
    for here, there in _neighbours():
        cell, neighbour = number[here], number[there]
        inner, rim = (cell >= 0) & (neighbour >= 0), (cell >= 0) & (neighbour < 0)
        np.add.at(diagonal, cell[cell >= 0], 1.0)
        np.add.at(known, cell[rim], heights[there][rim])
        rows.append(cell[inner])
        cols.append(neighbour[inner])
        weights.append(np.full(inner.sum(), -1.0))
    rows.append(np.arange(count))
    cols.append(np.arange(count))
    weights.append(diagonal)
    places = (np.concatenate(rows), np.concatenate(cols))
    matrix = coo_array((np.concatenate(weights), places), shape=(count, count)).tocsc()
    whole = heights.copy()
    whole[holes] = spsolve(matrix, known)
    return whole


def _neighbours() -> list[tuple[tuple[slice, slice], tuple[slice, slice]]]:
    """The cells of an array that have a neighbour on one side, and those neighbours, for each side."""
    every, first, last = slice(None), slice(None, -1), slice(1, None)
    return [
        ((first, every), (last, every)),
        ((last, every), (first, every)),
        ((every, first), (every, last)),
        ((every, last), (every, first)),
    ]
