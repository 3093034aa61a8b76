"""Brushes: sand added to or taken from a round patch of the bed."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.ground.places import distances, extent

Falloff = Literal["none", "linear", "smooth"]


def brushed(bed: Bed, x: float, y: float, radius: float, amount: int, falloff: Falloff) -> NDArray[np.int64]:
    """Slabs that a stroke changes on each cell.

    ``x`` and ``y`` (m) are the stroke's centre, ``amount`` the slabs at its centre (negative to take
    away). The patch continues across periodic edges. No cell gives more than it holds.
    """
    width, height = extent(bed.lattice)
    share = distances(bed.lattice, x / width, y / height) / radius
    strength = {
        "none": np.ones_like(share),
        "linear": 1.0 - share,
        "smooth": 0.5 * (1.0 + np.cos(np.pi * np.minimum(share, 1.0))),
    }[falloff]
    change = np.rint(amount * np.where(share < 1.0, strength, 0.0)).astype(np.int64)
    return np.maximum(change, -bed.sand.astype(np.int64))
