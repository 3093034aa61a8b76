"""Films: MP4, WebP or GIF of shaded maps."""

from pathlib import Path
from typing import Any

from barchan.export.source import Source


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the chosen frames as a film, colours as in pictures of maps."""
    from barchan.figures.film import PIXELS, RATE, encode, shaded_frames

    chosen = source.dataset.sel(step=list(source.steps))
    pixels = source.options.pixels or PIXELS
    pictures = shaded_frames(chosen, source.scenario, pixels, progress=source.progress)
    rate = source.options.frames_per_second or RATE
    encode(path, pictures, rate)
    return {"frames_per_second": rate}
