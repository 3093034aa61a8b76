"""The surface seen from above the south edge; nearer parts hide those behind."""

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import Normalize
from numpy.typing import NDArray
from scipy import ndimage

from barchan.analysis.on_squares import on_squares
from barchan.errors import BarchanError
from barchan.figures.maps import Limits, shaded, surface_range
from barchan.figures.style import SMOOTHING, Colours, heading, new_figure, smooth, title
from barchan.figures.winds import wind_sign
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

FINE = 1024
"""Cells along the longer side of a picture, about: they are drawn finer until there are as many."""


def oblique_view(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    angle: float = 35.0,
    colours: Colours = "natural",
    limits: Limits = None,
    smoothing: float = SMOOTHING,
    show_bare: bool = True,
    layers: bool = True,
) -> "Figure":
    """The surface of one frame as seen from the south, at ``angle`` (degrees) above the horizon.

    All lengths are true, none is exaggerated; the light comes from the north-west as on maps. Raises
    BarchanError where the angle is not between 5 and 90.
    """
    frame, scenario = on_squares(frame, scenario)
    surface = smooth(frame["elevation"].values, smoothing, scenario)
    norm = Normalize(*(limits or surface_range(frame, scenario, show_bare)))
    base = shaded(
        frame, scenario, norm=norm, colours=colours, smoothing=smoothing, show_bare=show_bare, layers=layers
    )
    image = seen_obliquely(*_finer(surface / scenario.lattice.cell_size, base), angle)
    tall = float(np.clip(image.shape[0] / image.shape[1], 0.1, 2.0))
    figure = new_figure(7.2, 7.0 * tall + 0.5)
    axes = figure.add_subplot()
    axes.imshow(image, interpolation="antialiased")
    axes.set_axis_off()
    heading(figure, title(scenario, int(frame["step"])))
    wind_sign(axes, scenario, frame)
    return figure


def _finer(surface: NDArray[np.float64], colours: NDArray[np.float64]) -> tuple[NDArray, NDArray]:
    """Heights, in finer cells, and colours between those of the cells, for a picture of ``FINE`` of them."""
    factor = max(1, round(FINE / max(surface.shape)))
    zoomed = [
        ndimage.zoom(layer, factor, order=1, grid_mode=True, mode="nearest")
        for layer in (surface, *np.moveaxis(colours, -1, 0))
    ]
    return zoomed[0] * factor, np.stack(zoomed[1:], axis=-1)


def seen_obliquely(
    surface: NDArray[np.float64], colours: NDArray[np.float64], angle: float
) -> NDArray[np.float64]:
    """A picture (its first row on top) of a surface, heights in cells, with a colour for each cell.

    Parallel rays from the south, ``angle`` degrees above the horizon; above the surface the picture is
    white.
    """
    if not 5.0 <= angle <= 90.0:
        raise BarchanError(f"angle is {angle:g} degrees; allowed: 5 to 90")
    rows, cols = surface.shape
    sine, cosine = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    up = (np.arange(1, rows + 1) * sine)[:, None] + (surface - surface.min()) * cosine
    ends = np.rint(up).astype(np.int64)
    picture = np.ones((int(ends.max()), cols, 3))
    level = np.arange(picture.shape[0])[:, None]
    horizon = np.zeros(cols, np.int64)
    for row in range(rows):
        part = slice(int(horizon.min()), int(ends[row].max()))
        seen = (level[part] >= horizon) & (level[part] < ends[row])
        picture[part][seen] = np.broadcast_to(colours[row], picture[part].shape)[seen]
        horizon = np.maximum(horizon, ends[row])
    return picture[::-1]
