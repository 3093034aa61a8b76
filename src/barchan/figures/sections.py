"""Sections along the wind: profiles with their shadow zones, and their change in time."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import scenario_at
from barchan.directions import downwind
from barchan.fields import depth_of
from barchan.figures.style import (
    CURVE,
    GROUND,
    SAND,
    SHADOW,
    Colours,
    colour_map,
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


@dataclass(frozen=True)
class Section:
    """A line through the field along the wind, from its upwind to its downwind end."""

    rows: NDArray[np.int64]
    cols: NDArray[np.int64]
    distance: NDArray[np.float64]
    """Distance (m) along the wind from the line's upwind end."""
    joined: bool
    """Whether the line closes on itself across a periodic edge."""


def section_along_wind(scenario: Scenario, direction: float, at: float) -> Section:
    """The section that crosses the field's middle line at ``at`` (0 to 1, to the wind's left growing).

    Along a lattice axis it is a whole row or column; for an oblique wind it is the cells nearest to a
    line from edge to edge.
    """
    if not 0 <= at <= 1:
        raise ValueError(f"a section lies at {at:g}; allowed: 0 to 1")
    lattice = scenario.lattice
    x, y = downwind(direction)
    rows, cols = lattice.shape
    width, depth = cols - 1, rows - 1
    across = (at - 0.5) * (abs(x) * depth + abs(y) * width)
    middle = np.array([depth / 2 + x * across, width / 2 - y * across])
    reach = float(np.hypot(rows, cols))
    line = np.arange(-reach, reach + 0.5, 0.5 if min(abs(x), abs(y)) > 1e-9 else 1.0)
    start = middle + np.outer(line, (y, x))
    if abs(x) > 1 - 1e-9 or abs(y) > 1 - 1e-9:
        start = np.round(start - middle + np.round(middle))
    cells = np.rint(start).astype(np.int64)
    inside = ((cells >= 0) & (cells < (rows, cols))).all(axis=1)
    cells = cells[inside]
    fresh = np.ones(len(cells), bool)
    fresh[1:] = (np.diff(cells, axis=0) != 0).any(axis=1)
    cells = cells[fresh]
    along = (cells - cells[0]) @ (y, x) * lattice.cell_size
    straight = min(abs(x), abs(y)) < 1e-9
    boundary = lattice.boundary_x if abs(x) > abs(y) else lattice.boundary_y
    return Section(cells[:, 0], cells[:, 1], along, straight and boundary == "periodic")


def shadow_line(
    section: Section, surface: NDArray, angle: float, cell_size: float, start: float = 0.0
) -> NDArray[np.float64]:
    """Height (m) of the shadow line over each point of a section; below the surface where it is lit.

    Lines fall at ``angle`` (degrees) from ``start`` cells downwind of each cell's centre.
    """
    distance = section.distance
    slope = np.tan(np.radians(angle))
    if section.joined:
        length = distance[-1] + cell_size
        distance = np.concatenate([distance - length, distance])
        surface = np.concatenate([surface, surface])
    tilted = np.maximum.accumulate(surface + slope * distance)
    line = np.empty_like(tilted)
    line[0] = -np.inf
    line[1:] = tilted[:-1]
    line += slope * (start * cell_size - distance)
    return line[-len(section.distance) :]


def profile(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    at: float | None = None,
    smoothing: float = 0.0,
    field: "xr.DataArray | None" = None,
) -> "Figure":
    """The section along the wind through the highest stack, or at ``at``, its shadow zones shaded.

    A ``field`` of the frame (see ``analysis.fields.field_of``) is drawn along the section below it.
    """
    direction = float(frame["wind_direction"])
    section = section_along_wind(scenario, direction, _through_highest(frame, scenario) if at is None else at)
    ground = frame["ground"].values[section.rows, section.cols]
    surface = smooth(frame["elevation"].values, smoothing, scenario)[section.rows, section.cols]
    line = _shadow(section, surface, scenario_at(frame, scenario))
    if field is None:
        figure = new_figure(9.0, 3.0)
        axes = lowest = figure.add_subplot()
    else:
        figure = new_figure(9.0, 5.0)
        axes, lowest = figure.subplots(2, sharex=True)
        _draw_field(lowest, section, line > surface, field, scenario, max(smoothing, CURVE_SMOOTHING))
    _draw_sand(axes, section, ground, surface, line)
    lowest.set_xlabel("distance downwind (m)")
    axes.set_title(title(scenario, int(frame["step"])), loc="left", fontsize=10)
    axes.annotate("wind →", (1.0, 1.02), xycoords="axes fraction", ha="right", fontsize=9)
    axes.legend(
        loc="lower right", bbox_to_anchor=(0.92, 1.01), fontsize=8, frameon=False, ncols=2, borderaxespad=0
    )
    return figure


def _draw_sand(axes: "Axes", section: Section, ground: NDArray, surface: NDArray, line: NDArray) -> None:
    """Ground and sand of a section, and the area below the shadow line."""
    axes.fill_between(
        section.distance, ground.min() - 0.1 * np.ptp(surface), ground, color=GROUND, step="mid"
    )
    axes.fill_between(section.distance, ground, surface, color=SAND, step="mid", label="sand")
    axes.fill_between(
        section.distance,
        surface,
        np.maximum(line, surface),
        where=line > surface,
        color=SHADOW,
        alpha=0.35,
        step="mid",
        linewidth=0,
        label="shadow zone",
    )
    axes.margins(x=0)
    axes.set_ylabel("elevation (m)")


def _draw_field(
    axes: "Axes",
    section: Section,
    sheltered: NDArray[np.bool_],
    field: "xr.DataArray",
    scenario: Scenario,
    smoothing: float,
) -> None:
    """A field along a section, cell by cell (pale) and smoothed, over shadow zones and its centre.

    The curve of a field that is 0 in shadow is that of the cells in the wind, with gaps where most are not.
    """
    from matplotlib.transforms import blended_transform_factory

    axes.fill_between(
        section.distance,
        0,
        1,
        where=sheltered,
        transform=blended_transform_factory(axes.transData, axes.transAxes),
        color=SHADOW,
        alpha=0.15,
        step="mid",
        linewidth=0,
    )
    centre = field.attrs.get("centre")
    if centre is not None:
        axes.axhline(centre, color="black", linewidth=0.8, linestyle="--")
    cells = field.values[section.rows, section.cols].astype(float)
    curve = smooth(field.values, smoothing, scenario)
    label = f"smoothed over {smoothing:g} cells"
    if field.attrs.get("sheltered"):
        share = smooth(field.values != 0, smoothing, scenario)
        curve = np.divide(curve, share, out=np.full(curve.shape, np.nan), where=share > HALF)
        label += " in the wind"
    axes.step(
        section.distance, cells, where="mid", color=CURVE, linewidth=0.7, alpha=0.4, label="single cells"
    )
    axes.plot(section.distance, curve[section.rows, section.cols], color=CURVE, linewidth=1.6, label=label)
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1), fontsize=8, frameon=False, ncols=2, borderaxespad=0)
    axes.set_ylabel(label_of(field))
    axes.margins(x=0)
    axes.grid(alpha=0.3)


def _shadow(section: Section, surface: NDArray, scenario: Scenario) -> NDArray[np.float64]:
    """The shadow line of a scenario's model; a model without shadows has none."""
    angle = getattr(scenario.model, "shadow_angle", None)
    if angle is None:
        return np.full(len(surface), -np.inf)
    start = 0.5 if getattr(scenario.model, "shadow_from", "centre") == "edge" else 0.0
    return shadow_line(section, surface, angle, scenario.lattice.cell_size, start)


def space_time(
    dataset: "xr.Dataset", scenario: Scenario, *, at: float | None = None, colours: Colours = "perceptual"
) -> "Figure":
    """The section along the wind through the last frame's highest stack, or at ``at``, over time."""
    last = dataset.isel(step=-1)
    direction = float(last["wind_direction"])
    section = section_along_wind(scenario, direction, _through_highest(last, scenario) if at is None else at)
    surface = np.stack(
        [dataset["elevation"][k].values[section.rows, section.cols] for k in range(dataset.sizes["step"])]
    )
    figure = new_figure(7.2, 5.0)
    axes = figure.add_subplot()
    steps = dataset["step"].values
    image = axes.pcolormesh(section.distance, steps, surface, cmap=colour_map(colours), shading="nearest")
    if len(steps) > 1:
        axes.set_ylim(steps[0], steps[-1])
    axes.set_xlabel("distance downwind (m)")
    axes.set_ylabel("step")
    axes.set_title(f"{scenario.title or 'Run'}, seed {scenario.run.seed}", loc="left", fontsize=10)
    axes.annotate("wind →", (1.0, 1.02), xycoords="axes fraction", ha="right", fontsize=9)
    figure.colorbar(image, ax=axes, label="elevation (m)")
    return figure


def _through_highest(frame: "xr.Dataset", scenario: Scenario) -> float:
    """Where the section lies that crosses the highest stack."""
    depth = depth_of(scenario.layers, frame, scenario.lattice.thickness).values
    row, col = np.unravel_index(int(np.argmax(depth)), depth.shape)
    rows, cols = scenario.lattice.shape
    x, y = downwind(float(frame["wind_direction"]))
    across = x * (row - (rows - 1) / 2) - y * (col - (cols - 1) / 2)
    width = abs(x) * (rows - 1) + abs(y) * (cols - 1)
    return float(np.clip(0.5 + across / width, 0.0, 1.0)) if width else 0.5
