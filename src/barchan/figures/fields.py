"""Maps of any field of a run, kept or derived."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.figures.layers import layer_map, layers_of
from barchan.figures.maps import Limits, lit, map_size
from barchan.figures.style import (
    PALE,
    SHADOW,
    Colours,
    colour_map,
    extent,
    label_of,
    map_axes,
    new_figure,
    smooth,
)
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure

OUTLIERS = 0.5
"""Percent of the cells at each end that a colour scale may leave out."""

RELIEF = 0.5
"""How much of the surface's light and shade a field's colours show."""


def field_map(
    field: "xr.DataArray",
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    colours: Colours = "perceptual",
    limits: Limits = None,
    smoothing: float = 0.0,
) -> "Figure":
    """A map of a field of one frame (see ``analysis.fields.field_of``) on the lightly shaded surface.

    Without ``limits`` the colours of a field that has a centre lie evenly about it; a few outlying cells
    may lie beyond the scale, which then ends in arrows. A scale begins at the lowest possible value at least.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    shown = smooth(field.values, smoothing, scenario)
    low, high = limits or limits_of(shown, field.attrs.get("centre"))
    shades = _colours(field, scenario, colours)
    least = field.attrs.get("least", low)
    if limits is None and low < least < high:
        low, shades = least, _upper(shades, (least - low) / (high - low))
    scale = ScalarMappable(Normalize(low, high), shades)
    image = lit(scale.to_rgba(shown)[..., :3], frame, scenario, smoothing, RELIEF)
    figure = new_figure(*map_size(scenario))
    axes = figure.add_subplot()
    axes.imshow(image, origin="lower", extent=extent(scenario), interpolation="nearest")
    map_axes(axes, scenario, frame)
    ends = _ends(shown, low, high)
    bar = figure.colorbar(scale, ax=axes, label=label_of(field), extend=ends, shrink=0.85, aspect=30)
    if field.values.dtype == bool:
        bar.set_ticks([0.0, 1.0], labels=["no", "yes"])
    return figure


def limits_of(values: NDArray, centre: float | None) -> tuple[float, float]:
    """A colour scale for nearly all of these values, even about a centre where there is one."""
    low, high = (float(value) for value in np.percentile(values, (OUTLIERS, 100 - OUTLIERS)))
    if centre is not None:
        reach = max(high - centre, centre - low)
        low, high = centre - reach, centre + reach
    return (low, high) if high > low else (low - 0.5, high + 0.5)


def _upper(colours: "Colormap", start: float) -> "Colormap":
    """The colours from ``start`` (0 to 1) on."""
    from matplotlib.colors import ListedColormap

    return ListedColormap(colours(np.linspace(start, 1.0, 256)))


def _ends(values: NDArray, low: float, high: float) -> str:
    """Which ends of a colour scale there are values beyond."""
    beyond = bool(values.min() < low - 1e-9), bool(values.max() > high + 1e-9)
    return {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[
        beyond
    ]


def _colours(field: "xr.DataArray", scenario: Scenario, colours: Colours) -> "Colormap":
    """The colours that suit a field, unless other ones are asked for."""
    if colours != "perceptual":
        return colour_map(colours)
    if field.values.dtype == bool:
        return choice_map()
    layer = next((layer for layer in layers_of(scenario) if layer.field == field.name), None)
    if layer is not None:
        return layer_map(layer)
    return centred_map() if "centre" in field.attrs else colour_map(colours)


def choice_map() -> "Colormap":
    """The colours of no and yes."""
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("choice", [PALE, SHADOW])


def centred_map() -> "Colormap":
    """Colours of values on both sides of a centre."""
    from cmcrameri import cm

    return cm.vik
