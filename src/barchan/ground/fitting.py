"""Heights from a file brought onto the lattice: holes, scale and size, never in silence."""

from functools import lru_cache
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, ScenarioError
from barchan.ground.raster import Hints, Outline, Place, Raster, UnreadableError
from barchan.ground.reading import read
from barchan.ground.reference import require_metres
from barchan.ground.resampling import resampled
from barchan.ground.voids import filled, suspects
from barchan.lattice import Lattice
from barchan.missing import Codes, marked, missing_key
from barchan.parameters import Parameters, parameter

TOLERANCE = 1e-3
"""Part by which a side of a file's cell may differ from the lattice's cell size."""

FARTHEST = 0.5
"""Cells by which that may shift the far edge of the field."""

ADVICE = "state missing [{codes}] if it is one (and fill 'interpolate'), missing [] if all are heights"


class FromFile(Parameters):
    """A file of heights, and how it is made to fit the lattice."""

    kind: str
    path: str = parameter(
        unit="-",
        meaning="The file: .npy (row 0 in the south), .png or .jpg (greys, or the luminance of colours), "
        ".tif or .tiff (GeoTIFF), .asc (ESRI ASCII grid), .xyz (points on a grid), .nc (NetCDF) or .hgt; in "
        "a scenario file, from where that file lies.",
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
        meaning="Whether a file of other cells is brought onto the lattice's: means over larger cells, "
        "linear between smaller ones; an elevation model at its own scale from its south-west corner, others "
        "stretched over the field.",
    )
    missing: Codes | None = missing_key(
        None,
        "Numbers",
        " where the file does not declare them; [] if all are heights. Without it, a number that looks like "
        "one is refused.",
    )
    fill: Literal["no", "interpolate"] = parameter(
        "no",
        unit="-",
        meaning="Whether cells without a value are refused, or filled smoothly from those around them.",
    )
    crs: str | None = parameter(
        None,
        unit="-",
        meaning="Coordinate reference system of an elevation model that states none, for instance "
        "EPSG:32633, or 'metres' for local coordinates.",
    )
    variable: str | None = parameter(
        None, unit="-", meaning="Name of the variable to read, in a NetCDF file of several."
    )

    def raster(self) -> Raster:
        """What the file holds; raises UnreadableError where its coordinates are no metres on the ground."""
        hints = Hints(self.crs, self.variable)
        raster = raster_in(Path(self.path), hints)
        if raster.place is not None:
            require_metres(raster.place, raster.values.shape, hints)
        return raster

    def outline(self) -> Outline:
        """Size, place and unit of what the file holds; raises as ``raster`` does."""
        path = Path(self.path)
        if not path.is_file():
            raise UnreadableError("no such file")
        return _outline(self, _stamps(path, path.with_suffix(".prj")))

    def heights(self, lattice: Lattice, group: str, least: float, most: float) -> NDArray[np.float64]:
        """The file's heights on the lattice, all of them from ``least`` to ``most``.

        Raises ScenarioError with every problem, under the keys of the scenario's ``group``.
        """
        try:
            raster = self.raster()
            heights = self._filled(self.scaled(raster, lattice.cell_size), least, most)
            return self._fitted(heights, raster.place, lattice)
        except UnreadableError as error:
            raise ScenarioError([Problem(f"{group}.path", f"'{self.path}': {error}")]) from None

    def scaled(self, raster: Raster, cell_size: float, advice: str = ADVICE) -> NDArray[np.float64]:
        """Heights (m), NaN where there is none; ``cell_size`` (m) counts where the raster has no cells.

        Raises UnreadableError for an image without heights, and for undeclared codes of missing cells with an
        ``advice`` in which {codes} are these.
        """
        values = raster.values.astype(np.float64)
        if raster.full_scale is not None:
            if self.lowest is None or self.highest is None:
                raise UnreadableError("is an image: state lowest and highest, the heights of black and white")
            return self.lowest + (self.highest - self.lowest) * values / raster.full_scale
        if self.missing is None:
            _refuse_suspects(doubtful(raster, cell_size), advice)
        values[self.holes(values)] = np.nan
        return values * raster.scale + raster.offset

    def holes(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which cells have no value, by the file or by ``missing``."""
        return np.isnan(values) | marked(values, self.missing or [])

    def fill_facts(self) -> str:
        """How many of the file's cells are filled from those around them; empty where none is."""
        try:
            file = self.outline()
        except UnreadableError:
            return ""
        rows, columns = file.shape
        if not file.holes or self.fill == "no":
            return ""
        return f"{file.holes} of {rows * columns} cells without a value, filled from those around them"

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
        self, heights: NDArray[np.float64], place: Place | None, lattice: Lattice
    ) -> NDArray[np.float64]:
        rows, columns = heights.shape
        if self.resample and place is None:
            return resampled(heights, rows / lattice.rows, columns / lattice.columns, lattice)
        if self.resample and place is not None:
            step_y, step_x = lattice.cell_size / place.height, lattice.cell_size / place.width
            if _beyond(lattice.rows * step_y, rows) or _beyond(lattice.columns * step_x, columns):
                size = f"{columns * place.width:g} × {rows * place.height:g} m"
                field = f"{lattice.columns * lattice.cell_size:g} × {lattice.rows * lattice.cell_size:g} m"
                raise UnreadableError(f"covers {size}; allowed: at least the field, {field}")
            return resampled(heights, step_y, step_x, lattice)
        if place is not None:
            _require_cells(place, heights.shape, lattice.cell_size)
        if heights.shape != lattice.shape:
            raise UnreadableError(
                f"is {rows} rows of {columns} cells; allowed: the lattice's {lattice.rows} rows of "
                f"{lattice.columns} cells, or resample true"
            )
        return heights


def raster_in(path: Path, hints: Hints) -> Raster:
    """The raster in a file, as ``reading.read`` reads it; the one that was read last is kept.

    Its numbers must not be changed. Raises UnreadableError where the file holds none.
    """
    return _raster(path, hints, _stamps(path, path.with_suffix(".prj")))


@lru_cache(maxsize=1)
def _raster(path: Path, hints: Hints, _stamps: tuple[tuple[str, int, int], ...]) -> Raster:
    raster = read(path, hints)
    raster.values.setflags(write=False)
    return raster


def doubtful(raster: Raster, cell_size: float) -> list[tuple[float, int]]:
    """Numbers of a raster that look like undeclared codes for missing cells, each with its count.

    ``cell_size`` (m) counts where the raster has no cells of its own.
    """
    cell = raster.place.cell_size if raster.place is not None else cell_size
    return suspects(raster.values.astype(np.float64), raster.scale, cell)


def _beyond(needed: float, available: int) -> bool:
    """Whether more of the file's cells are needed than there are, within the tolerance."""
    return needed - available > min(FARTHEST, TOLERANCE * available)


@lru_cache(maxsize=32)
def _outline(file: FromFile, _stamps: tuple[tuple[str, int, int], ...]) -> Outline:
    """The outline of a file; kept as long as its stamps are the same."""
    raster = file.raster()
    rows, columns = raster.values.shape
    holes = np.count_nonzero(file.holes(raster.values.astype(np.float64)))
    return Outline((rows, columns), raster.place, raster.scale, raster.unit, int(holes), raster.coloured)


def _stamps(*paths: Path) -> tuple[tuple[str, int, int], ...]:
    """Place, time of change and length of those files that exist."""
    found = [(str(path.resolve()), path.stat()) for path in paths if path.is_file()]
    return tuple((name, stat.st_mtime_ns, stat.st_size) for name, stat in found)


def _refuse_suspects(found: list[tuple[float, int]], advice: str) -> None:
    if not found:
        return
    said = " and ".join(f"{'a cell' if n == 1 else f'{n} cells'} of {_exact(v)}" for v, n in found)
    codes = ", ".join(_exact(value) for value, _ in found)
    raise UnreadableError(
        f"has {said}, which looks like a code for cells without a value that the file does not declare; "
        + advice.format(codes=codes)
    )


def _exact(value: float) -> str:
    """A number that reads back as the same single-precision value."""
    return f"{value:.9g}"


def _require_cells(place: Place, shape: tuple[int, int], cell_size: float) -> None:
    """Raise UnreadableError where a file's cells are not the lattice's, within the tolerance."""
    sides, counts = (place.width, place.height), (shape[1], shape[0])
    parts = [abs(side / cell_size - 1.0) for side in sides]
    if all(p <= TOLERANCE and p * n <= FARTHEST for p, n in zip(parts, counts, strict=True)):
        return
    square = abs(place.width / place.height - 1.0) <= TOLERANCE
    cells = f"{place.width:.9g} m" if square else f"{place.width:.9g} × {place.height:.9g} m"
    raise UnreadableError(
        f"has cells of {cells}; allowed: {cell_size:g} m as lattice.cell_size (within {100 * TOLERANCE:g} %, "
        "and half a cell over the field), or resample true"
    )
