"""Sections along the wind: the sand, its ground and its shadow zones, and a field below them."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import scenario_at
from barchan.analysis.on_squares import field_on_squares, on_squares
from barchan.figures.bare import STANDING, standing_cells
from barchan.figures.section_lines import Section, model_shadow, section_along_wind, through_highest
from barchan.figures.strata import draw_strata
from barchan.figures.style import (
    CURVE,
    GROUND,
    SAND,
    SHADOW,
    TITLE,
    in_lines,
    label_of,
    new_figure,
    smooth,
    title,
)
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

CURVE_SMOOTHING = 2.0
"""Cells over which a field's curve is smoothed at least: single cells stand in each other's shadow."""

HALF = 0.5
"""Fraction of unsheltered cells below which the curve of a field that is 0 in shadow has a gap."""

LONG, HIGH = 7.6, 2.2
"""Length and height (inches) of a section, about."""

WIND = 1.4
"""Width (inches) of the words that say where the wind comes from, with room before them."""

EXAGGERATIONS = (1, 1.5, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100, 150, 200, 300, 500, 700, 1000)
"""Vertical exaggerations of sections."""

DEEP, AIR = 0.12, 0.08
"""Shares of the relief that a section shows of the ground below the lowest, and of the air above."""

LEAST = 0.2
"""Relief that a section shows at least, in cells."""


def profile(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    at: float | None = None,
    smoothing: float = 0.0,
    field: "xr.DataArray | None" = None,
    strata: str | None = None,
) -> "Figure":
    """The section along the wind through the highest stack, or at ``at``, its shadow zones shaded.

    The title says where it lies and how much it exaggerates heights. A ``field`` of the frame (see
    ``analysis.fields.field_of``) is drawn along the section below it. Layers have the colour of the model's
    ``strata`` of that name, by default its first; raises BarchanError where it has none of that name.
    """
    field = None if field is None else field_on_squares(field, scenario)
    frame, scenario = on_squares(frame, scenario)
    direction = float(frame["wind_direction"])
    section = section_along_wind(scenario, direction, through_highest(frame, scenario) if at is None else at)
    ground = frame["ground"].values[section.rows, section.cols]
    surface = smooth(frame["elevation"].values, smoothing, scenario)[section.rows, section.cols]
    line = model_shadow(section, surface, scenario_at(frame, scenario))
    edges = section.edges(scenario.lattice.cell_size)
    lattice = scenario.lattice
    bottom, top = shown_heights(ground, surface, max(lattice.thickness, LEAST * lattice.cell_size))
    exaggeration, span = _scales(edges, top - bottom)
    drawn = LONG * exaggeration * (top - bottom) / (span[1] - span[0])
    if field is None:
        figure = new_figure(LONG + 1.2, drawn + 1.4)
        axes = lowest = figure.add_subplot()
    else:
        figure = new_figure(LONG + 1.2, drawn + 3.2)
        axes, lowest = figure.subplots(2, sharex=True, height_ratios=(drawn, 1.8))
        _draw_field(lowest, section, line > surface, field, scenario, max(smoothing, CURVE_SMOOTHING))
    axes.set_aspect(exaggeration)
    axes.set_ylim(bottom, top)
    draw_ground(axes, edges, ground, bottom, scenario, section)
    if draw_strata(figure, axes, frame, scenario, section, edges, strata):
        draw_shadow(axes, edges, surface, line)
    else:
        draw_sand(axes, edges, ground, surface, line)
    axes.set_xlim(span)
    axes.set_ylabel("elevation (m)")
    lowest.set_xlabel("distance downwind (m)")
    text = f"{title(scenario, int(frame['step']))}\n{section.place}, vertical exaggeration {exaggeration:g}"
    section_heading(axes, text, direction)
    return figure


def section_heading(axes: "Axes", text: str, direction: float, width: float = LONG) -> None:
    """A title above a section, the wind at its right end, and names of its colours beside.

    ``width`` (inches) is about that of the axes; lines that would run into the wind are broken.
    """
    axes.set_title(in_lines(text, width - WIND), loc="left", fontsize=TITLE)
    wind = f"wind from {direction:.4g}° →"
    axes.annotate(
        wind, (1, 1), (0, 19), xycoords="axes fraction", textcoords="offset points", ha="right", fontsize=9
    )
    if axes.get_legend_handles_labels()[0]:
        axes.legend(
            loc="lower right", bbox_to_anchor=(1, 1), fontsize=8, frameon=False, ncols=4, borderaxespad=0.2
        )


def shown_heights(ground: NDArray, surface: NDArray, least: float) -> tuple[float, float]:
    """Lowest and highest elevation that a section shows; ``least`` is the relief that it shows at least.

    Of sand much deeper than its surface is uneven, only the upper part.
    """
    low, high = float(ground.min()), float(surface.max())
    uneven = float(np.ptp(surface))
    if uneven >= least:
        low = max(low, float(surface.min()) - uneven)
    relief = max(high - low, least)
    return low - DEEP * relief, low + (1 + AIR) * relief


def _scales(edges: NDArray[np.float64], height: float) -> tuple[float, tuple[float, float]]:
    """The greatest round vertical exaggeration with which a section is not higher than ``HIGH``.

    And its span (m), which goes beyond the ends of a section that is shorter than high.
    """
    length = max(edges[-1] - edges[0], LONG / HIGH * height)
    middle = (edges[0] + edges[-1]) / 2
    most = (HIGH / height) / (LONG / length) * (1 + 1e-9)
    factor = max(factor for factor in EXAGGERATIONS if factor <= most)
    return factor, (middle - length / 2, middle + length / 2)


def draw_ground(
    axes: "Axes",
    edges: NDArray[np.float64],
    ground: NDArray,
    bottom: float,
    scenario: Scenario,
    section: Section,
) -> None:
    """The ground of a section, and the rocks or stems that stand on it."""
    shown = np.maximum(ground, bottom)
    axes.stairs(shown, edges, baseline=bottom, fill=True, color=GROUND)
    standing = standing_cells(scenario)[section.rows, section.cols]
    if standing.any():
        name = scenario.ground.standing
        tops = np.where(standing, shown, np.nan)
        axes.stairs(tops, edges, baseline=bottom, fill=True, color=STANDING[name], label=name)


def draw_sand(
    axes: "Axes", edges: NDArray[np.float64], ground: NDArray, surface: NDArray, line: NDArray
) -> None:
    """The sand of a section where there is any, and the area below the shadow line."""
    sand = surface > ground
    if sand.any():
        tops = np.where(sand, surface, np.nan)
        axes.stairs(tops, edges, baseline=ground, fill=True, color=SAND, label="sand")
    draw_shadow(axes, edges, surface, line)


def draw_shadow(axes: "Axes", edges: NDArray[np.float64], surface: NDArray, line: NDArray) -> None:
    """The area below the shadow line."""
    shadow = line > surface
    if shadow.any():
        tops = np.where(shadow, line, np.nan)
        axes.stairs(
            tops,
            edges,
            baseline=surface,
            fill=True,
            facecolor=SHADOW,
            alpha=0.35,
            linewidth=0,
            label="shadow zone",
        )


def _draw_field(
    axes: "Axes",
    section: Section,
    sheltered: NDArray[np.bool_],
    field: "xr.DataArray",
    scenario: Scenario,
    smoothing: float,
) -> None:
    """A field along a section, cell by cell (pale) and smoothed, over shadow zones and its centre."""
    from matplotlib.transforms import blended_transform_factory

    axes.stairs(
        np.where(sheltered, 1.0, np.nan),
        section.edges(scenario.lattice.cell_size),
        transform=blended_transform_factory(axes.transData, axes.transAxes),
        fill=True,
        facecolor=SHADOW,
        alpha=0.15,
        linewidth=0,
    )
    centre = field.attrs.get("centre")
    if centre is not None:
        axes.axhline(centre, color="black", linewidth=0.8, linestyle="--")
    cells = field.values[section.rows, section.cols].astype(float)
    curve, label = _curve(field, scenario, smoothing)
    axes.step(
        section.distance, cells, where="mid", color=CURVE, linewidth=0.7, alpha=0.4, label="single cells"
    )
    axes.plot(section.distance, curve[section.rows, section.cols], color=CURVE, linewidth=1.6, label=label)
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1), fontsize=8, frameon=False, ncols=2, borderaxespad=0)
    if field.values.dtype == bool:
        axes.set_ylim(-0.05, 1.05)
        axes.set_yticks([0.0, 1.0], ["no", "yes"])
    axes.set_ylabel(label_of(field))
    axes.grid(alpha=0.3)


def _curve(field: "xr.DataArray", scenario: Scenario, smoothing: float) -> tuple[NDArray[np.float64], str]:
    """A field smoothed, and the curve's name; of one that is 0 in shadow, from the cells in the wind alone.

    That has gaps (NaN) where most cells stand in shadow.
    """
    curve = smooth(field.values, smoothing, scenario)
    label = f"smoothed over {smoothing:g} cells"
    if not field.attrs.get("sheltered"):
        return curve, label
    share = smooth(field.values != 0, smoothing, scenario)
    curve = np.divide(curve, share, out=np.full(curve.shape, np.nan), where=share > HALF)
    return curve, f"{label} in the wind"
