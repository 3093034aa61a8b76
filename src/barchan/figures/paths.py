"""Paths of grains, over a side view and over the surface, and how long, high and steep their hops are."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.grain_paths import broken_at_edges, hops_of
from barchan.directions import downwind
from barchan.figures.section_lines import section_along_wind
from barchan.figures.style import CURVE, SAND, colour_map, extent, new_figure, title
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MOST_FACETS = 128
"""Facets of the drawn surface in each direction at most."""


def path_view(frame: "xr.Dataset", scenario: Scenario, paths: list[NDArray[np.float64]]) -> "Figure":
    """Paths over the 3-D surface and, below, from the side: along the wind and up."""
    figure = new_figure(9.0, 8.0)
    solid = figure.add_subplot(3, 1, (1, 2), projection="3d")
    side = figure.add_subplot(3, 1, 3)
    _draw_solid(solid, frame, scenario, paths)
    _draw_side(side, frame, scenario, paths)
    figure.suptitle(f"{title(scenario, int(frame['step']))}, {len(paths)} grains", x=0.01, ha="left")
    return figure


def _draw_solid(axes: Any, frame: "xr.Dataset", scenario: Scenario, paths: list[NDArray]) -> None:
    west, east, south, north = extent(scenario)
    surface = frame["elevation"].values * 1e3
    lattice = scenario.lattice
    x, y = np.meshgrid(lattice.x, lattice.y)
    stride = max(1, -(-max(surface.shape) // MOST_FACETS))
    axes.computed_zorder = False
    axes.plot_surface(
        x, y, surface, rstride=stride, cstride=stride, cmap=colour_map("perceptual"), linewidth=0, zorder=1
    )
    lowest = float(frame["ground"].values.min())
    for path in paths:
        line = broken_at_edges(path, east - west, north - south)
        axes.plot(line[:, 0], line[:, 1], (line[:, 2] + lowest) * 1e3, color=CURVE, linewidth=0.8, zorder=2)
    axes.set_box_aspect((1, (north - south) / (east - west), 0.25))
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    axes.set_zlabel("elevation (mm)")


def _draw_side(axes: "Axes", frame: "xr.Dataset", scenario: Scenario, paths: list[NDArray]) -> None:
    direction = float(frame["wind_direction"])
    section = section_along_wind(scenario, direction, 0.5)
    surface = frame["elevation"].values[section.rows, section.cols] * 1e3
    axes.fill_between(section.distance, surface.min() - 1.0, surface, color=SAND, label="sand, at the middle")
    x, y = downwind(direction)
    west, east, south, north = extent(scenario)
    corner = min(0.0, x * (east - west)) + min(0.0, y * (north - south))
    lowest = float(frame["ground"].values.min())
    for path in paths:
        line = broken_at_edges(path, east - west, north - south)
        along = line[:, 0] * x + line[:, 1] * y - corner
        axes.plot(along, (line[:, 2] + lowest) * 1e3, color=CURVE, linewidth=0.8)
    axes.margins(x=0)
    axes.set_xlabel("distance downwind (m)")
    axes.set_ylabel("elevation (mm)")
    axes.annotate("wind →", (1.0, 1.02), xycoords="axes fraction", ha="right", fontsize=9)


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
    text = f"{title(scenario, int(frame['step']))}: {len(hops)} hops of {len(paths)} grains"
    figure.suptitle(text, fontsize=10, x=0.01, ha="left")
    return figure
