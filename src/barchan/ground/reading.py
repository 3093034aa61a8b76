"""Rasters from files, by suffix: arrays, images, elevation models."""

import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from barchan.ground.geotiff import read_elevation_model
from barchan.ground.netcdf_grid import read_netcdf
from barchan.ground.raster import Hints, Raster, UnreadableError
from barchan.ground.text_grids import read_ascii_grid, read_points
from barchan.image_files import ImageError, image_in
from barchan.words import counted

if TYPE_CHECKING:
    from PIL.Image import Image

MOST_PIXELS = 1 << 26
"""Pixels of an image that is read (8192 × 8192)."""

OPAQUE = 255
"""What the alpha channel of an image holds where nothing shines through."""


def read(path: Path, hints: Hints | None = None) -> Raster:
    """The raster in a file.

    Raises UnreadableError where it holds none.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise UnreadableError(f"is of an unknown kind; allowed: {', '.join(READERS)}")
    if not path.is_file():
        raise UnreadableError("no such file")
    try:
        return reader(path, hints or Hints())
    except MemoryError:
        raise UnreadableError("holds more than there is memory for") from None


def _array(path: Path, _hints: Hints) -> Raster:
    try:
        _refuse_false_heading(path)
        values = np.load(path, allow_pickle=False)
    except (OSError, ValueError, EOFError) as error:
        raise UnreadableError(f"cannot be read as a NumPy array: {error}") from None
    if not isinstance(values, np.ndarray) or values.ndim != 2 or values.dtype.kind not in "biuf":
        raise UnreadableError("holds no two-dimensional array of numbers")
    if not values.size:
        raise UnreadableError("holds an empty array")
    return Raster(values)


def _refuse_false_heading(path: Path) -> None:
    """Raise ValueError where a heading promises more numbers than the file holds: they would all be made."""
    from numpy.lib import format as layout

    with path.open("rb") as file:
        version = layout.read_magic(file)
        read = layout.read_array_header_1_0 if version == (1, 0) else layout.read_array_header_2_0
        shape, _, kind = read(file)
        stored = path.stat().st_size - file.tell()
    promised = math.prod(shape) * kind.itemsize
    if not kind.hasobject and promised > stored:
        size = " × ".join(str(length) for length in shape)
        raise ValueError(f"its heading states {size} numbers, {promised:,} bytes; the file holds {stored:,}")


def _image(path: Path, _hints: Hints) -> Raster:
    """Greys as they are, of 16 bits or of 8; of colours the luminance (ITU-R BT.601), which keeps greys."""
    try:
        with path.open("rb") as file:
            image = image_in(file, ("PNG", "JPEG"), MOST_PIXELS)
            if image.mode.startswith("I"):
                return Raster(np.asarray(image)[::-1], full_scale=65535.0)
            _refuse_transparency(image)
            return Raster(
                np.asarray(image.convert("L"))[::-1], full_scale=255.0, coloured=_has_colours(image)
            )
    except ImageError as error:
        raise UnreadableError(str(error)) from None
    except (OSError, ValueError, SyntaxError) as error:
        raise UnreadableError(f"cannot be read as an image: {error}") from None


def _refuse_transparency(image: "Image") -> None:
    if image.mode == "L" or not image.has_transparency_data:
        return
    found = int(np.count_nonzero(np.asarray(image.convert("RGBA").getchannel("A")) < OPAQUE))
    if found:
        pixels = counted(found, "transparent pixel")
        raise UnreadableError(f"has {pixels} without a height; allowed: opaque ones")


def _has_colours(image: "Image") -> bool:
    if image.mode in ("1", "L", "LA"):
        return False
    pixels = np.asarray(image.convert("RGB"))
    return bool((pixels[..., 1:] != pixels[..., :1]).any())


READERS: dict[str, Callable[[Path, Hints], Raster]] = {
    ".npy": _array,
    ".png": _image,
    ".jpg": _image,
    ".jpeg": _image,
    ".tif": read_elevation_model,
    ".tiff": read_elevation_model,
    ".asc": read_ascii_grid,
    ".xyz": read_points,
    ".nc": read_netcdf,
    ".hgt": read_elevation_model,
}
"""Readers by the suffix of the file."""
