"""Layers of a model over the surface, such as plants: light where sparse, dark where dense."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import field_of
from barchan.models import Overlay
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Colormap

VEIL = 0.25
"""Share up to which a layer fades in, so that little of it lets the colours beneath through."""

OPACITY = 0.45
"""Of a dense layer: the height of the dunes beneath still shows in their colours."""


def layers_of(scenario: Scenario) -> tuple[Overlay, ...]:
    """The layers that the scenario's model declares."""
    return scenario.new_model().overlays


def overlaid(base: NDArray[np.float64], frame: "xr.Dataset", scenario: Scenario) -> NDArray[np.float64]:
    """Colours (red, green, blue) with the model's layers drawn over them."""
    for layer in layers_of(scenario):
        share = np.clip(field_of(frame, scenario, layer.field).values, 0.0, 1.0)
        opacity = OPACITY * np.minimum(share / VEIL, 1.0)[..., None]
        base = base * (1 - opacity) + layer_map(layer)(share)[..., :3] * opacity
    return base


def layer_scales(scenario: Scenario) -> list[tuple["ScalarMappable", str]]:
    """The colour scale of each layer and its title."""
    from matplotlib.cm import ScalarMappable

    return [(ScalarMappable(cmap=layer_map(layer)), layer.title) for layer in layers_of(scenario)]


def layer_map(layer: Overlay) -> "Colormap":
    """A layer's colours, without the palest: they would pass for nothing."""
    import matplotlib as mpl
    from matplotlib.colors import ListedColormap

    return ListedColormap(mpl.colormaps[layer.colours](np.linspace(0.25, 0.95, 256)))
