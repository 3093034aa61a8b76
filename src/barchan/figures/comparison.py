"""Pictures of several variants of a run in one: measures over time, slopes, differences of surfaces."""

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.on_squares import on_squares
from barchan.figures.panels import colour_bar, map_panel
from barchan.figures.series import POSSIBLE, SHOWN, about_middle, within
from barchan.figures.style import legend_above, new_figure, smooth
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = ("#2b2620", "#2f6d8c", "#b3402a", "#3f8f5b", "#c28a1e", "#7a4b94", "#d06aa0", "#8c8278")
"""Colours of variants, in order; of two those of the studio's left and right run."""

DASHES = ("-", "--", "-.", ":")
"""Lines of variants, so that they are told apart in print without colours."""

ACROSS = 3

MOST_BESIDE = 34
"""Letters in a line beside the bar of a map of differences."""


@dataclass(frozen=True)
class Course:
    """A measure of one variant over time: a value for each step and seed."""

    label: str
    steps: NDArray[np.float64]
    values: NDArray[np.float64]
    """(seed, step); NaN where there is none."""


def measures_over_time(
    courses: Mapping[str, Sequence[Course]], titles: Mapping[str, tuple[str, str]]
) -> "Figure":
    """A panel for each measure: the mean over seeds of each variant, and the range of the seeds, pale.

    ``courses`` holds the variants of each measure, ``titles`` its title and unit.
    """
    names = [
        name
        for name in SHOWN
        if name in courses and any(np.isfinite(course.values).any() for course in courses[name])
    ]
    rows = max(-(-len(names) // ACROSS), 1)
    figure = new_figure(9.6, 0.6 + 2.1 * rows)
    panels = figure.subplots(rows, ACROSS, squeeze=False, sharex=True)
    for axes in panels.flat[len(names) :]:
        axes.remove()
    for axes, name in zip(panels.flat, names, strict=False):
        _course_panel(axes, name, courses[name], *titles[name])
    for axes in panels.flat[max(len(names) - ACROSS, 0) : len(names)]:
        axes.set_xlabel("step", fontsize=8)
        axes.xaxis.set_tick_params(labelbottom=True)
    handles, labels = panels.flat[0].get_legend_handles_labels()
    legend_above(figure, handles, labels)
    return figure


def _course_panel(axes: "Axes", name: str, courses: Sequence[Course], title: str, unit: str) -> None:
    every = [course.values for course in courses]
    if name == "crest_azimuth":
        middle = about_middle(np.concatenate([values.ravel() for values in every]))[1]
        every = [about_middle(values, middle)[0] for values in every]
    for number, (course, values) in enumerate(zip(courses, every, strict=True)):
        known = np.isfinite(values).any(axis=0)
        if not known.any():
            axes.plot([], [], **style_of(number), label=course.label)
            continue
        steps, shown = course.steps[known], values[:, known]
        axes.fill_between(
            steps,
            np.nanmin(shown, axis=0),
            np.nanmax(shown, axis=0),
            color=style_of(number)["color"],
            alpha=0.18,
            linewidth=0,
        )
        axes.plot(steps, np.nanmean(shown, axis=0), **style_of(number), linewidth=1.4, label=course.label)
    axes.set_title(title, loc="left", fontsize=9)
    axes.set_ylabel("" if unit == "-" else unit, fontsize=8)
    axes.tick_params(labelsize=8)
    axes.grid(alpha=0.3)
    if name in POSSIBLE:
        within(axes, *POSSIBLE[name])


def style_of(number: int) -> dict[str, Any]:
    """Colour and dashes of the variant of that number."""
    return {
        "color": COLOURS[number % len(COLOURS)],
        "linestyle": DASHES[number // len(COLOURS) % len(DASHES) if number >= len(COLOURS) else number % 4],
    }


def slope_distributions(edges: NDArray[np.float64], shares: Mapping[str, NDArray[np.float64]]) -> "Figure":
    """How often the surface rises downwind by how much: mean over seeds, and the range of the seeds, pale.

    ``shares`` holds the shares (seed, interval) of each variant between ``edges`` (degrees).
    """
    figure = new_figure(7.6, 3.6)
    axes = figure.add_subplot()
    middle, width = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
    for number, (label, values) in enumerate(shares.items()):
        density = 100.0 * values / width
        colour = style_of(number)["color"]
        low, high = density.min(axis=0), density.max(axis=0)
        axes.fill_between(middle, low, high, color=colour, alpha=0.18, linewidth=0)
        axes.plot(middle, density.mean(axis=0), **style_of(number), linewidth=1.5, label=label)
    axes.axvline(0.0, color="black", linewidth=0.6)
    axes.set_yscale("log")
    axes.set_ylim(bottom=max(1e-3, axes.get_ylim()[0]))
    axes.set_xlabel("slope along the wind (°): lee sides below 0, windward sides above")
    axes.set_ylabel("share of the field (% per degree)")
    axes.grid(alpha=0.3, which="both", linewidth=0.5)
    legend_above(figure, *axes.get_legend_handles_labels())
    return figure


def difference_map(
    frame: "xr.Dataset", reference: "xr.Dataset", scenario: Scenario, limit: float, label: str
) -> "Figure":
    """How much higher (m) the surface of one frame is than that of another of the same field.

    The colours reach from −``limit`` to ``limit`` (m); the surfaces are smoothed over a cell for display.
    Of a long ``label`` two lines are drawn.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    reference, _ = on_squares(reference, scenario)
    frame, scenario = on_squares(frame, scenario)
    apart = smooth(frame["elevation"].values - reference["elevation"].values, 1.0, scenario)
    scale = ScalarMappable(Normalize(-limit, limit), "RdBu_r")
    figure, axes = map_panel(scenario, frame, scale.to_rgba(apart)[..., :3])
    lines = textwrap.wrap(label, MOST_BESIDE, max_lines=2, placeholder=" …")
    colour_bar(figure, axes, scale, "\n".join(lines), extend="both")
    return figure
