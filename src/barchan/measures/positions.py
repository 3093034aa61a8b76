"""Where on a dune a cell lies: on the floor, the windward side, the crest or the lee side."""

from enum import IntEnum
from typing import Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.filters import Periodic, gradient, smoothed
from barchan.measures.floor import floor_beneath


class Position(IntEnum):
    """A part of a field of dunes."""

    FLOOR = 0
    WINDWARD = 1
    CREST = 2
    LEE = 3


FLOOR_SHARE = 0.1
"""Share of the relief up to which a cell belongs to the floor; ours, that of ``floor_share``."""

CREST_SHARE = 0.8
"""Share of the height of the highest cell near by from which on a cell belongs to the crest; ours."""


def positions(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    reach: float,
    periodic: Periodic = (True, True),
    width: float = 2.0,
) -> NDArray[np.int8]:
    """The position of each cell, a ``Position``, in a wind from ``direction`` (degrees); -1 where unknown.

    On the smoothed surface: *floor*, less than a tenth of the relief (98th percentile of heights above
    ``floor_beneath``) above the floor; *crest*, at four fifths or more of the greatest height above the floor
    within ``reach`` cells; of the rest *windward* where the surface rises downwind, *lee* where it falls.
    Half of a spacing is a good ``reach``. A bed without relief is all floor.
    """
    surface = smoothed(elevation, width, periodic)
    above = surface - floor_beneath(elevation, reach, periodic, width)
    known = np.isfinite(above)
    east, north = gradient(surface, cell_size, periodic)
    x, y = downwind(direction)
    found = np.where(east * x + north * y > 0, Position.WINDWARD, Position.LEE).astype(np.int8)
    found[above >= CREST_SHARE * _highest_near(above, reach, periodic)] = Position.CREST
    relief = float(np.percentile(above[known], 98)) if known.any() else 0.0
    found[above <= max(FLOOR_SHARE * relief, 1e-9)] = Position.FLOOR
    found[~known] = -1
    return found


def mean_by_position(field: NDArray, found: NDArray[np.int8]) -> dict[Position, float]:
    """The mean of a field on the cells of each position; NaN where it has none."""
    return {
        position: float(np.mean(field[found == position])) if (found == position).any() else float("nan")
        for position in Position
    }


def _highest_near(above: NDArray, reach: float, periodic: Periodic) -> NDArray:
    modes: list[Literal["wrap", "nearest"]] = ["wrap" if joined else "nearest" for joined in periodic]
    known = np.where(np.isfinite(above), above, -np.inf)
    return np.asarray(scipy.ndimage.maximum_filter(known, 2 * round(reach) + 1, mode=modes))
