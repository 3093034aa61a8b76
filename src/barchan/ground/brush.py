"""Brushes: layers, ground and fields of a bed changed on a round patch."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.ground.places import extent, offsets
from barchan.lattice import Lattice

Falloff = Literal["none", "linear", "smooth"]


def brush(lattice: Lattice, x: float, y: float, radius: float, falloff: Falloff) -> NDArray[np.float64]:
    """How strongly a brush works on each cell: 1 at its centre ``x``, ``y``, 0 from its ``radius`` on (m).

    The patch continues across periodic edges.
    """
    width, height = extent(lattice)
    east, north = offsets(lattice, x / width, y / height)
    rows = np.flatnonzero(np.abs(north).min(axis=1) < radius)
    cols = np.flatnonzero(np.abs(east).min(axis=0) < radius)
    share = np.hypot(east[:, cols] if len(east) == 1 else east[np.ix_(rows, cols)], north[rows]) / radius
    strength = {
        "none": np.ones_like(share),
        "linear": 1.0 - share,
        "smooth": 0.5 * (1.0 + np.cos(np.pi * np.minimum(share, 1.0))),
    }[falloff]
    patch = np.zeros(lattice.shape)
    patch[np.ix_(rows, cols)] = np.where(share < 1.0, strength, 0.0)
    return patch


def whole(
    strength: NDArray[np.float64], before: NDArray[np.float64] | None, amount: float
) -> NDArray[np.float64]:
    """Whole units that a stamp of a brush adds to each cell, ``amount`` of them at its centre.

    ``before`` is the strength of the stamps before it of the same stroke, together: all of them add up to
    whole units of their sum, so that a stroke is as even as if it had been rounded once.
    """
    if before is None:
        return np.rint(amount * strength)
    return np.rint(amount * (before + strength)) - np.rint(amount * before)


def brushed(bed: Bed, units: NDArray[np.float64]) -> NDArray[np.int64]:
    """The change of each cell by whole ``units``; no cell gives more than it holds."""
    return np.maximum(units.astype(np.int64), -bed.stack.astype(np.int64))


def raised(bed: Bed, slabs: NDArray[np.float64]) -> NDArray[np.float64]:
    """Height (m) by which whole ``slabs`` raise the ground of each cell, never below the lowest there is."""
    return np.maximum(slabs * bed.lattice.thickness, bed.ground.min() - bed.ground)


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
