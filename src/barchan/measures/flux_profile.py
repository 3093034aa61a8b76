"""The flux along the wind that a change of the surface needs."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.crest_to_toe import profiles
from barchan.measures.filters import Field, Periodic


@dataclass(frozen=True)
class FluxProfile:
    """Flux along a profile downwind, a cell apart."""

    distance: Field
    """Distance downwind (m)."""
    flux: Field
    """Volume (with pores) that passes each place, per metre of width: m² per unit of time."""


def flux_profile(
    before: NDArray,
    after: NDArray,
    time: float,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
) -> FluxProfile:
    """Flux in a wind from ``direction`` (degrees) that turns one surface (m) into another after a ``time``.

    The sand that passes a place is what the surface upwind of it has lost (Exner's equation), the mean over
    the width of the field: dq/dx = -dh/dt. Only differences are known: the least flux is set to 0, which it
    is where the floor is bare. Sand that passes without leaving a trace does not count. Cells of NaN are left
    out of the mean. Exact along the lattice's axes; in other directions profiles near corners are short.
    Raises ValueError where the time is not above 0 or the shapes differ.
    """
    if not time > 0.0:
        raise ValueError(f"a time of {time:g} lies between the surfaces; allowed: above 0")
    if before.shape != after.shape:
        raise ValueError(f"surfaces of {before.shape} and {after.shape} cells; allowed: the same")
    change = np.asarray(after, float) - np.asarray(before, float)
    lines = profiles(change, direction, periodic)
    known = np.isfinite(lines)
    places = known.any(axis=0)
    mean = np.zeros(lines.shape[1])
    mean[places] = np.nansum(lines[:, places], axis=0) / known[:, places].sum(axis=0)
    lost = -np.cumsum(mean) * cell_size / time
    x, y = downwind(direction)
    extent = round(abs(x) * before.shape[1] + abs(y) * before.shape[0])
    once = lost[:extent] if len(lost) == 2 * extent else lost  # joined edges: profiles go twice through
    distance = np.arange(1, len(once) + 1, dtype=np.float64) * cell_size
    return FluxProfile(distance, np.asarray(once - once.min(), np.float64))
