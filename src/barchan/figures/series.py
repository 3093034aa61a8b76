"""Measures over time."""

from typing import TYPE_CHECKING

from barchan.figures.style import new_figure
from barchan.scenario import Scenario
from barchan.wind.clock import suited_unit

if TYPE_CHECKING:
    import xarray as xr
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


def time_series(course: "xr.Dataset", scenario: Scenario) -> "Figure":
    """A panel for each measure of a run's course (see ``analysis.course``)."""
    figure = new_figure(10.0, 7.0)
    times, unit_of_time = course["step"], "step"
    if "time" in course.coords:
        unit_of_time, length = suited_unit(float(course["time"][-1]))
        times = course["time"] / length
    panels = figure.subplots(3, 3, sharex=True)
    for axes, name in zip(panels.flat, SHOWN, strict=True):
        values = course[name]
        angle = name == "crest_azimuth"
        axes.plot(times, values, "." if angle else "-", color="#35507a", linewidth=1.4)
        unit = values.attrs["unit"]
        axes.set_title(values.attrs["long_name"], loc="left", fontsize=9)
        axes.set_ylabel("" if unit == "-" else unit, fontsize=8)
        axes.tick_params(labelsize=8)
        axes.grid(alpha=0.3)
        if angle:
            axes.set_ylim(0, 180)
            axes.set_yticks([0, 45, 90, 135, 180])
    for axes in panels[-1]:
        axes.set_xlabel(unit_of_time, fontsize=8)
    figure.suptitle(f"{scenario.title or 'Run'}, seed {scenario.run.seed}", fontsize=10, x=0.01, ha="left")
    return figure
