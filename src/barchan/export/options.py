"""What may be asked of an export, beside the steps and the fields."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, fields
from datetime import datetime
from typing import Any

from barchan.errors import ExportError

MOST_CELLS = 1 << 28
"""Cells that a field may be brought onto."""

_FLAG = re.compile(r"--([a-z][a-z-]*)")

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


@dataclass(frozen=True)
class Wording:
    """How an option is shown to users."""

    title: str
    """Its name, with unit."""
    meaning: str


WORDING = {
    "smooth": Wording(
        "smoothing (cells)",
        "Smooth surface and layers over this many cells; their mean stays but for rounding. Whole slabs make "
        "terraces, which 1 to 2 cells remove.",
    ),
    "cells": Wording(
        "columns and rows",
        "Columns and rows to bring the field onto: means over areas, so that the volume stays.",
    ),
    "close": Wording(
        "close at the edges",
        "Repeat the first row and column of periodic directions at their end, for engines.",
    ),
    "limits": Wording(
        "values of black and white",
        "Values that 0 and 65535 stand for in 16-bit files, the same for tiles that belong together; the "
        "extremes of all written frames without it.",
    ),
    "flip": Wording("southern row first", "Southern row first (height maps), as Unity shows them."),
    "exaggerate": Wording("heights ×", "Factor of a mesh's heights over the lowest."),
    "scale": Wording(
        "units to the metre",
        "Units of a mesh to the metre; slicers read units as mm, so 10 prints 1 m as 1 cm.",
    ),
    "split": Wording(
        "vertices along a part",
        "Split a .glb mesh into parts of at most this many vertices along a side, 2 to 255: some programs "
        "read no more than 65,535 of a mesh.",
    ),
    "colour_by": Wording(
        "colour by",
        "Field that colours a mesh (.glb, .ply); natural without it. A mesh that moves has one colour "
        "without it; with it frames follow one another, each with its own colours.",
    ),
    "base": Wording(
        "base (m)", "Thickness (m) of a solid below its lowest point; a tenth of its relief without it."
    ),
    "epoch": Wording(
        "moment of step 0",
        "Date and time of step 0 in NetCDF; without it the beginning of the wind's record where that has "
        "dates, else 2000-01-01, said to be arbitrary.",
    ),
    "at": Wording(
        "place of the section (0 to 1)",
        "Where a section lies across the wind, 0 to 1; through the highest stack without it.",
    ),
    "frames_per_second": Wording("frames a second", "Frames a second of a film or animation; 12 without it."),
    "pixels": Wording("longer side (pixels)", "Pixels on the longer side of a film, about; 512 without it."),
    "size": Wording("width and height (cm)", "Width and height (cm) of a picture."),
    "dpi": Wording("dots per inch", "Dots per inch of a picture; 150 without it."),
}
"""Of every option; command line and studio show the same words."""


def options_of(data: dict[str, Any]) -> dict[str, Any]:
    """The options in data as JSON has them: lists for pairs, ISO 8601 for moments; without those left out.

    Raises ExportError, in the words of ``WORDING``, for one that does not exist or has another type or value.
    """
    from pydantic import TypeAdapter, ValidationError

    for name in data:
        if name not in WORDING:
            raise ExportError(f"{name}: no such option; there are {', '.join(WORDING)}")
    try:
        with in_words():
            return TypeAdapter(Options).validate_python(data).given
    except ValidationError as error:
        found = error.errors()[0]
        title = WORDING[str(found["loc"][0])].title
        raise ExportError(f"{title}: is {found['input']!r}; {found['msg']}") from None


@contextmanager
def in_words() -> Iterator[None]:
    """Let errors name options by their titles, instead of as the command line does."""
    try:
        yield
    except ExportError as error:
        raise ExportError(_FLAG.sub(lambda found: _title(found[1], found[0]), str(error))) from None


def _title(name: str, otherwise: str) -> str:
    known = WORDING.get(name.replace("-", "_"))
    return known.title if known is not None else otherwise
