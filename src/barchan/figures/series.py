"""Measures over time."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.figures.space_time import times_of
from barchan.figures.style import SHADOW, heading, new_figure
from barchan.models import models
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SHOWN = (
    "highest_stack",
    "bedform_height",
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

POSSIBLE = {
    "highest_stack": (0.0, np.inf),
    "bedform_height": (0.0, np.inf),
    "bare_fraction": (0.0, 1.0),
    "spacing": (0.0, np.inf),
    "straightness": (0.0, 1.0),
    "windward_slope": (0.0, 90.0),
    "lee_slope": (0.0, 90.0),
}
"""Least and greatest value that a measure can have; its scale does not go beyond."""

ACROSS = 4
"""Panels side by side."""


def time_series(measured: "xr.Dataset", scenario: Scenario) -> "Figure":
    """A panel for each measure of a run (``analysis.time_series.measure_series``) and of its model.

    A value without neighbours in time, as that of a single frame, is a point.
    """
    names = [*SHOWN, *(own.name for own in models()[scenario.model.name].measures)]
    rows = -(-len(names) // ACROSS)
    figure = new_figure(12.0, 1.0 + 2.0 * rows)
    times, label = times_of(measured)
    panels = figure.subplots(rows, ACROSS, sharex=True, squeeze=False)
    for axes in panels.flat[len(names) :]:
        axes.remove()
    for axes, name in zip(panels.flat, names, strict=False):
        _draw(axes, times, measured[name])
    for axes in panels.flat[len(names) - ACROSS : len(names)]:
        axes.set_xlabel(label, fontsize=8)
        axes.xaxis.set_tick_params(labelbottom=True)
    heading(figure, f"{scenario.title or 'Run'}, seed {scenario.run.seed}")
    return figure


def _draw(axes: "Axes", times: NDArray[np.float64], values: "xr.DataArray") -> None:
    """The panel of a measure."""
    shown, unit = values.values, values.attrs["unit"]
    if values.name == "crest_azimuth":
        shown, middle = about_middle(shown)
        _half_turn(axes, middle)
    axes.plot(times, shown, color=SHADOW, linewidth=1.4)
    lonely = alone(shown)
    if lonely.any():
        axes.plot(times[lonely], shown[lonely], "o", color=SHADOW, markersize=4)
    axes.set_title(values.attrs["long_name"], loc="left", fontsize=9)
    axes.set_ylabel("" if unit == "-" else unit, fontsize=8)
    axes.tick_params(labelsize=8)
    axes.grid(alpha=0.3)
    if not np.isfinite(shown).any():
        axes.set_yticks([])
        axes.text(0.5, 0.5, "no value", transform=axes.transAxes, ha="center", va="center", fontsize=9)
    elif str(values.name) in POSSIBLE:
        within(axes, *POSSIBLE[str(values.name)])
    if len(times) == 1:
        axes.set_xticks(times, [f"{times[0]:g}"])


def alone(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which values have no neighbour that a line could lead to."""
    known = np.concatenate([[False], np.isfinite(values), [False]])
    return known[1:-1] & ~known[:-2] & ~known[2:]


def within(axes: "Axes", least: float, greatest: float) -> None:
    """Keep the margins of a scale within what is possible."""
    low, high = axes.get_ylim()
    low, high = max(low, least), min(high, greatest)
    axes.set_ylim(low, high if high > low else low + 1.0)


def about_middle(
    azimuths: NDArray[np.float64], middle: float | None = None
) -> tuple[NDArray[np.float64], float]:
    """Orientations (degrees) within a quarter turn of ``middle``, and that: their mean to the nearest 45.

    So crests that cross north go on beyond 0 or 180. NaN stays.
    """
    if middle is not None:
        return (azimuths - middle + 90.0) % 180.0 + middle - 90.0, middle
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
