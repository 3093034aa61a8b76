"""Images that others made: what a file claims of itself is judged before anything is unpacked."""

import math
import struct
from collections.abc import Sequence
from typing import IO, TYPE_CHECKING

from barchan.errors import BarchanError

if TYPE_CHECKING:
    from PIL.ImageFile import ImageFile


class ImageError(BarchanError):
    """An image that is not read, and why."""


def image_in(file: IO[bytes], formats: Sequence[str], most: int) -> "ImageFile":
    """The image in an open file, of one of Pillow's ``formats``, with ``most`` pixels at most; not unpacked.

    Raises ImageError for anything else.
    """
    image = _heading(file, formats)
    if image.width * image.height > most:
        side = math.isqrt(most)
        raise ImageError(f"has {image.width} × {image.height} pixels; allowed: as many as {side} × {side}")
    return image


def _heading(file: IO[bytes], formats: Sequence[str]) -> "ImageFile":
    """``Image.open``, which from a number of pixels of its own on tells neither width nor height."""
    from PIL import Image

    start = file.read(16)
    for name in formats:
        if name not in Image.OPEN:
            Image.init()
        reader, accepts = Image.OPEN[name]
        if accepts is not None and accepts(start) is not True:
            continue
        file.seek(0)
        try:
            return reader(file, "")
        except (OSError, ValueError, SyntaxError, IndexError, TypeError, struct.error) as error:
            raise ImageError(f"cannot be read as an image: {error}") from None
    raise ImageError(f"cannot be read as an image; allowed: {', '.join(formats)}")
