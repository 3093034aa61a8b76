"""Contours of the surface, labelled, over its colours."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.on_squares import on_squares
from barchan.errors import BarchanError
from barchan.figures.maps import Limits, surface_range
from barchan.figures.panels import colour_bar, drawn_shape, map_panel
from barchan.figures.style import Colours, colour_map, material_of, smooth
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MOST_CONTOURS = 500

ABOUT = 8
"""Contours where neither their number nor their interval is given, about."""

MOST_LABELLED = 10
"""Elevations that are written on contours at most; of more, every second, third … one."""

MOST_NARROW = 4.0
"""Longer side of a map over the shorter one up to which there is room for elevations."""


def contour_map(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    interval: float | None = None,
    count: int | None = None,
    colours: Colours = "natural",
    limits: Limits = None,
    smoothing: float = 1.5,
) -> "Figure":
    """Contours of one frame over its colours, at an interval (m) or of a given number; a round one without.

    The contours carry their elevations, the colour bar names the interval. Raises BarchanError for more
    than ``MOST_CONTOURS`` contours.
    """
    frame, scenario = on_squares(frame, scenario)
    surface = smooth(frame["elevation"].values, smoothing, scenario)
    low, high = limits or (float(surface.min()), float(surface.max()))
    if low == high:
        low, high = surface_range(frame, scenario, show_bare=False)
    levels, apart = _levels(low, high, interval, count)
    style = {"cmap": colour_map(colours, material_of(scenario)), "vmin": low, "vmax": high}
    figure, axes = map_panel(scenario, frame, surface, **style)
    if levels.size and min(surface.shape) > 1 and np.ptp(surface) > 0:
        _draw(axes, scenario, surface, levels)
    colour_bar(figure, axes, axes.images[0], f"elevation (m),\ncontours every {apart:.3g} m")
    return figure


def round_interval(span: float, about: int = ABOUT) -> float:
    """The interval of 1, 2 or 5 times a power of ten that divides a span into nearest to ``about`` parts."""
    rough = span / about
    power = 10.0 ** np.floor(np.log10(rough))
    return float(min((power * factor for factor in (1, 2, 5, 10)), key=lambda s: abs(np.log(s / rough))))


def _levels(
    low: float, high: float, interval: float | None, count: int | None
) -> tuple[NDArray[np.float64], float]:
    """Elevations (m) of contours and how far they lie apart."""
    if interval is None and count is not None:
        return np.linspace(low, high, count + 2)[1:-1], (high - low) / (count + 1)
    apart = interval or round_interval(high - low)
    if (high - low) / apart > MOST_CONTOURS:
        raise BarchanError(
            f"contours every {apart:g} m from {low:g} to {high:g} m are more than {MOST_CONTOURS}; "
            f"allowed here: an interval of {(high - low) / MOST_CONTOURS:.2g} m or more"
        )
    return np.arange(np.ceil(low / apart), np.floor(high / apart) + 1) * apart, apart


def _draw(axes: "Axes", scenario: Scenario, surface: NDArray, levels: NDArray[np.float64]) -> None:
    x, y = scenario.lattice.x, scenario.lattice.y
    contours = axes.contour(x, y, surface, levels=levels, colors="black", linewidths=0.6)
    if not 1 / MOST_NARROW <= drawn_shape(scenario) <= MOST_NARROW:
        return
    every = -(-len(levels) // MOST_LABELLED)
    axes.clabel(contours, levels=levels[::every], fontsize=7, fmt=lambda level: f"{level:.4g}")
