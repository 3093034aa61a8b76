"""Sections of models that keep what they move in layers: each layer in the colour of its age."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import as_modelled
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.colors import Normalize
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
) -> bool:
    """Draw the layers of a section from the ground up; False where the model keeps none."""
    from cmcrameri import cm
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import ListedColormap

    model, bed, _wind = as_modelled(frame, scenario)
    if model.strata is None:
        return False
    layers = [
        (thickness[section.rows, section.cols], values[section.rows, section.cols])
        for thickness, values in model.strata.compute(model, bed)
    ]
    shown = np.concatenate([values[thickness > 0.0] for thickness, values in layers])
    scale = ScalarMappable(_scale(shown), ListedColormap(cm.devon_r(np.linspace(0.15, 1.0, 256))))
    base = frame["ground"].values[section.rows, section.cols].astype(np.float64)
    for thickness, values in layers:
        held = thickness > 0.0
        colours = scale.to_rgba(np.maximum(values[held], LEAST_VALUE))
        axes.bar(
            edges[:-1][held], thickness[held], np.diff(edges)[held], base[held], align="edge", color=colours
        )
        base = base + thickness
    figure.colorbar(scale, ax=axes, label=f"{model.strata.title} ({model.strata.unit})")
    return True


def _scale(values: NDArray) -> "Normalize":
    """A colour scale over the values that are shown, logarithmic where they differ much."""
    from matplotlib.colors import LogNorm, Normalize

    if not values.size:
        return Normalize(0.0, 1.0)
    low, high = max(float(values.min()), LEAST_VALUE), max(float(values.max()), 2.0 * LEAST_VALUE)
    return LogNorm(low, high) if high > WIDE * low else Normalize(low, high)
