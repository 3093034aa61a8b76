"""Films: MP4, WebP or GIF of shaded maps."""

from pathlib import Path
from typing import Any

from barchan.export.source import Source


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the chosen frames as a film, colours as in pictures of maps."""
    from barchan.figures.film import film

    wishes = {
        "frames_per_second": source.options.frames_per_second,
        "size": source.options.pixels,
    }
    film(
        source.dataset.sel(step=list(source.steps)),
        source.scenario,
        path,
        **{name: wish for name, wish in wishes.items() if wish is not None},  # type: ignore[arg-type]
    )
    return {}
