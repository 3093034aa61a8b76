"""The panel of a map: its shape, its axes in metres, its colour bars."""

from typing import TYPE_CHECKING, Any

from barchan.figures.style import extent, heading, new_figure, title
from barchan.figures.winds import wind_sign
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SIDE = 5.6
"""Longer side (inches) of a map."""

MOST_ELONGATED = 12.0
"""Longer side of a field over the shorter one up to which maps have its shape; others are drawn wider."""

LOW = 0.5
"""Rows over columns below which colour bars lie under the map."""

MOST_MARKS = 8
"""Intervals of an axis at most."""

ROUND = (1.0, 2.0, 2.5, 5.0, 10.0)
"""Intervals of an axis, times a power of ten."""

BAR = 0.85
"""Inches that a colour bar with its labels takes."""


def map_panel(scenario: Scenario, frame: "xr.Dataset", image: Any, **style: Any) -> tuple["Figure", "Axes"]:
    """A figure with an image of the field, north up, in metres, under its title and the wind.

    ``image`` holds colours or values of the cells; ``style`` is that of ``imshow``.
    """
    shape = drawn_shape(scenario)
    width, height = SIDE / max(shape, 1.0), SIDE * min(shape, 1.0)
    figure = new_figure(max(width + 1.0, 3.4) + BAR, height + 1.5 + BAR * (shape < LOW), of_map=True)
    axes = figure.add_subplot()
    axes.imshow(image, origin="lower", extent=extent(scenario), interpolation="nearest", **style)
    rows, columns = scenario.lattice.shape
    stretched = shape != rows / columns
    axes.set_aspect("auto" if stretched else "equal")
    if stretched:
        axes.set_box_aspect(shape)
    _label(axes, shape, rows < columns, stretched)
    _place(axes, scenario)
    heading(figure, title(scenario, int(frame["step"])))
    wind_sign(axes, scenario, frame)
    return figure, axes


def drawn_shape(scenario: Scenario) -> float:
    """Height over width of the field as maps draw it."""
    rows, columns = scenario.lattice.shape
    return min(max(rows / columns, 1 / MOST_ELONGATED), MOST_ELONGATED)


def _label(axes: "Axes", shape: float, wide: bool, stretched: bool) -> None:
    """Names of the axes, and which of them is not to scale; no more marks than there is room for."""
    from matplotlib.ticker import MaxNLocator

    axes.set_xlabel("x (m), y is not to scale" if stretched and wide else "x (m)")
    axes.set_ylabel("y (m), x is not to scale" if stretched and not wide else "y (m)")
    for axis, side, room in (
        (axes.xaxis, SIDE / max(shape, 1.0), 0.7),
        (axes.yaxis, SIDE * min(shape, 1.0), 0.4),
    ):
        axis.set_major_locator(MaxNLocator(int(min(max(side / room, 1), MOST_MARKS)), steps=ROUND))


def _place(axes: "Axes", scenario: Scenario) -> None:
    """Where on Earth the origin of the axes lies, of fields over terrain that states it."""
    place = scenario.ground.georeference()
    if place is None:
        return
    system = "" if place.crs is None else f" ({place.crs})"
    origin = f"x = 0: {place.west:.10g} m E, y = 0: {place.south:.10g} m N{system}"
    axes.set_xlabel(f"{axes.get_xlabel()}\n{origin}")


def colour_bar(figure: "Figure", axes: "Axes", scale: Any, label: str, **options: Any) -> Any:
    """A colour bar beside a map, or under one that is much wider than high.

    The figure grows for the second bar and those after it.
    """
    shape = _shape_of(axes)
    low = shape < LOW
    if len(figure.axes) > 1:
        width, height = figure.get_size_inches()
        figure.set_size_inches(width + BAR * (not low), height + BAR * low)
    where: dict[str, Any] = (
        {"location": "bottom", "aspect": 40}
        if low
        else {"location": "right", "aspect": max(30.0, 6.0 * shape)}
    )
    return figure.colorbar(scale, ax=axes, label=label, shrink=0.9, **where, **options)


def _shape_of(axes: "Axes") -> float:
    """Height over width of a map."""
    west, east = axes.get_xlim()
    south, north = axes.get_ylim()
    return axes.get_box_aspect() or (north - south) / (east - west)
