"""Layers of a model over the surface, such as plants: light where sparse, dark where dense."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import field_of
from barchan.models import Overlay
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure

VEIL = 0.25
"""Share up to which a layer fades in, so that little of it lets the colours beneath through."""

BAR = 0.9
"""Width (inches) that the colour bar of a layer takes."""

OPACITY = 0.75


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


def layer_bars(figure: "Figure", axes: "Axes", scenario: Scenario) -> None:
    """A colour bar for each layer; drawn before others it stands to their right."""
    from matplotlib.cm import ScalarMappable

    for layer in layers_of(scenario):
        scale = ScalarMappable(cmap=layer_map(layer))
        figure.colorbar(scale, ax=axes, label=layer.title, shrink=0.85, aspect=30)


def layer_map(layer: Overlay) -> "Colormap":
    """A layer's colours, without the palest: they would pass for nothing."""
    import matplotlib as mpl
    from matplotlib.colors import ListedColormap

    return ListedColormap(mpl.colormaps[layer.colours](np.linspace(0.25, 0.95, 256)))
