"""Brushes: layers, ground and fields of a bed changed on a round patch."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.ground.places import distances, extent
from barchan.lattice import Lattice

Falloff = Literal["none", "linear", "smooth"]


def brush(lattice: Lattice, x: float, y: float, radius: float, falloff: Falloff) -> NDArray[np.float64]:
    """How strongly a brush works on each cell: 1 at its centre ``x``, ``y``, 0 from its ``radius`` on (m).

    The patch continues across periodic edges.
    """
    width, height = extent(lattice)
    share = distances(lattice, x / width, y / height) / radius
    strength = {
        "none": np.ones_like(share),
        "linear": 1.0 - share,
        "smooth": 0.5 * (1.0 + np.cos(np.pi * np.minimum(share, 1.0))),
    }[falloff]
    return np.where(share < 1.0, strength, 0.0)


def brushed(bed: Bed, strength: NDArray[np.float64], amount: int) -> NDArray[np.int64]:
    """Units that a brush changes on each cell, ``amount`` at its centre; no cell gives more than it holds."""
    change = np.rint(amount * strength).astype(np.int64)
    return np.maximum(change, -bed.stack.astype(np.int64))


def raised(bed: Bed, strength: NDArray[np.float64], amount: int) -> NDArray[np.float64]:
    """Height (m) by which a brush changes the ground of each cell: whole slabs, ``amount`` at its centre.

    No ground goes below the lowest that there is.
    """
    change = np.rint(amount * strength) * bed.lattice.thickness
    return np.maximum(change, bed.ground.min() - bed.ground)


def grown(
    values: NDArray[np.float64], strength: NDArray[np.float64], amount: float, bounds: tuple[float, float]
) -> NDArray[np.float64]:
    """Change of a field's ``values`` by a brush, ``amount`` at its centre, held within ``bounds``.

    Values beyond the bounds stay as they are.
    """
    low, high = bounds
    change = amount * strength
    room = (np.minimum(low - values, 0.0), np.maximum(high - values, 0.0))
    return np.clip(change, *room)
