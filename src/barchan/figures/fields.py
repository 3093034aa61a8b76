"""Maps of any field of a run, kept or derived."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.on_squares import field_on_squares, on_squares
from barchan.figures.bare import bare_cells, ground_colours
from barchan.figures.layers import layer_map, layers_of
from barchan.figures.light import lit
from barchan.figures.maps import Limits
from barchan.figures.panels import colour_bar, map_panel
from barchan.figures.style import PALE, SHADOW, SMOOTHING, Colours, colour_map, label_of, smooth
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.cm import ScalarMappable
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
    A field of the layers alone leaves bare ground out of its scale, and shows it as ground.
    """
    field = field_on_squares(field, scenario)
    frame, scenario = on_squares(frame, scenario)
    colour, scale, ends = field_colours(
        field, frame, scenario, colours=colours, limits=limits, smoothing=smoothing
    )
    image = lit(colour, frame, scenario, max(smoothing, SMOOTHING), RELIEF)
    figure, axes = map_panel(scenario, frame, image)
    bar = colour_bar(figure, axes, scale, label_of(field), extend=ends)
    if field.values.dtype == bool:
        bar.set_ticks([0.0, 1.0], labels=["no", "yes"])
        bar.ax.tick_params(length=0)
    return figure


def field_colours(
    field: "xr.DataArray",
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    colours: Colours = "perceptual",
    limits: Limits = None,
    automatic: Limits = None,
    smoothing: float = 0.0,
) -> tuple[NDArray[np.float64], "ScalarMappable", str]:
    """Colours (red, green, blue) of a field on squares without light and shade; see ``field_map``.

    ``automatic`` are the limits of a scale that nobody chose, where it is that of more frames than this one.
    Also returns the colour scale, and which of its ends there are values beyond.
    """
    shown = smooth(field.values, smoothing, scenario)
    shades, held = _colours(field, scenario, colours), _held(field, frame)
    if field.values.dtype == bool:
        scale, ends = _choice(shades), "neither"
    else:
        found = automatic or automatic_limits(field, frame, scenario, smoothing)
        scale, ends = _scale(field, shown, shades, limits, found)
    return np.where(held[..., None], scale.to_rgba(shown)[..., :3], ground_colours(scenario)), scale, ends


def automatic_limits(
    field: "xr.DataArray", frame: "xr.Dataset", scenario: Scenario, smoothing: float = 0.0
) -> tuple[float, float]:
    """The colour scale of a field of one frame where nobody chooses one; that of a choice is 0 to 1."""
    if field.values.dtype == bool:
        return 0.0, 1.0
    held = _held(field, frame)
    if held.any() and not held.all():
        return limits_of(field.values[held], None)
    return limits_of(smooth(field.values, smoothing, scenario), field.attrs.get("centre"))


def _held(field: "xr.DataArray", frame: "xr.Dataset") -> NDArray[np.bool_]:
    """The cells that have a value: of a field of the layers those that are not bare."""
    return ~bare_cells(frame) if field.attrs.get("of_layers") else np.ones(field.shape, np.bool_)


def _scale(
    field: "xr.DataArray", shown: NDArray, shades: "Colormap", limits: Limits, automatic: tuple[float, float]
) -> tuple["ScalarMappable", str]:
    """The colour scale of a field of numbers, and which of its ends there are values beyond."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    low, high = limits or automatic
    least = field.attrs.get("least", low)
    if limits is None and low < least < high:
        low, shades = least, _upper(shades, (least - low) / (high - low))
    return ScalarMappable(Normalize(low, high), shades), _ends(shown, low, high)


def _choice(shades: "Colormap") -> "ScalarMappable":
    """Two colours, for no and yes; a smoothed field has that of most of its neighbours."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import BoundaryNorm, ListedColormap

    return ScalarMappable(BoundaryNorm([-0.5, 0.5, 1.5], 2), ListedColormap(shades([0.0, 1.0])))


def limits_of(values: NDArray, centre: float | None) -> tuple[float, float]:
    """A colour scale for nearly all of these values, even about a centre where there is one."""
    low, high = (float(value) for value in np.percentile(values, (OUTLIERS, 100 - OUTLIERS)))
    if centre is not None:
        reach = max(high - centre, centre - low)
        low, high = centre - reach, centre + reach
    apart = 0.5 * abs(low) or 0.5
    return (low, high) if high > low else (low - apart, high + apart)


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
