"""The curves among a model's parameters, such as the growth of plants against the sand they get."""

from collections.abc import Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from barchan.figures.style import new_figure
from barchan.models import Curve, models
from barchan.scenario import Scenario

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def curves_of(curves: Sequence[Curve], scenario: Scenario) -> "Figure":
    """Curves, with those of the same two quantities in one panel; a remark stands in the legend.

    Curves with a remark are dashed, to mark a doubt.
    """
    panels = [list(panel) for _, panel in groupby(curves, lambda curve: (curve.x_title, curve.y_title))]
    figure = new_figure(7.2, 0.6 + 3.6 * len(panels))
    for axes, panel in zip(figure.subplots(len(panels), squeeze=False).flat, panels, strict=True):
        for curve in panel:
            label = f"{curve.title} ({curve.remark})" if curve.remark else curve.title
            style = "--" if curve.remark else "-"
            axes.plot(curve.x, curve.y, style, marker="o", markersize=4, linewidth=1.6, label=label)
        axes.axhline(0.0, color="black", linewidth=0.8)
        axes.axvline(0.0, color="black", linewidth=0.8)
        axes.set_xlabel(panel[0].x_title)
        axes.set_ylabel(panel[0].y_title)
        axes.grid(alpha=0.3)
        axes.legend(fontsize=9)
    name = scenario.title or "Curves"
    figure.suptitle(f"{name}: {models()[scenario.model.name].title}", fontsize=10, x=0.01, ha="left")
    return figure
