"""Which side of bedforms is their lee, from their shape alone."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.directions import bearing
from barchan.measures.filters import Periodic, gradient, smoothed, without_trend


@dataclass(frozen=True)
class LeeSide:
    """The side on which bedforms are steeper."""

    wind: float
    """Direction (degrees clockwise from north) that a wind comes from for which that side is the lee."""
    strength: float
    """From 0, bedforms as steep to either side, to 1, all relief faces one way."""


def lee_side(
    elevation: NDArray, cell_size: float, periodic: Periodic = (True, True), width: float = 2.0
) -> LeeSide:
    """The lee of bedforms, as slip faces show it: the mean of the gradient times its square points upwind.

    A bedform rises as far as it falls, so that the steeper flank weighs more in the cube. The strength is the
    length of that mean over the mean cube: (s² - w²) / (s² + w²) for straight ridges whose flanks have the
    slopes s and w. The surface is freed of its trend towards open edges and smoothed over ``width`` cells;
    cells of NaN are left out. NaN and 0 on a bed without relief.
    """
    surface = smoothed(without_trend(elevation, periodic), width, periodic)
    east, north = gradient(surface, cell_size, periodic)
    known = np.isfinite(east + north)
    east, north = east[known], north[known]
    square = east**2 + north**2
    total = float((square**1.5).sum())
    if total <= np.finfo(float).tiny:
        return LeeSide(float("nan"), 0.0)
    x, y = float((square * east).sum()), float((square * north).sum())
    return LeeSide(bearing(-x, -y), float(np.hypot(x, y)) / total)
