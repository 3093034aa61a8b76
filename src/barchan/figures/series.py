"""Measures over time."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.figures.style import SHADOW, new_figure
from barchan.models import models
from barchan.scenario import Scenario
from barchan.wind.clock import suited_unit

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SHOWN = (
    "highest_stack",
    "bare_fraction",
    "spacing",
    "straightness",
    "crest_azimuth",
    "speed",
    "windward_slope",
    "lee_slope",
    "flux",
)

"""Measures of any run that have a panel."""

ACROSS = 3
"""Panels side by side."""


def time_series(measured: "xr.Dataset", scenario: Scenario) -> "Figure":
    """A panel for each measure of a run (``analysis.time_series.measure_series``) and of its model."""
    names = [*SHOWN, *(own.name for own in models()[scenario.model.name].measures)]
    rows = -(-len(names) // ACROSS)
    figure = new_figure(10.0, 1.0 + 2.0 * rows)
    times, unit_of_time = measured["step"], "step"
    if "time" in measured.coords:
        unit_of_time, length = suited_unit(float(measured["time"][-1]))
        times = measured["time"] / length
    panels = figure.subplots(rows, ACROSS, sharex=True)
    for axes in panels.flat[len(names) :]:
        axes.remove()
    for axes, name in zip(panels.flat, names, strict=False):
        values = measured[name]
        shown = values.values
        if name == "crest_azimuth":
            shown, middle = about_middle(shown)
            _half_turn(axes, middle)
        axes.plot(times, shown, color=SHADOW, linewidth=1.4)
        unit = values.attrs["unit"]
        axes.set_title(values.attrs["long_name"], loc="left", fontsize=9)
        axes.set_ylabel("" if unit == "-" else unit, fontsize=8)
        axes.tick_params(labelsize=8)
        axes.grid(alpha=0.3)
    for axes in panels.flat[len(names) - ACROSS : len(names)]:
        axes.set_xlabel(unit_of_time, fontsize=8)
        axes.xaxis.set_tick_params(labelbottom=True)
    figure.suptitle(f"{scenario.title or 'Run'}, seed {scenario.run.seed}", fontsize=10, x=0.01, ha="left")
    return figure


def about_middle(azimuths: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """Orientations (degrees) within a quarter turn of their mean, and that mean to the nearest 45 degrees.

    So crests that cross north go on beyond 0 or 180. NaN stays.
    """
    known = np.radians(2 * azimuths[np.isfinite(azimuths)])
    mean = (
        np.degrees(np.arctan2(np.sin(known).sum(), np.cos(known).sum())) / 2 % 180.0 if known.size else 90.0
    )
    middle = 45.0 * round(float(mean) / 45.0)
    return (azimuths - middle + 90.0) % 180.0 + middle - 90.0, middle


def _half_turn(axes: "Axes", middle: float) -> None:
    """An axis of half a turn, labelled from 0 to 180."""
    axes.set_ylim(middle - 90.0, middle + 90.0)
    ticks = middle + np.arange(-90.0, 91.0, 45.0)
    axes.set_yticks(ticks, [f"{tick % 180.0:g}" for tick in ticks])
