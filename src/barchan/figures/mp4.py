"""Films as MP4, with the library of the extra ``video``."""

from collections.abc import Iterable
from fractions import Fraction
from itertools import chain
from pathlib import Path

import numpy as np
from PIL import Image

from barchan.errors import BarchanError

QUALITY = "18"
"""Constant rate factor of H.264: smaller is better, at 18 losses are hardly seen."""


def require_video() -> None:
    """Raise BarchanError where the library is missing."""
    from importlib.util import find_spec

    if find_spec("av") is None:
        raise BarchanError(
            "an .mp4 is written with av, which is not installed; install it with: python -m pip install av; "
            "or write .webp, which needs nothing more"
        )


def write_mp4(path: Path, pictures: Iterable[Image.Image], frames_per_second: float) -> None:
    """Write pictures as H.264 in the colours that every player knows; sides are cut to even numbers."""
    import av

    pictures = iter(pictures)
    first = next(pictures)
    size = (first.width // 2 * 2, first.height // 2 * 2)
    with av.open(str(path), "w", format="mp4", options={"movflags": "+faststart"}) as file:
        stream = file.add_stream("libx264", rate=Fraction(frames_per_second).limit_denominator(1000))
        stream.width, stream.height = size
        stream.pix_fmt = "yuv420p"
        stream.options = {"crf": QUALITY}
        for picture in chain([first], pictures):
            frame = av.VideoFrame.from_ndarray(np.asarray(picture.crop((0, 0, *size))), format="rgb24")
            file.mux(stream.encode(frame))
        file.mux(stream.encode())
