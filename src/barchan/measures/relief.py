"""How high bedforms stand, and how that compares with how far they stand apart."""

import numpy as np
from numpy.typing import NDArray

from barchan.measures.filters import Periodic, smoothed, without_trend
from barchan.measures.spacing import dominant_spacing


def bedform_height(elevation: NDArray, periodic: Periodic = (True, True), width: float = 1.0) -> float:
    """Height (m) from trough to crest of sine waves with the standard deviation of a surface.

    A trend towards open edges is removed and the surface smoothed over ``width`` cells first; cells that are
    NaN are left out. 0 on a flat bed. All relief counts: that of uneven ground is removed beforehand, by
    ``bedform_surface``.
    """
    surface = smoothed(without_trend(elevation, periodic), width, periodic)
    known = np.isfinite(surface)
    return float(2.0 * np.sqrt(2.0) * surface.std(where=known)) if known.any() else float("nan")


def bedform_index(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
    width: float = 1.0,
) -> float:
    """Spacing along the wind from ``direction`` (degrees) over height: the ripple index, of ripples.

    NaN on a bed without relief along the wind.
    """
    spacing = dominant_spacing(elevation, cell_size, direction, periodic, width)
    return spacing / bedform_height(elevation, periodic, width) if np.isfinite(spacing) else float("nan")
