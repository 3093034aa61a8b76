"""Roses: shares by direction, for drawing and for tables."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from barchan.theory.drift import Drift
from barchan.wind.records import WindRecord

SECTORS = 16
"""Directions of a rose."""

CLASSES = 5
"""Classes of speed in a wind rose."""


def speed_limits(record: WindRecord, threshold: float) -> list[float]:
    """Limits (m/s) of classes of speed: half the ``threshold``, the threshold, and equal steps beyond it."""
    fast = float(np.quantile(record.speed, 0.995))
    step = max(np.ceil((fast - threshold) / (CLASSES - 2)), 1.0)
    return [threshold / 2, threshold, *(float(threshold + step * k) for k in range(1, CLASSES - 2))]


def sectors(directions: NDArray, count: int = SECTORS) -> NDArray[np.int64]:
    """The sector of each direction (degrees), clockwise; sector 0 has its middle in the north."""
    return np.floor(directions * (count / 360.0) + 0.5).astype(np.int64) % count


def sector_sums(
    directions: NDArray, amounts: NDArray, width: float = 0.0, count: int = SECTORS
) -> NDArray[np.float64]:
    """Amounts by sector, each shared evenly over the ``width`` (degrees) that its direction stands for.

    Whole directions counted by sectors would be biased: of the tens of degrees three fall into the
    sectors of N, E,
    S and W of 16, and two into the others.
    """
    if width <= 0.0:
        return np.bincount(sectors(directions, count), amounts, count).astype(np.float64)
    low = (directions - width / 2) * (count / 360.0) + 0.5
    reach = width * count / 360.0
    first = np.floor(low + 1e-9)
    sums = np.zeros(count)
    for k in range(int(np.ceil(reach)) + 1):
        overlap = np.minimum(low + reach, first + k + 1) - np.maximum(low, first + k)
        share = np.maximum(overlap, 0.0) / reach
        sums += np.bincount((first + k).astype(np.int64) % count, amounts * share, count)
    return sums


def sand_rose(drift: Drift, count: int = SECTORS) -> NDArray[np.float64]:
    """Sand moved by the winds of each sector, in the drift's unit; sectors are where the winds come from."""
    return sector_sums(drift.direction, drift.amount, drift.width, count)


def wind_rose(
    record: WindRecord, limits: Sequence[float], count: int = SECTORS
) -> tuple[NDArray[np.float64], float, float]:
    """Shares of the time by sector (row) and class of speed (column); of calms; of winds without a direction.

    ``limits`` (m/s) part the classes: below the first, between them, and from the last on. Directions are
    shared over what they stand for, as in ``sector_sums``.
    """
    unknown = record.without_direction
    blows = (record.speed > 0.0) & ~unknown
    share = record.duration / record.seconds
    group = np.searchsorted(np.asarray(limits), record.speed, side="right")
    columns = []
    for number in range(len(limits) + 1):
        these = blows & (group == number)
        columns.append(sector_sums(record.direction[these], share[these], record.direction_width, count))
    return np.stack(columns, axis=1), record.calm_share, float(share[unknown].sum())
