"""A model's curves: its closures, and curves among its parameters such as the growth of plants."""

from collections.abc import Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from barchan.figures.style import new_figure
from barchan.models import Curve, models
from barchan.scenario import Scenario

if TYPE_CHECKING:
    from matplotlib.figure import Figure


MARKED = 30
"""Points that a curve has at most when each is marked."""

MANY = 4
"""Panels from which on they stand in two columns."""


def curves_of(curves: Sequence[Curve], scenario: Scenario) -> "Figure":
    """Curves, with those of the same two quantities in one panel, and their sources over it.

    Curves with a remark are dashed, to mark a doubt; the remark stands in the legend. Points of curves that
    have few are marked. Four panels or more stand in two columns.
    """
    panels = [list(panel) for _, panel in groupby(curves, lambda curve: (curve.x_title, curve.y_title))]
    across = 1 if len(panels) < MANY else 2
    down = -(-len(panels) // across)
    figure = new_figure(7.2 * across, 0.6 + 3.6 * down)
    places = figure.subplots(down, across, squeeze=False).flat
    for axes in places[len(panels) :]:
        axes.remove()
    for axes, panel in zip(places[: len(panels)], panels, strict=True):
        for curve in panel:
            label = f"{curve.title} ({curve.remark})" if curve.remark else curve.title
            style = "--" if curve.remark else "-"
            marker = "o" if len(curve.x) <= MARKED else None
            axes.plot(curve.x, curve.y, style, marker=marker, markersize=4, linewidth=1.6, label=label)
        if sources := "; ".join(dict.fromkeys(curve.source for curve in panel if curve.source)):
            axes.set_title(sources, fontsize=8, loc="left")
        if panel[0].log_x:
            axes.set_xscale("log")
        else:
            axes.axvline(0.0, color="black", linewidth=0.8)
        if min(min(curve.y) for curve in panel) <= 0.0:
            axes.axhline(0.0, color="black", linewidth=0.8)
        axes.set_xlabel(panel[0].x_title)
        axes.set_ylabel(panel[0].y_title)
        axes.grid(alpha=0.3)
        axes.legend(fontsize=9)
    name = scenario.title or "Curves"
    figure.suptitle(f"{name}: {models()[scenario.model.name].title}", fontsize=10, x=0.01, ha="left")
    return figure
