"""A section along the wind over time."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.on_squares import field_on_squares, on_squares
from barchan.figures.section_lines import section_along_wind, through_highest
from barchan.figures.sections import section_heading
from barchan.figures.style import Colours, colour_map, material_of, new_figure
from barchan.scenario import Scenario
from barchan.wind.clock import suited_unit

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


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
    times, label = times_of(dataset)
    figure = new_figure(7.2, 5.0)
    axes = figure.add_subplot()
    edges = section.edges(scenario.lattice.cell_size)
    image = axes.pcolormesh(edges, _between(times), surface, cmap=colour_map(colours, material_of(scenario)))
    if surface.min() == surface.max():
        image.set_clim(float(surface.min()), float(surface.min()) + scenario.lattice.thickness)
    axes.set_xlabel("distance downwind (m)")
    axes.set_ylabel(label)
    if len(times) == 1:
        axes.set_yticks(times, [f"{times[0]:g}"])
    text = f"{scenario.title or 'Run'}, seed {scenario.run.seed}\n{section.place}"
    section_heading(axes, text, direction)
    figure.colorbar(image, ax=axes, label="elevation (m)")
    return figure


def times_of(dataset: "xr.Dataset") -> tuple[NDArray[np.float64], str]:
    """When frames were taken, in the unit of time that suits the run or in steps, and the axis's label."""
    if "time" not in dataset.coords:
        return dataset["step"].values.astype(float), "step"
    unit, length = suited_unit(float(dataset["time"][-1]))
    return dataset["time"].values / length, f"time ({unit})"


def _between(times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Edges of the bands of frames: half way to the neighbours; a single frame has a band of one unit."""
    if len(times) == 1:
        return times[0] + np.array([-0.5, 0.5])
    between = (times[1:] + times[:-1]) / 2
    return np.concatenate([[2 * times[0] - between[0]], between, [2 * times[-1] - between[-1]]])
