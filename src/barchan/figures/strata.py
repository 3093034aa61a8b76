"""Sections of models that keep what they move in layers: each layer in the colour of its age, say."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import as_modelled
from barchan.errors import BarchanError
from barchan.models import Model, Strata
from barchan.scenario import Scenario, nearest

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap, Normalize
    from matplotlib.figure import Figure

    from barchan.figures.section_lines import Section

WIDE = 10.0
"""Greatest over smallest value from which the scale of strata is logarithmic."""

LEAST_VALUE = 0.1
"""Value that the logarithmic scale of strata begins with at the lowest."""


def draw_strata(
    figure: "Figure",
    axes: "Axes",
    frame: "xr.Dataset",
    scenario: Scenario,
    section: "Section",
    edges: NDArray[np.float64],
    name: str | None = None,
) -> bool:
    """Draw the layers of a section from the ground up, coloured by the model's strata of that name.

    Without a name by its first; False where the model keeps none. Raises BarchanError for an unknown name.
    """
    from matplotlib.cm import ScalarMappable

    model, bed, _wind = as_modelled(frame, scenario)
    chosen = _chosen(model, name)
    if chosen is None:
        return False
    layers = [
        (thickness[section.rows, section.cols], values[section.rows, section.cols])
        for thickness, values in chosen.compute(model, bed)
    ]
    shown = np.concatenate([values[thickness > 0.0] for thickness, values in layers])
    scale = ScalarMappable(*(_states(chosen) if chosen.states else (_scale(shown), strata_map())))
    base = frame["ground"].values[section.rows, section.cols].astype(np.float64)
    for thickness, values in layers:
        held = thickness > 0.0
        colours = scale.to_rgba(values[held] if chosen.states else np.maximum(values[held], LEAST_VALUE))
        axes.bar(
            edges[:-1][held], thickness[held], np.diff(edges)[held], base[held], align="edge", color=colours
        )
        base = base + thickness
    unit = "" if chosen.unit == "-" else f" ({chosen.unit})"
    bar = figure.colorbar(scale, ax=axes, label=f"{chosen.title}{unit}")
    if chosen.states:
        bar.set_ticks(range(len(chosen.states)), labels=chosen.states)
        bar.ax.tick_params(length=0)
    return True


def strata_map() -> "Colormap":
    """The colours of strata: the least value pale, the greatest dark."""
    from cmcrameri import cm
    from matplotlib.colors import ListedColormap

    return ListedColormap(cm.devon_r(np.linspace(0.15, 1.0, 256)))


def _chosen(model: Model, name: str | None) -> Strata | None:
    """What is shown of the layers; None where the model keeps none and none is asked for."""
    known = {one.name: one for one in model.strata if one.drawn}
    if name is None:
        return next(iter(known.values()), None)
    if name not in known:
        allowed = ", ".join(known) or "none, for it keeps no layers"
        raise BarchanError(f"no strata '{name}' with {model.title}; allowed: {allowed}{nearest(name, known)}")
    return known[name]


def _states(strata: Strata) -> "tuple[Normalize, Colormap]":
    """A colour for each state of layers."""
    from matplotlib.colors import BoundaryNorm, ListedColormap

    count = len(strata.states)
    colours = ListedColormap(strata_map()(np.linspace(0.1, 0.8, count)))
    return BoundaryNorm(np.arange(count + 1) - 0.5, count), colours


def _scale(values: NDArray) -> "Normalize":
    """A colour scale over the values that are shown, logarithmic where they differ much."""
    from matplotlib.colors import LogNorm, Normalize

    if not values.size:
        return Normalize(0.0, 1.0)
    low, high = max(float(values.min()), LEAST_VALUE), max(float(values.max()), 2.0 * LEAST_VALUE)
    return LogNorm(low, high) if high > WIDE * low else Normalize(low, high)
