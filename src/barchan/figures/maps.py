"""Maps: the surface in colour and shade, and its contours."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.errors import BarchanError
from barchan.figures.layers import BAR, layer_bars, layers_of, overlaid
from barchan.figures.style import BARE, Colours, colour_map, extent, map_axes, new_figure, smooth
from barchan.measures.filters import gradient
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

Limits = tuple[float, float] | None
"""Lowest and highest elevation (m) of a colour scale; None follows the data."""

SUN = (315.0, 40.0)
"""Azimuth and height (degrees) of the light."""


def relief_map(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    colours: Colours = "perceptual",
    limits: Limits = None,
    smoothing: float = 0.0,
    show_bare: bool = True,
    layers: bool = True,
) -> "Figure":
    """A hill-shaded map of one frame, with a colour bar in metres; bare ground is grey.

    With ``layers`` the model's layers, such as plants, lie over it.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    surface = frame["elevation"].values
    norm = Normalize(*(limits or surface_range(surface)))
    image = shaded(
        frame,
        scenario,
        norm=norm,
        colours=colours,
        smoothing=smoothing,
        show_bare=show_bare,
        layers=layers,
    )
    width, height = map_size(scenario)
    figure = new_figure(width + BAR * len(layers_of(scenario)) * layers, height)
    axes = figure.add_subplot()
    axes.imshow(image, origin="lower", extent=extent(scenario), interpolation="nearest")
    map_axes(axes, scenario, frame)
    if layers:
        layer_bars(figure, axes, scenario)
    figure.colorbar(
        ScalarMappable(norm, colour_map(colours)), ax=axes, label="elevation (m)", shrink=0.85, aspect=30
    )
    return figure


def shaded(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    norm: "object",
    colours: Colours = "perceptual",
    smoothing: float = 0.0,
    show_bare: bool = True,
    layers: bool = True,
) -> NDArray[np.float64]:
    """The colours (red, green, blue in [0, 1]) of a hill-shaded map, row 0 at the south edge."""
    shown = smooth(frame["elevation"].values, smoothing, scenario)
    base = np.asarray(colour_map(colours)(norm(shown)))[..., :3]  # type: ignore[operator]
    if show_bare:
        base = np.where((frame["elevation"] == frame["ground"]).values[..., None], BARE, base)
    if layers:
        base = overlaid(base, frame, scenario)
    return lit(base, frame, scenario, smoothing)


def lit(
    base: NDArray[np.float64],
    frame: "xr.Dataset",
    scenario: Scenario,
    smoothing: float,
    strength: float = 1.0,
) -> NDArray[np.float64]:
    """Colours (red, green, blue) of a map in the light and shade of its surface."""
    relief = smooth(frame["elevation"].values, max(smoothing, 0.6), scenario) * 1.5
    light = _light(*gradient(relief, scenario.lattice.cell_size, scenario.lattice.periodic))[..., None]
    shade = 1.0 + strength * (light - 1.0)
    return np.clip(np.where(shade <= 1, base * shade, 1 - (1 - base) * (2 - shade).clip(0.3)), 0.0, 1.0)


def _light(east: NDArray[np.float64], north: NDArray[np.float64]) -> NDArray[np.float64]:
    """How much brighter a slope is than level ground in the light of ``SUN``, within bounds."""
    azimuth, height = np.radians(SUN)
    towards = np.sin(azimuth) * np.cos(height), np.cos(azimuth) * np.cos(height)
    lit = (np.sin(height) - east * towards[0] - north * towards[1]) / np.sqrt(1 + east**2 + north**2)
    return np.clip(1.0 + 0.9 * (lit - np.sin(height)), 0.25, 1.6)


MOST_CONTOURS = 500


def contour_map(
    frame: "xr.Dataset",
    scenario: Scenario,
    *,
    interval: float | None = None,
    count: int = 10,
    colours: Colours = "perceptual",
    limits: Limits = None,
    smoothing: float = 1.0,
) -> "Figure":
    """Contours of one frame, at an interval (m) or of a given number, over its colours."""
    surface = smooth(frame["elevation"].values, smoothing, scenario)
    low, high = limits or surface_range(surface)
    if interval is not None:
        if (high - low) / interval > MOST_CONTOURS:
            raise BarchanError(
                f"contours every {interval:g} m from {low:g} to {high:g} m are more than {MOST_CONTOURS}; "
                f"allowed here: an interval of {(high - low) / MOST_CONTOURS:.2g} m or more"
            )
        levels = np.arange(np.ceil(low / interval), np.floor(high / interval) + 1) * interval
    else:
        levels = np.linspace(low, high, count + 2)[1:-1]
    figure = new_figure(*map_size(scenario))
    axes = figure.add_subplot()
    image = axes.imshow(
        surface, origin="lower", extent=extent(scenario), cmap=colour_map(colours), vmin=low, vmax=high
    )
    x, y = scenario.lattice.x, scenario.lattice.y
    if levels.size and min(surface.shape) > 1 and np.ptp(surface) > 0:
        axes.contour(x, y, surface, levels=levels, colors="black", linewidths=0.6)
    map_axes(axes, scenario, frame)
    figure.colorbar(image, ax=axes, label="elevation (m)", shrink=0.85, aspect=30)
    return figure


def surface_range(surface: NDArray) -> tuple[float, float]:
    """Lowest and highest of a surface (m), apart also where it is level."""
    low, high = float(surface.min()), float(surface.max())
    return (low, high) if high > low else (low - 0.5, high + 0.5)


def map_size(scenario: Scenario) -> tuple[float, float]:
    """Figure size (inches) that suits the field's shape."""
    lattice = scenario.lattice
    tall = np.clip(lattice.rows / lattice.columns, 0.15, 1.6)
    return 7.2, float(6.0 * tall + 0.9)
