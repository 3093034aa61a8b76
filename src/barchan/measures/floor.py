"""The floor that bedforms stand on, and the share of it that lies free between them."""

from typing import Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.measures.dunes import Dune, find_dunes
from barchan.measures.filters import Field, Periodic, smoothed


def floor_beneath(
    elevation: NDArray, reach: float, periodic: Periodic = (True, True), width: float = 2.0
) -> Field:
    """Elevation (m) of the floor beneath bedforms narrower than ``2 reach + 1`` cells.

    The morphological opening of the surface smoothed over ``width`` cells: the highest surface that squares
    of that size reach from below. It follows a tilt and wide hills, and runs on beneath dunes; half of a
    spacing is a good ``reach``. Cells of NaN are left out.
    """
    return _opened(smoothed(elevation, width, periodic), reach, periodic)


def _opened(smooth: Field, reach: float, periodic: Periodic) -> Field:
    """The morphological opening of a surface with squares of ``2 reach + 1`` cells."""
    modes: list[Literal["wrap", "nearest"]] = ["wrap" if joined else "nearest" for joined in periodic]
    size = 2 * round(reach) + 1
    known = np.isfinite(smooth)
    lowest = scipy.ndimage.minimum_filter(np.where(known, smooth, np.inf), size, mode=modes)
    opened = scipy.ndimage.maximum_filter(np.where(np.isinf(lowest), -np.inf, lowest), size, mode=modes)
    return np.where(known, opened, np.nan)


LEAST = 0.2
"""Share of the height that only 0.5 % of the field reaches which a dune has at least; ours."""


def dunes_on_floor(elevation: NDArray, reach: float, periodic: Periodic = (True, True)) -> list[Dune]:
    """Single dunes of a surface whose depth of sand is not known: ``find_dunes`` above ``floor_beneath``.

    Bodies are left out that rise by less than a fifth of the 99.5th percentile of heights above the floor.
    """
    above = np.asarray(elevation, float) - floor_beneath(elevation, reach, periodic)
    known = above[np.isfinite(above)]
    high = float(np.percentile(known, 99.5)) if known.size else 0.0
    if high <= 1e-9 * np.abs(np.asarray(elevation, float)[np.isfinite(elevation)]).max(initial=1.0):
        return []
    return find_dunes(above, LEAST * high, periodic)


def floor_share(
    elevation: NDArray, reach: float, periodic: Periodic = (True, True), width: float = 2.0
) -> float:
    """Share of the cells that stand above the floor by less than a tenth of the relief.

    The relief is the 98th percentile of the heights of the smoothed surface over its ``floor_beneath``. Sine
    waves have 0.20 of their area there, ridges with straight flanks 0.10, dunes far apart on a level floor
    nearly all. Cells of NaN are left out; NaN on a bed without relief.
    """
    smooth = smoothed(elevation, width, periodic)
    above = smooth - _opened(smooth, reach, periodic)
    known = above[np.isfinite(above)]
    size = np.abs(np.asarray(elevation, float)[np.isfinite(elevation)]).max(initial=1.0)
    if not known.size or known.max() <= 1e-9 * size:
        return float("nan")
    return float(np.mean(known <= 0.1 * np.percentile(known, 98.0)))
