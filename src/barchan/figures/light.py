"""Light and shade of a surface."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.figures.style import smooth
from barchan.measures.filters import gradient
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr

SUN = (315.0, 40.0)
"""Azimuth and height (degrees) of the light."""

FINEST = 0.6
"""Cells over which a surface is smoothed at least before it is lit: slabs are steps."""

STEEP = 30.0
"""Slope (degrees) that the steep twentieth of a gentle relief is lit as: that of a slip face."""

MOST_EXAGGERATED = 4.0
"""Most times as steep as they are that slopes are lit, about what shows ripples of 8 degrees."""


def exaggeration(surface: NDArray, scenario: Scenario, smoothing: float = 0.0) -> float:
    """How much steeper than they are the slopes of a surface (m) are lit, from 1 to ``MOST_EXAGGERATED``.

    So much that a twentieth of the field is steeper than ``STEEP``: dunes are lit about as they are, ripples
    and low swells more boldly.
    """
    steep = float(np.percentile(np.hypot(*_slopes(surface, scenario, smoothing)), 95))
    most = np.tan(np.radians(STEEP))
    return MOST_EXAGGERATED if steep * MOST_EXAGGERATED <= most else max(1.0, float(most / steep))


def lit(
    base: NDArray[np.float64],
    frame: "xr.Dataset",
    scenario: Scenario,
    smoothing: float,
    strength: float = 1.0,
    steeper: float | None = None,
) -> NDArray[np.float64]:
    """Colours (red, green, blue) of a map in the light and shade of its surface.

    Slopes are lit as ``steeper`` times as steep; without it by ``exaggeration``.
    """
    surface = frame["elevation"].values
    factor = exaggeration(surface, scenario, smoothing) if steeper is None else steeper
    east, north = _slopes(surface, scenario, smoothing)
    light = brightness(factor * east, factor * north)[..., None]
    shade = 1.0 + strength * (light - 1.0)
    return np.clip(np.where(shade <= 1, base * shade, 1 - (1 - base) * (2 - shade).clip(0.3)), 0.0, 1.0)


def brightness(east: NDArray[np.float64], north: NDArray[np.float64]) -> NDArray[np.float64]:
    """How much brighter a slope is than level ground in the light of ``SUN``, within bounds."""
    azimuth, height = np.radians(SUN)
    towards = np.sin(azimuth) * np.cos(height), np.cos(azimuth) * np.cos(height)
    lit = (np.sin(height) - east * towards[0] - north * towards[1]) / np.sqrt(1 + east**2 + north**2)
    return np.clip(1.0 + 0.9 * (lit - np.sin(height)), 0.25, 1.6)


def _slopes(
    surface: NDArray, scenario: Scenario, smoothing: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    lattice = scenario.lattice
    return gradient(smooth(surface, max(smoothing, FINEST), scenario), lattice.cell_size, lattice.periodic)
