"""Arrays of heights read from files: NumPy arrays, greyscale PNG images, GeoTIFF elevation models.

Row 0 is the south edge afterwards: images and GeoTIFF are turned, a NumPy array lies as ours do.
"""

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.errors import BarchanError

MISSING_EXTRA = "needs rasterio to be read; install it with: pip install barchan[geo]"


class UnreadableError(BarchanError):
    """A file whose heights cannot be used, and why."""


@dataclass(frozen=True)
class Raster:
    """Heights in a file; where it has none, NaN."""

    heights: NDArray[np.float64]
    full_scale: float | None = None
    """The value of white, in an image."""
    cell_size: float | None = None
    """Width of a cell (m), in an elevation model."""


def read(path: Path) -> Raster:
    """The heights in a file, by its suffix.

    Raises UnreadableError where it holds none.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise UnreadableError(f"is of an unknown kind; allowed: {', '.join(READERS)}")
    if not path.is_file():
        raise UnreadableError("no such file")
    return reader(path)


def georeference(path: Path) -> dict[str, Any]:
    """The coordinate reference system of an elevation model and its south-west corner in it (m).

    Nothing where the file has none, or is no longer there.
    """
    if READERS.get(path.suffix.lower()) is not _elevation_model:
        return {}
    try:
        with _opened(path) as source:
            crs, bounds = source.crs, source.bounds
    except UnreadableError:
        return {}
    return {"crs": crs.to_string(), "west": bounds.left, "south": bounds.bottom} if crs else {}


def _array(path: Path) -> Raster:
    try:
        heights = np.load(path, allow_pickle=False)
    except (OSError, ValueError, EOFError) as error:
        raise UnreadableError(f"cannot be read as a NumPy array: {error}") from None
    if not isinstance(heights, np.ndarray) or heights.ndim != 2 or heights.dtype.kind not in "biuf":
        raise UnreadableError("holds no two-dimensional array of numbers")
    return Raster(heights.astype(np.float64))


def _image(path: Path) -> Raster:
    from PIL import Image

    try:
        with Image.open(path) as image:
            mode, values = image.mode, np.asarray(image)
    except (OSError, ValueError, Image.DecompressionBombError) as error:
        raise UnreadableError(f"cannot be read as an image: {error}") from None
    if mode != "L" and not mode.startswith("I"):
        raise UnreadableError(f"is an image of mode {mode}; allowed: greyscale of 8 or 16 bits")
    return Raster(values[::-1].astype(np.float64), full_scale=255.0 if mode == "L" else 65535.0)


def _elevation_model(path: Path) -> Raster:
    with _opened(path) as source:
        shape, crs = source.transform, source.crs
        if source.count != 1:
            raise UnreadableError(f"has {source.count} bands; allowed: one, of elevations")
        if crs is None or not crs.is_projected or crs.linear_units_factor[1] != 1.0:
            name = "no coordinate reference system" if crs is None else crs.to_string()
            raise UnreadableError(f"has {name}; allowed: a projected one in metres, for instance UTM")
        if shape.b or shape.d or not math.isclose(shape.a, abs(shape.e), rel_tol=1e-6):
            raise UnreadableError(
                "has cells that are no upright squares; allowed: squares, rows from west to east"
            )
        values = source.read(1, masked=True).astype(np.float64) * source.scales[0] + source.offsets[0]
        heights = np.ma.filled(values, np.nan)
        return Raster(heights[::-1] if shape.e < 0 else heights, cell_size=shape.a)


def _opened(path: Path) -> Any:
    try:
        import rasterio
    except ImportError:
        raise UnreadableError(MISSING_EXTRA) from None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
            return rasterio.open(path)
    except rasterio.errors.RasterioError as error:
        raise UnreadableError(f"cannot be read as a GeoTIFF: {error}") from None


READERS: dict[str, Callable[[Path], Raster]] = {
    ".npy": _array,
    ".png": _image,
    ".tif": _elevation_model,
    ".tiff": _elevation_model,
}
"""Readers by the suffix of the file."""
