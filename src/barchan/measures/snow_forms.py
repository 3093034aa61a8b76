"""What a field of snow shows: which way its forms lean, how rough they are, whether they still move."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.filters import Periodic, gradient, smoothed, without_trend

Form = Literal["flat", "depositional, moving", "depositional, stationary", "erosional", "mixed"]

FLATTEST_INDEX = 200.0
"""Spacing over relief from which on a surface is flat."""

FLATTEST_QUANTA = 3.0
"""Relief in heights of a quantum below which a surface is flat."""

DEPOSITIONAL, EROSIONAL = -0.2, 0.5
"""Skewness of slopes below which forms are deposits, and above which they are worn."""

MOVING = 0.05
"""Speed (m/h) from which on forms move."""


def slope_skewness(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
    width: float = 1.0,
) -> float:
    """Skewness of the slopes along a wind from ``direction`` (degrees); NaN on a bed without relief.

    Below zero where few steep slopes face downwind (slip faces), above zero where few steep slopes face the
    wind (edges that are worn). A trend towards open edges is removed and the surface smoothed over ``width``
    cells first; cells that are NaN are left out.
    """
    surface = smoothed(without_trend(elevation, periodic), width, periodic)
    east, north = gradient(surface, cell_size, periodic)
    x, y = downwind(direction)
    slopes = east * x + north * y
    slopes = slopes[np.isfinite(slopes)]
    if slopes.size == 0:
        return math.nan
    off = slopes - slopes.mean()
    variance = float((off**2).mean())
    return float((off**3).mean()) / variance**1.5 if variance > 1e-18 else math.nan


def central_relief(elevation: NDArray) -> float:
    """From the first to the last percentile of a surface (m)."""
    low, high = np.nanpercentile(elevation, (1.0, 99.0))
    return float(high - low)


def roughness_length(
    elevation: NDArray, cell_size: float, direction: float, periodic: Periodic = (True, True)
) -> float:
    """Roughness length (m) that forms add for a wind from ``direction``: h s / 2 (Lettau 1969).

    h is the height of waves with the surface's standard deviation, s the area that faces the wind over the
    ground's. 0 on a flat bed.
    """
    surface = without_trend(elevation, periodic)
    east, north = gradient(surface, cell_size, periodic)
    x, y = downwind(direction)
    facing = float(np.nanmean(np.maximum(east * x + north * y, 0.0)))
    return 0.5 * 2.0 * math.sqrt(2.0) * float(np.nanstd(surface)) * facing


def form_of(
    *, relief: float, spacing: float, skewness: float, speed: float, bonded: float, quantum: float
) -> Form:
    """The class of a field of snow.

    By its ``relief`` (m, first to last percentile), the ``spacing`` of its forms (m; NaN: none), the
    ``skewness`` of its slopes along the wind, the ``speed`` of its forms (m/h; NaN where frames show none:
    then they stand), the share of the surface that is ``bonded``, and the height of a ``quantum`` (m).
    """
    if relief < FLATTEST_QUANTA * quantum or relief * FLATTEST_INDEX < (
        0.0 if math.isnan(spacing) else spacing
    ):
        return "flat"
    if skewness < DEPOSITIONAL:
        return "depositional, moving" if speed >= MOVING else "depositional, stationary"
    if skewness > EROSIONAL and bonded > 0.5:
        return "erosional"
    return "mixed"


@dataclass(frozen=True)
class Arrest:
    """When forms came to rest, and how far they had come by then."""

    age: float
    """Time (h) from the start until they stood; infinite where they still move, 0 where they never moved."""
    distance: float
    """Way (m) until then, or until the end."""


def arrest(hours: NDArray[np.float64], way: NDArray[np.float64], still: float = MOVING) -> Arrest:
    """When forms that came a ``way`` (m) within ``hours`` fell below the speed ``still`` (m/h) for good.

    Raises ValueError for fewer than two times, or times that do not increase.
    """
    hours, way = np.asarray(hours, np.float64), np.asarray(way, np.float64)
    if hours.size < 2 or hours.size != way.size or (np.diff(hours) <= 0).any():
        raise ValueError("at least two times that increase are needed, and a way for each")
    moving = np.flatnonzero(np.diff(way) / np.diff(hours) >= still)
    if not moving.size:
        return Arrest(0.0, 0.0)
    last = int(moving[-1]) + 1
    ended = last == hours.size - 1
    return Arrest(math.inf if ended else float(hours[last] - hours[0]), float(way[last] - way[0]))


def edge_retreat(
    before: NDArray, after: NDArray, level: float, cell_size: float, edge_length: float
) -> float:
    """Mean way (m) by which an edge went back: the area that fell below ``level`` (m) over the edge's length.

    Area that rose above it meanwhile is taken off, so that an edge that advances has a way below zero.
    """
    lost = np.count_nonzero(before >= level) - np.count_nonzero(after >= level)
    return float(lost) * cell_size**2 / edge_length
