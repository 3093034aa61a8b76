"""Which way crests run."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.measures.filters import Periodic, gradient, smoothed, without_trend


@dataclass(frozen=True)
class Orientation:
    """The mean direction of crests."""

    azimuth: float
    """Degrees clockwise from north, in [0, 180); NaN on a bed without relief."""
    coherence: float
    """How straight and parallel the crests are: 0 without a common direction, 1 for a single direction."""

    def __repr__(self) -> str:
        return f"<Orientation {self.azimuth:.1f}° from north, coherence {self.coherence:.2f}>"


def crest_orientation(
    elevation: NDArray, cell_size: float, periodic: Periodic = (True, True), width: float = 2.0
) -> Orientation:
    """Mean crest direction by the structure tensor of the surface smoothed over ``width`` cells.

    The tensor averages the outer product of the surface's gradient with itself; crests run across its
    principal direction, and its coherence is (l1 - l2) / (l1 + l2) of its two eigenvalues. A trend towards
    open edges is removed first; cells that are NaN are left out.
    """
    surface = smoothed(without_trend(elevation, periodic), width, periodic)
    east, north = gradient(surface, cell_size, periodic)
    known = np.isfinite(east + north)
    east, north = east[known], north[known]
    xx, yy, xy = (float(part.sum()) for part in (east**2, north**2, east * north))
    if xx + yy <= np.finfo(float).tiny:
        return Orientation(float("nan"), 0.0)
    across = 0.5 * np.arctan2(2 * xy, xx - yy)
    azimuth = -np.degrees(across) % 180.0 % 180.0  # a remainder of a tiny negative angle rounds up to 180
    return Orientation(float(azimuth), float(np.hypot(xx - yy, 2 * xy) / (xx + yy)))
