"""Animated pictures of a run: WebP, GIF or MP4."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from barchan.analysis.on_squares import on_squares
from barchan.errors import BarchanError
from barchan.figures.light import exaggeration
from barchan.figures.maps import range_over, shaded, surface_range
from barchan.figures.mp4 import require_video, write_mp4
from barchan.figures.style import SMOOTHING, Colours
from barchan.replacing import replacing
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr

FORMATS = (".webp", ".gif", ".mp4")

RATE, PIXELS = 12.0, 512
"""Frames in a second, and pixels on the longer side of a film, where none are given."""


def film(
    dataset: "xr.Dataset",
    scenario: Scenario,
    path: Path,
    *,
    frames_per_second: float = RATE,
    pixels: int = PIXELS,
    colours: Colours = "natural",
    smoothing: float = SMOOTHING,
    follow: bool = False,
    layers: bool = True,
    progress: Callable[[int], None] | None = None,
) -> None:
    """Write the shaded maps of all frames as an animation; the longer side gets about as many ``pixels``.

    With ``follow`` the colour scale follows each frame instead of holding for the whole run; with
    ``layers`` the model's layers, such as plants, lie over the surface. Raises BarchanError for a file that
    is neither .webp, .gif nor .mp4, or that cannot be written.
    """
    ending = path.suffix.lower()
    if ending not in FORMATS:
        raise BarchanError(f"{path}: a film is {' or '.join(FORMATS)}, not '{path.suffix}'")
    if ending == ".mp4":
        require_video()
    pictures = shaded_frames(dataset, scenario, pixels, colours, smoothing, follow, layers, progress)
    try:
        with replacing(path) as partial:
            encode(partial, pictures, frames_per_second)
    except OSError as error:
        raise BarchanError(f"cannot write {path}: {error}") from None


def encode(path: Path, pictures: Iterator[Image.Image], frames_per_second: float) -> None:
    """Write pictures as a film in the format of the suffix; raises OSError where it cannot be written."""
    kind = path.suffix[1:].upper()
    if kind == "MP4":
        write_mp4(path, pictures, frames_per_second)
        return
    options = {"lossless": False, "quality": 80} if kind == "WEBP" else {}
    next(pictures).save(
        path,
        format=kind,
        save_all=True,
        append_images=pictures,
        duration=round(1000 / frames_per_second),
        loop=0,
        **options,
    )


def shaded_frames(
    dataset: "xr.Dataset",
    scenario: Scenario,
    pixels: int = PIXELS,
    colours: Colours = "natural",
    smoothing: float = SMOOTHING,
    follow: bool = False,
    layers: bool = True,
    progress: Callable[[int], None] | None = None,
) -> Iterator[Image.Image]:
    """The shaded maps of all frames as pictures, the longer side of about ``pixels`` pixels; see ``film``."""
    from matplotlib.colors import Normalize

    count = dataset.sizes["step"]
    last, square = on_squares(dataset.isel(step=-1).load(), scenario)
    steeper = None if follow else exaggeration(last["elevation"].values, square, smoothing)
    norm = Normalize(*range_over(dataset, scenario))
    scale = max(1, round(pixels / max(scenario.lattice.shape)))
    for k in range(count):
        frame, square = on_squares(dataset.isel(step=k).load(), scenario)
        own = Normalize(*surface_range(frame, square)) if follow else norm
        colour = shaded(
            frame, square, norm=own, colours=colours, smoothing=smoothing, layers=layers, steeper=steeper
        )[::-1]
        picture = Image.fromarray((colour * 255).round().astype(np.uint8))
        yield picture.resize((picture.width * scale, picture.height * scale), Image.Resampling.BICUBIC)
        if progress is not None:
            progress(k + 1)
