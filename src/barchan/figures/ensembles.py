"""Pictures of many runs: small maps side by side, and measures over the parameters that were varied."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from barchan.errors import BarchanError
from barchan.figures.maps import elevation_range, shaded
from barchan.figures.style import CURVE, SHADOW, SMOOTHING, extent, heading, in_lines, new_figure
from barchan.scenario import Scenario
from barchan.words import spoken_name

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MOST_PANELS = 100

PANEL = 1.9
"""Inches that a small map is wide."""

MOST_HIGH = 3.0
"""Height over width of a small map at most; fields that are narrower have narrower maps."""

TITLED = 8.0
"""Size (points) of the letters above a small map."""

MEAN, SPREAD, COUNT = " mean", " spread", " count"
"""Columns of means over realizations; no key is named like them."""

MOST_WRITTEN = 80
"""Cells of a phase diagram up to which each carries its value."""


@dataclass(frozen=True)
class Panel:
    """One small map."""

    title: str
    frame: "xr.Dataset"
    scenario: Scenario


def small_multiples(panels: Sequence[Panel], across: int, text: str) -> "Figure":
    """Hill-shaded maps of the last frames of many runs, ``across`` in a row, all with one colour scale.

    Raises BarchanError for more than ``MOST_PANELS``, or none.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    from barchan.figures.style import colour_map, material_of

    if not 1 <= len(panels) <= MOST_PANELS:
        raise BarchanError(f"{len(panels)} maps side by side; allowed: 1 to {MOST_PANELS}")
    ranges = [elevation_range(panel.frame) for panel in panels]
    low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
    norm = Normalize(low, high if high > low else low + panels[0].scenario.lattice.thickness)
    down = -(-len(panels) // across)
    field = panels[0].scenario.lattice
    shape = field.height / field.width
    height = min(max(shape, 0.3), MOST_HIGH) * PANEL
    titles = [in_lines(panel.title, PANEL, TITLED) for panel in panels]
    above = 0.3 + max(title.count("\n") for title in titles) * 1.3 * TITLED / 72
    width = max(PANEL * across, 3.4) + 1.2
    # Narrow maps keep their distance, for their titles are wider than they are.
    figure = new_figure(width, (height + above) * down + 0.6, of_map=shape <= MOST_HIGH)
    grid = figure.subplots(down, across, squeeze=False)
    for axes in grid.flat[len(panels) :]:
        axes.remove()
    for axes, panel, title in zip(grid.flat, panels, titles, strict=False):
        image = shaded(panel.frame, panel.scenario, norm=norm, smoothing=SMOOTHING)
        axes.imshow(image, origin="lower", extent=extent(panel.scenario), interpolation="nearest")
        axes.set_title(title, fontsize=TITLED, loc="left")
        axes.set_xticks([])
        axes.set_yticks([])
    if text:
        heading(figure, text)
    scale = ScalarMappable(norm, colour_map("natural", material_of(panels[0].scenario)))
    shown = [axes for axes in grid.flat if axes.figure is not None]
    figure.colorbar(scale, ax=shown, label="elevation of the sand (m)", shrink=min(1.0, 2.5 / down))
    return figure


def phase_diagram(table: "pd.DataFrame", measure: str, unit: str, over: Sequence[str]) -> "Figure":
    """A measure over one parameter (with its spread over realizations) or two (in colour).

    ``table`` has a column for the measure and one for each parameter in ``over``; realizations are averaged.
    Raises BarchanError where the table has no such measure, or for other numbers of parameters.
    """
    if measure not in table:
        raise BarchanError(
            f"no measure '{measure}'; there are {', '.join(map(str, table.attrs.get('units', {})))}"
        )
    if not 1 <= len(over) <= 2:
        raise BarchanError(f"a measure is drawn over 1 or 2 parameters, not {len(over)}")
    known = table.dropna(subset=[measure])
    means = (
        known.groupby(list(over), sort=True)[measure]
        .agg(**{MEAN: "mean", SPREAD: "std", COUNT: "count"})
        .reset_index()
    )
    figure = new_figure(6.2, 4.6)
    axes = figure.add_subplot()
    label = spoken_name(measure) + ("" if unit in ("-", "") else f" ({unit})")
    if len(over) == 1:
        _line(axes, means, over[0], label)
    elif _is_grid(means, over):
        _cells(axes, means, over, label)
    else:
        _scatter(axes, means, over, label)
    axes.set_xlabel(over[0])
    realizations = int(means[COUNT].max()) if len(means) else 0
    heading(
        figure, f"{label}, mean of {realizations} realization{'s' * (realizations != 1)} in the last frame"
    )
    return figure


def _line(axes: "Axes", means: "pd.DataFrame", name: str, label: str) -> None:
    spread = means[SPREAD].fillna(0.0)
    x = means[name]
    if x.dtype.kind not in "if":
        x = np.arange(len(means))
        axes.set_xticks(x, means[name].astype(str))
    axes.errorbar(x, means[MEAN], spread, color=SHADOW, marker="o", markersize=4, capsize=3)
    axes.set_ylabel(label)
    axes.grid(alpha=0.3)


def _is_grid(means: "pd.DataFrame", over: Sequence[str]) -> bool:
    """Whether the points fill at least half of the grid of their values."""
    full = math.prod(means[name].nunique() for name in over)
    return len(means) > full / 2 or any(means[name].dtype.kind not in "if" for name in over)


def _cells(axes: "Axes", means: "pd.DataFrame", over: Sequence[str], label: str) -> None:
    """A cell for each pair of values, evenly wide, with its mean and its spread written in."""
    table = means.pivot_table(index=over[1], columns=over[0], values=MEAN)
    spread = means.fillna({SPREAD: 0.0}).pivot_table(index=over[1], columns=over[0], values=SPREAD)
    image = axes.imshow(table.values, origin="lower", aspect="auto", cmap=_colours())
    axes.set_xticks(range(table.shape[1]), [_short(v) for v in table.columns])
    axes.set_yticks(range(table.shape[0]), [_short(v) for v in table.index])
    axes.set_ylabel(over[1])
    axes.figure.colorbar(image, ax=axes, label=label)
    if table.size > MOST_WRITTEN:
        return
    middle = (np.nanmin(table.values) + np.nanmax(table.values)) / 2
    for (row, column), value in np.ndenumerate(table.values.astype(float)):
        if math.isfinite(value):
            more = f"\n± {spread.values[row, column]:.2g}" if spread.values[row, column] > 0 else ""
            light = value < middle
            axes.text(
                column,
                row,
                f"{value:.3g}{more}",
                ha="center",
                va="center",
                fontsize=8,
                color="black" if light else "white",
            )


def _scatter(axes: "Axes", means: "pd.DataFrame", over: Sequence[str], label: str) -> None:
    shown = axes.scatter(
        means[over[0]],
        means[over[1]],
        c=means[MEAN],
        cmap=_colours(),
        s=70,
        edgecolors=CURVE,
        linewidths=0.4,
    )
    axes.set_ylabel(over[1])
    axes.grid(alpha=0.3)
    axes.figure.colorbar(shown, ax=axes, label=label)


def _colours() -> Any:
    from cmcrameri import cm

    return cm.lapaz_r


def _short(value: Any) -> str:
    return f"{value:g}" if isinstance(value, int | float) else str(value)
