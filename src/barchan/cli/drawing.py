"""Options of pictures that commands share: how they are drawn, and how large they are."""

from dataclasses import dataclass, fields
from typing import Annotated, Any, Literal

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.errors import BarchanError

Colours = Literal["natural", "perceptual", "grey", "red-green"]

MOST_DOTS = 400_000_000
"""Dots of the largest picture, some 20,000 by 20,000; drawing takes 16 bytes for each."""

CENTIMETRES = 2.54
"""Centimetres to the inch."""


def _option(text: str, **limits: float) -> Parameter:
    """An option that is left out unless it is given."""
    return Parameter(help=text, negative=(), validator=Number(**limits) if limits else None)


def _switch(text: str) -> Parameter:
    """An option with a word for no."""
    return Parameter(help=text)


@Parameter(name="*")
@dataclass(frozen=True)
class Drawing:
    """How a picture is drawn; each view takes some of these options."""

    step: Annotated[int | None, _option("The frame nearest to this step; the last one without it.")] = None
    colours: Annotated[
        Colours | None,
        _option(
            "Colours of elevation: those of sand or snow, light upwards (natural, without it); perceptual, "
            "grey, or red-green with red the highest. Fields are perceptual without it."
        ),
    ] = None
    limits: Annotated[
        tuple[float, float] | None,
        _option(
            "Lowest and highest elevation (m), or value of the field, of the colour scale of maps, contours "
            "and oblique views; the frame's own without it."
        ),
    ] = None
    interval: Annotated[
        float | None, _option("Contour interval (m); a round one, told beside the colours, without it.", gt=0)
    ] = None
    count: Annotated[
        int | None, _option("Number of contours, evenly spaced, instead of an interval.", gte=1, lte=1000)
    ] = None
    smoothing: Annotated[
        float | None,
        _option(
            "Cells over which the surface, or the field, is smoothed for display: 0.8 for maps and oblique "
            "views, 1.5 for contours, 0 for sections and fields without it; the curve of a field along a "
            "section is smoothed over 2 cells at least.",
            gte=0,
            lte=1000,
        ),
    ] = None
    at: Annotated[
        float | None,
        _option(
            "Where the section (profile, space-time) lies across the wind, from 0 to 1; through the highest "
            "stack without it.",
            gte=0,
            lte=1,
        ),
    ] = None
    angle: Annotated[
        float | None,
        _option("Height of an oblique view above the horizon (degrees); 35 without it.", gte=5, lte=90),
    ] = None
    bare: Annotated[
        bool | None, _switch("Show bare ground, rocks and stems in colours of their own; yes without it.")
    ] = None
    layers: Annotated[
        bool | None,
        _switch(
            "Draw the model's layers over the surface, such as plants, light to dark green; yes without it."
        ),
    ] = None
    strata: Annotated[
        str | None,
        _option(
            "What colours the layers of snow in a section: the age of their bonds (age, without it), their "
            "density, or their state, loose or bonded."
        ),
    ] = None
    grains: Annotated[
        int | None,
        _option(
            "Number of grains to follow for paths and hops: 20 for paths, 1000 for hops without it.",
            gte=1,
            lte=100_000,
        ),
    ] = None

    def given(self) -> dict[str, Any]:
        """The options that were given."""
        options = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: value for name, value in options.items() if value is not None}


@Parameter(name="*")
@dataclass(frozen=True)
class Size:
    """How large a picture is."""

    size: Annotated[
        tuple[float, float] | None,
        _option("Width and height of the picture (cm); what suits it without it.", gte=2, lte=200),
    ] = None
    dpi: Annotated[int | None, _option("Dots per inch of the picture; 150 without it.", gte=20, lte=2400)] = (
        None
    )

    def apply(self, figure: Any) -> None:
        """Give a figure this width and height; raises BarchanError for more dots than a picture may have."""
        if self.size is not None:
            figure.set_size_inches(*(side / CENTIMETRES for side in self.size))
        width, height = (round(side * (self.dpi or figure.dpi)) for side in figure.get_size_inches())
        if width * height > MOST_DOTS:
            raise BarchanError(
                f"the picture has {width} × {height} dots; allowed: up to {MOST_DOTS / 1e6:.0f} million, "
                "so a smaller --size or fewer --dpi"
            )
