"""Animated pictures of a run: WebP or GIF."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from barchan.errors import BarchanError
from barchan.figures.light import exaggeration
from barchan.figures.maps import elevation_range, shaded, surface_range
from barchan.figures.style import SMOOTHING, Colours
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr

FORMATS = (".webp", ".gif")


def film(
    dataset: "xr.Dataset",
    scenario: Scenario,
    path: Path,
    *,
    frames_per_second: float = 12.0,
    pixels: int = 512,
    colours: Colours = "natural",
    smoothing: float = SMOOTHING,
    follow: bool = False,
    layers: bool = True,
    progress: Callable[[int], None] | None = None,
) -> None:
    """Write the shaded maps of all frames as an animation; the longer side gets about as many ``pixels``.

    With ``follow`` the colour scale follows each frame instead of holding for the whole run; with
    ``layers`` the model's layers, such as plants, lie over the surface. Raises BarchanError for a file that
    is neither .webp nor .gif, or that cannot be written.
    """
    ending = path.suffix.lower()
    if ending not in FORMATS:
        raise BarchanError(f"{path}: a film is {' or '.join(FORMATS)}, not '{path.suffix}'")
    pictures = _pictures(dataset, scenario, pixels, colours, smoothing, follow, layers, progress)
    first = next(pictures)
    partial = path.with_name(path.name + ".partial")
    options = {"lossless": False, "quality": 80} if ending == ".webp" else {}
    try:
        first.save(
            partial,
            format=ending[1:].upper(),
            save_all=True,
            append_images=pictures,
            duration=round(1000 / frames_per_second),
            loop=0,
            **options,
        )
        partial.replace(path)
    except OSError as error:
        raise BarchanError(f"cannot write {path}: {error}") from None


def _pictures(
    dataset: "xr.Dataset",
    scenario: Scenario,
    pixels: int,
    colours: Colours,
    smoothing: float,
    follow: bool,
    layers: bool,
    progress: Callable[[int], None] | None,
) -> Iterator[Image.Image]:
    from matplotlib.colors import Normalize

    count = dataset.sizes["step"]
    last = dataset.isel(step=-1).load()
    steeper = None if follow else exaggeration(last["elevation"].values, scenario, smoothing)
    norm = Normalize(*_range(dataset, scenario))
    scale = max(1, round(pixels / max(scenario.lattice.shape)))
    for k in range(count):
        frame = dataset.isel(step=k).load()
        own = Normalize(*surface_range(frame, scenario)) if follow else norm
        colour = shaded(
            frame, scenario, norm=own, colours=colours, smoothing=smoothing, layers=layers, steeper=steeper
        )[::-1]
        picture = Image.fromarray((colour * 255).round().astype(np.uint8))
        yield picture.resize((picture.width * scale, picture.height * scale), Image.Resampling.BICUBIC)
        if progress is not None:
            progress(k + 1)


def _range(dataset: "xr.Dataset", scenario: Scenario) -> tuple[float, float]:
    """Lowest and highest elevation (m) of the sand in all frames."""
    ranges = [elevation_range(dataset.isel(step=k)) for k in range(dataset.sizes["step"])]
    low, high = min(low for low, _ in ranges), max(high for _, high in ranges)
    return (low, high) if high > low else surface_range(dataset.isel(step=-1), scenario)
