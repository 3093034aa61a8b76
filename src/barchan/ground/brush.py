"""Brushes: sand added to or taken from a round patch of the bed."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed

Falloff = Literal["none", "linear", "smooth"]


def brushed(bed: Bed, x: float, y: float, radius: float, amount: int, falloff: Falloff) -> NDArray[np.int64]:
    """Slabs that a stroke changes on each cell.

    ``x`` and ``y`` (m) are the stroke's centre, ``amount`` the slabs at its centre (negative to take
    away). The patch continues across periodic edges. No cell gives more than it holds.
    """
    lattice = bed.lattice
    dx = _distance(lattice.x, x, lattice.columns * lattice.cell_size, lattice.boundary_x == "periodic")
    dy = _distance(lattice.y, y, lattice.rows * lattice.cell_size, lattice.boundary_y == "periodic")
    share = np.hypot(dx[None, :], dy[:, None]) / radius
    strength = {
        "none": np.ones_like(share),
        "linear": 1.0 - share,
        "smooth": 0.5 * (1.0 + np.cos(np.pi * np.minimum(share, 1.0))),
    }[falloff]
    change = np.rint(amount * np.where(share < 1.0, strength, 0.0)).astype(np.int64)
    return np.maximum(change, -bed.sand.astype(np.int64))


def _distance(places: NDArray[np.float64], centre: float, length: float, wrap: bool) -> NDArray[np.float64]:
    distance = np.abs(places - centre)
    if not wrap:
        return distance
    distance %= length
    return np.minimum(distance, length - distance)
