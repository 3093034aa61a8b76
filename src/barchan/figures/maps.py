"""Maps of the surface in colour and shade."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.on_squares import on_squares
from barchan.figures.bare import bare_cells, with_bare_ground
from barchan.figures.layers import layer_scales, overlaid
from barchan.figures.light import lit
from barchan.figures.panels import colour_bar, map_panel
from barchan.figures.style import SMOOTHING, Colours, colour_map, material_of, smooth
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

Limits = tuple[float, float] | None
"""Lowest and highest elevation (m) of a colour scale; None follows the data."""


def relief_map(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    colours: Colours = "natural",
    limits: Limits = None,
    smoothing: float = SMOOTHING,
    show_bare: bool = True,
    layers: bool = True,
) -> "Figure":
    """A hill-shaded map of one frame, with a colour bar in metres.

    The colours are those of the sand's elevation; bare ground is grey, rocks and stems have colours of their
    own. Where slopes are gentle they are lit as steeper than they are (``light.exaggeration``). With
    ``layers`` the model's layers, such as plants, lie over it. The surface is smoothed over ``smoothing``
    cells for display.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    frame, scenario = on_squares(frame, scenario)
    norm = Normalize(*(limits or surface_range(frame, scenario, show_bare)))
    image = shaded(
        frame,
        scenario,
        norm=norm,
        colours=colours,
        smoothing=smoothing,
        show_bare=show_bare,
        layers=layers,
    )
    figure, axes = map_panel(scenario, frame, image)
    scales = [*layer_scales(scenario)] if layers else []
    for scale, label in [
        *scales,
        (ScalarMappable(norm, colour_map(colours, material_of(scenario))), "elevation (m)"),
    ]:
        colour_bar(figure, axes, scale, label)
    return figure


def shaded(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    norm: "object",
    colours: Colours = "natural",
    smoothing: float = 0.0,
    show_bare: bool = True,
    layers: bool = True,
    steeper: float | None = None,
) -> NDArray[np.float64]:
    """The colours (red, green, blue in [0, 1]) of a hill-shaded map, row 0 at the south edge.

    Slopes are lit as ``steeper`` times as steep; without it by ``light.exaggeration``.
    """
    frame, scenario = on_squares(frame, scenario)
    shown = smooth(frame["elevation"].values, smoothing, scenario)
    base = np.asarray(colour_map(colours, material_of(scenario))(norm(shown)))[..., :3]  # type: ignore[operator]
    if show_bare:
        base = with_bare_ground(base, frame, scenario, smoothing)
    if layers:
        base = overlaid(base, frame, scenario)
    return lit(base, frame, scenario, smoothing, steeper=steeper)


def surface_range(frame: "xr.Dataset", scenario: Scenario, show_bare: bool = True) -> tuple[float, float]:
    """Lowest and highest elevation (m) of the sand's surface; without ``show_bare`` of the whole surface.

    The scale of a level surface begins at the lowest ground, for no surface lies below it.
    """
    low, high = elevation_range(frame, show_bare)
    if low == high:
        low = float(frame["ground"].min())
    return (low, high) if high > low else (low, low + scenario.lattice.thickness)


def elevation_range(frame: "xr.Dataset", show_bare: bool = True) -> tuple[float, float]:
    """Lowest and highest elevation (m) of what has the colours of the scale: sand, or the whole surface."""
    surface, covered = frame["elevation"].values, ~bare_cells(frame)
    coloured = surface[covered] if show_bare and covered.any() else surface
    return float(coloured.min()), float(coloured.max())


def range_over(dataset: "xr.Dataset", scenario: Scenario) -> tuple[float, float]:
    """Lowest and highest elevation (m) of the sand in all frames of a dataset."""
    ranges = [elevation_range(dataset.isel(step=k)) for k in range(dataset.sizes["step"])]
    low, high = min(low for low, _ in ranges), max(high for _, high in ranges)
    return (low, high) if high > low else surface_range(dataset.isel(step=-1), scenario)
