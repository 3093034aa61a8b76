"""A section along the wind over time."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.on_squares import field_on_squares, on_squares
from barchan.figures.section_lines import section_along_wind, through_highest
from barchan.figures.sections import section_heading
from barchan.figures.style import TITLE, Colours, colour_map, in_lines, material_of, new_figure
from barchan.scenario import Scenario
from barchan.wind.clock import suited_unit

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


WIDTH, TITLED, SECTION = 7.2, 6.5, 5.5
"""Widths (inches) of the figure, of what a title may take of it, and of the section by itself, about."""


def space_time(
    dataset: "xr.Dataset", scenario: Scenario, *, at: float | None = None, colours: Colours = "natural"
) -> "Figure":
    """The section along the wind through the last frame's highest stack, or at ``at``, over time.

    Time is that of the clock, in the unit that suits it, where the frames carry one, else steps.
    """
    last, square = on_squares(dataset.isel(step=-1).load(), scenario)
    direction = float(last["wind_direction"])
    section = section_along_wind(square, direction, through_highest(last, square) if at is None else at)
    surface = np.stack(
        [
            field_on_squares(dataset["elevation"][k], scenario).values[section.rows, section.cols]
            for k in range(dataset.sizes["step"])
        ]
    )
    text = f"{scenario.title or 'Run'}, seed {scenario.run.seed}\n{section.place}"
    edges = section.edges(scenario.lattice.cell_size)
    figure = section_over_time(edges, times_of(dataset), surface, scenario, text, colours)
    axes = figure.axes[0]
    axes.set_xlabel("distance downwind (m)")
    section_heading(axes, text, direction, SECTION)
    return figure


def section_over_time(
    edges: NDArray[np.float64],
    times: tuple[NDArray[np.float64], str],
    surface: NDArray[np.float64],
    scenario: Scenario,
    text: str,
    colours: Colours = "natural",
    limits: tuple[float, float] | None = None,
) -> "Figure":
    """Elevations (m) along any line over time, a row of ``surface`` for each of the ``times``.

    ``edges`` (m along the line) are one more than the places of a row; ``text`` stands above.
    Colours reach from the lowest to the highest elevation, or from one of the ``limits`` (m) to the other.
    """
    moments, label = times
    figure = new_figure(WIDTH, 5.0)
    axes = figure.add_subplot()
    image = axes.pcolormesh(
        edges, _between(moments), surface, cmap=colour_map(colours, material_of(scenario))
    )
    low, high = limits or (float(surface.min()), float(surface.max()))
    image.set_clim(low, high if high > low else low + scenario.lattice.thickness)
    axes.set_xlabel("distance along the section (m)")
    axes.set_ylabel(label)
    if len(moments) == 1:
        axes.set_yticks(moments, [f"{moments[0]:g}"])
    axes.set_title(in_lines(text, TITLED), loc="left", fontsize=TITLE)
    figure.colorbar(image, ax=axes, label="elevation (m)")
    return figure


def times_of(dataset: "xr.Dataset") -> tuple[NDArray[np.float64], str]:
    """When frames were taken; see ``suited_times``."""
    seconds = dataset["time"].values if "time" in dataset.coords else None
    return suited_times(dataset["step"].values, seconds)


def suited_times(
    steps: NDArray[np.int64], seconds: NDArray[np.float64] | None
) -> tuple[NDArray[np.float64], str]:
    """Moments in the unit of time that suits the last one, or in steps, and the label of their axis."""
    if seconds is None:
        return np.asarray(steps, float), "step"
    unit, length = suited_unit(float(seconds[-1]))
    return seconds / length, f"time ({unit})"


def _between(times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Edges of the bands of frames: half way to the neighbours; a single frame has a band of one unit."""
    if len(times) == 1:
        return times[0] + np.array([-0.5, 0.5])
    between = (times[1:] + times[:-1]) / 2
    return np.concatenate([[2 * times[0] - between[0]], between, [2 * times[-1] - between[-1]]])
