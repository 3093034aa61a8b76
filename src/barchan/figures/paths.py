"""Paths of grains, over a side view and over the surface, and how long, high and steep their hops are."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from barchan.analysis.grain_paths import broken_at_edges, hops_of
from barchan.directions import downwind
from barchan.figures.maps import shaded, surface_range
from barchan.figures.panels import ROUND
from barchan.figures.section_lines import section_along_wind
from barchan.figures.sections import draw_ground, draw_sand, section_heading, shown_heights
from barchan.figures.style import CURVE, SAND, SMOOTHING, extent, heading, new_figure, title
from barchan.scenario import Scenario
from barchan.words import counted

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MOST_FACETS = 128
"""Facets of the drawn surface in each direction at most."""

MOST_MARKS = 7
"""Intervals along the longer side of the surface."""

THINNEST = 0.08
"""Shorter side of the drawn surface over the longer one at least."""


def path_view(frame: "xr.Dataset", scenario: Scenario, paths: list[NDArray[np.float64]]) -> "Figure":
    """Paths over the 3-D surface and, below, from the side: along the wind and up."""
    figure = new_figure(9.0, 8.0)
    solid = figure.add_subplot(3, 1, (1, 2), projection="3d")
    side = figure.add_subplot(3, 1, 3)
    _draw_solid(solid, frame, scenario, paths)
    place = _draw_side(side, frame, scenario, paths)
    shown = f"{title(scenario, int(frame['step']))}, {counted(len(paths), 'grain')}"
    text = f"{shown}\nfrom the side: sand {place}, all grains"
    heading(figure, text)
    return figure


def _draw_solid(axes: Any, frame: "xr.Dataset", scenario: Scenario, paths: list[NDArray]) -> None:
    west, east, south, north = extent(scenario)
    surface = frame["elevation"].values * 1e3
    x, y = np.meshgrid(scenario.lattice.x, scenario.lattice.y)
    stride = max(1, -(-max(surface.shape) // MOST_FACETS))
    colours = shaded(frame, scenario, norm=Normalize(*surface_range(frame, scenario)), smoothing=SMOOTHING)
    axes.computed_zorder = False
    axes.plot_surface(
        x, y, surface, rstride=stride, cstride=stride, facecolors=colours, shade=False, linewidth=0, zorder=1
    )
    lowest = float(frame["ground"].values.min())
    for path in paths:
        line = broken_at_edges(path, east - west, north - south)
        axes.plot(line[:, 0], line[:, 1], (line[:, 2] + lowest) * 1e3, color=CURVE, linewidth=0.8, zorder=2)
    _solid_axes(axes, east - west, north - south)


def _solid_axes(axes: Any, width: float, depth: float) -> None:
    """Axes of a solid view: no more marks than the field's shape has room for, its names clear of them."""
    longest = max(width, depth)
    sides = (width / longest, max(depth / longest, THINNEST), 0.25)
    axes.set_box_aspect(sides, zoom=1.15)
    names = ("x (m)", "y (m)", "elevation (mm)")
    for axis, name, side in zip((axes.xaxis, axes.yaxis, axes.zaxis), names, sides, strict=True):
        axis.set_major_locator(MaxNLocator(max(1, round(MOST_MARKS * side)), steps=ROUND))
        axis.set_tick_params(labelsize=8, pad=2)
        axis.set_label_text(name, fontsize=9)
        axis.labelpad = 12.0 * side + 3.0


def _draw_side(axes: "Axes", frame: "xr.Dataset", scenario: Scenario, paths: list[NDArray]) -> str:
    """The section through the middle and all paths over it; returns where it lies."""
    direction = float(frame["wind_direction"])
    section = section_along_wind(scenario, direction, 0.5)
    edges = section.edges(scenario.lattice.cell_size)
    surface, ground = (
        frame[name].values[section.rows, section.cols] * 1e3 for name in ("elevation", "ground")
    )
    bottom, _ = shown_heights(ground, surface, 1.0)
    draw_ground(axes, edges, ground, bottom, scenario, section)
    draw_sand(axes, edges, ground, surface, np.full(len(surface), -np.inf))
    x, y = downwind(direction)
    west, east, south, north = extent(scenario)
    corner = min(0.0, x * (east - west)) + min(0.0, y * (north - south))
    lowest = float(frame["ground"].values.min())
    for path in paths:
        line = broken_at_edges(path, east - west, north - south)
        along = line[:, 0] * x + line[:, 1] * y - corner
        axes.plot(along, (line[:, 2] + lowest) * 1e3, color=CURVE, linewidth=0.8)
    axes.margins(x=0)
    axes.set_ylim(bottom=bottom)
    axes.set_xlabel("distance downwind (m)")
    axes.set_ylabel("elevation (mm)")
    section_heading(axes, "", direction)
    return section.place


def hop_histograms(frame: "xr.Dataset", scenario: Scenario, paths: list[NDArray[np.float64]]) -> "Figure":
    """How long, how high and how steep at their end the hops of some grains are."""
    hops = np.concatenate([hops_of(path) for path in paths])
    figure = new_figure(9.0, 3.2)
    names = ("hop length (cm)", "hop height (mm)", "impact angle (degrees)")
    for axes, name, values in zip(figure.subplots(1, 3), names, (hops * (100.0, 1e3, 1.0)).T, strict=True):
        axes.hist(values, bins=40, color=SAND)
        axes.axvline(float(values.mean()), color=CURVE, linewidth=1.2)
        axes.set_xlabel(name)
        axes.set_title(f"mean {values.mean():.3g}", loc="right", fontsize=9)
    figure.axes[0].set_ylabel("hops")
    size = f"{counted(len(hops), 'hop')} of {counted(len(paths), 'grain')}"
    text = f"{title(scenario, int(frame['step']))}: {size}"
    heading(figure, text)
    return figure
