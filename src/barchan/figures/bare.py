"""Ground without sand: level ground and bedrock in grey, rocks and stems in colours of their own."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.figures.style import smooth
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr

BARE = (0.72, 0.72, 0.73)
STANDING = {"rock": (0.42, 0.37, 0.34), "stem": (0.36, 0.42, 0.20)}
"""Colours of what stands on the ground, by its name; see ``Terrain.standing``."""


def bare_cells(frame: "xr.Dataset") -> NDArray[np.bool_]:
    """The cells on which no sand lies."""
    return np.asarray(frame["elevation"].values == frame["ground"].values)


def ground_colours(scenario: Scenario) -> NDArray[np.float64]:
    """The colour (red, green, blue) of each cell's ground."""
    colours = np.broadcast_to(BARE, (*scenario.lattice.shape, 3)).copy()
    standing = standing_cells(scenario)
    if standing.any():
        colours[standing] = STANDING[scenario.ground.standing]
    return colours


def standing_cells(scenario: Scenario) -> NDArray[np.bool_]:
    """The cells of rocks or stems that a scenario's ground declares."""
    if not scenario.ground.standing:
        return np.zeros(scenario.lattice.shape, bool)
    return scenario.ground.bare(scenario.lattice)


def with_bare_ground(
    base: NDArray[np.float64], frame: "xr.Dataset", scenario: Scenario, smoothing: float
) -> NDArray[np.float64]:
    """Colours of sand with those of the ground where there is none.

    Smoothed as the surface is, so that single bare cells thin the sand's colour; rocks and stems keep edges.
    """
    bare = bare_cells(frame)
    share = np.where(standing_cells(scenario), bare, smooth(bare, smoothing, scenario))[..., None]
    return base * (1 - share) + ground_colours(scenario) * share
