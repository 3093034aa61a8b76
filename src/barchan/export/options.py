"""What may be asked of an export, beside the steps and the fields."""

from dataclasses import dataclass, fields
from datetime import datetime
from typing import Any

from barchan.errors import ExportError

MOST_CELLS = 1 << 28
"""Cells that a field may be brought onto."""

MOST_ALONG = 255
"""Vertices along a side of a part: with 256 it would have more than the 65,535 that many programs read."""


@dataclass(frozen=True)
class Options:
    """How frames are changed and written; None, or False, leaves an option out. Each format takes some."""

    smooth: float | None = None
    """Standard deviation (cells) of the Gaussian that smooths surface and layers; their mean stays."""
    cells: tuple[int, int] | None = None
    """Columns and rows to bring the field onto; means over their areas, so that the volume stays."""
    close: bool = False
    """Repeat the first row and column at the end of periodic directions, as engines want tiles."""
    limits: tuple[float, float] | None = None
    """Values that 0 and the largest whole number stand for; the extremes of all frames without it."""
    flip: bool = False
    """Write the southern row first instead of the northern one."""
    exaggerate: float | None = None
    """Factor of all heights over the lowest one of a mesh."""
    scale: float | None = None
    """Units of a mesh to the metre; 1 without it."""
    split: int | None = None
    """Most vertices along a side of the parts that a mesh is split into; one part without it."""
    colour_by: str | None = None
    """Field that colours a mesh, or natural; natural without it, and one colour of a mesh that moves."""
    base: float | None = None
    """Thickness (m) of a solid below its lowest point; a tenth of its relief without it."""
    epoch: datetime | None = None
    """The moment of step 0 in files that name dates."""
    at: float | None = None
    """Where a section lies across the wind, from 0 to 1; through the highest stack without it."""
    frames_per_second: float | None = None
    """Frames that a film shows in a second."""
    pixels: int | None = None
    """Pixels on the longer side of a film, about."""
    size: tuple[float, float] | None = None
    """Width and height (cm) of a picture."""
    dpi: int | None = None
    """Dots per inch of a picture."""

    def __post_init__(self) -> None:
        for name, fits, allowed in (
            ("smooth", lambda v: 0 <= v <= 1000, "0 to 1000 cells"),
            (
                "cells",
                lambda v: min(v) >= 1 and v[0] * v[1] <= MOST_CELLS,
                f"1 to {MOST_CELLS:,} cells in all",
            ),
            ("limits", lambda v: v[0] < v[1], "the lowest below the highest"),
            ("exaggerate", lambda v: 0 < v <= 1e6, "above 0, up to 1e6"),
            ("scale", lambda v: 0 < v <= 1e9, "above 0, up to 1e9"),
            (
                "split",
                lambda v: 2 <= v <= MOST_ALONG,
                f"2 to {MOST_ALONG}, so that 16 bits number a part's vertices",
            ),
            ("base", lambda v: 0 < v <= 1e6, "above 0, up to 1e6 m"),
            ("at", lambda v: 0 <= v <= 1, "0 to 1"),
            ("frames_per_second", lambda v: 0.1 <= v <= 100, "0.1 to 100"),
            ("pixels", lambda v: 16 <= v <= 8192, "16 to 8192"),
            ("size", lambda v: min(v) >= 2 and max(v) <= 200, "2 to 200 cm"),
            ("dpi", lambda v: 20 <= v <= 2400, "20 to 2400"),
        ):
            value = getattr(self, name)
            if value is not None and not fits(value):  # type: ignore[no-untyped-call]
                raise ExportError(f"{flag(name)}: is {_spoken(value)}; allowed: {allowed}")

    @property
    def given(self) -> dict[str, Any]:
        """The options that were given."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: value for name, value in values.items() if value is not None and value is not False}


def flag(name: str) -> str:
    """An option as the command line spells it."""
    return "--" + name.replace("_", "-")


def _spoken(value: Any) -> str:
    return " ".join(f"{part:g}" for part in value) if isinstance(value, tuple) else f"{value:g}"
