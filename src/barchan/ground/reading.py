"""Rasters from files, by suffix: arrays, greyscale images, elevation models."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from barchan.ground.geotiff import read_elevation_model
from barchan.ground.netcdf_grid import read_netcdf
from barchan.ground.raster import Hints, Raster, UnreadableError
from barchan.ground.text_grids import read_ascii_grid, read_points


def read(path: Path, hints: Hints | None = None) -> Raster:
    """The raster in a file.

    Raises UnreadableError where it holds none.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise UnreadableError(f"is of an unknown kind; allowed: {', '.join(READERS)}")
    if not path.is_file():
        raise UnreadableError("no such file")
    return reader(path, hints or Hints())


def _array(path: Path, _hints: Hints) -> Raster:
    try:
        values = np.load(path, allow_pickle=False)
    except (OSError, ValueError, EOFError) as error:
        raise UnreadableError(f"cannot be read as a NumPy array: {error}") from None
    if not isinstance(values, np.ndarray) or values.ndim != 2 or values.dtype.kind not in "biuf":
        raise UnreadableError("holds no two-dimensional array of numbers")
    if not values.size:
        raise UnreadableError("holds an empty array")
    return Raster(values)


def _image(path: Path, _hints: Hints) -> Raster:
    from PIL import Image

    try:
        with Image.open(path) as image:
            mode, values = image.mode, np.asarray(image)
    except (OSError, ValueError, Image.DecompressionBombError) as error:
        raise UnreadableError(f"cannot be read as an image: {error}") from None
    if mode != "L" and not mode.startswith("I"):
        raise UnreadableError(f"is an image of mode {mode}; allowed: greyscale of 8 or 16 bits")
    return Raster(values[::-1], full_scale=255.0 if mode == "L" else 65535.0)


def _photograph(path: Path, _hints: Hints) -> Raster:
    """The luminance (ITU-R BT.601) of an image that cameras and scanners store in colour."""
    from PIL import Image

    try:
        with Image.open(path) as image:
            values = np.asarray(image.convert("L"))
    except (OSError, ValueError, Image.DecompressionBombError) as error:
        raise UnreadableError(f"cannot be read as an image: {error}") from None
    return Raster(values[::-1], full_scale=255.0)


READERS: dict[str, Callable[[Path, Hints], Raster]] = {
    ".npy": _array,
    ".png": _image,
    ".jpg": _photograph,
    ".jpeg": _photograph,
    ".tif": read_elevation_model,
    ".tiff": read_elevation_model,
    ".asc": read_ascii_grid,
    ".xyz": read_points,
    ".nc": read_netcdf,
    ".hgt": read_elevation_model,
}
"""Readers by the suffix of the file."""
