"""Images that others made: what a file claims of itself is judged before anything is unpacked."""

import math
import warnings
from typing import IO, TYPE_CHECKING

from barchan.errors import BarchanError

if TYPE_CHECKING:
    from PIL.ImageFile import ImageFile


class ImageError(BarchanError):
    """An image that is not read, and why."""


def image_in(file: IO[bytes], formats: tuple[str, ...], most: int) -> "ImageFile":
    """The image in an open file, of one of Pillow's ``formats``, with ``most`` pixels at most.

    It stands upright as its EXIF data say, as those of photographs do. Raises ImageError for anything else.
    """
    from PIL import Image, ImageOps, UnidentifiedImageError

    side = math.isqrt(most)
    allowed = f"allowed: as many as {side} × {side}"
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)  # the size is judged here
            image = Image.open(file, formats=formats)
    except Image.DecompressionBombError:
        most_opened = 2 * (Image.MAX_IMAGE_PIXELS or 0)
        raise ImageError(f"has more than {most_opened} pixels; {allowed}") from None
    except UnidentifiedImageError:
        raise ImageError(f"cannot be read as an image; allowed: {', '.join(formats)}") from None
    except (OSError, ValueError, SyntaxError) as error:
        raise ImageError(f"cannot be read as an image: {error}") from None
    if image.width * image.height > most:
        raise ImageError(f"has {image.width} × {image.height} pixels; {allowed}")
    try:
        ImageOps.exif_transpose(image, in_place=True)
    except (OSError, ValueError, SyntaxError) as error:
        raise ImageError(f"cannot be read as an image: {error}") from None
    return image
