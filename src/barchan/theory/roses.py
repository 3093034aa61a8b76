"""Roses: shares by direction, for drawing and for tables."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from barchan.theory.drift import Drift
from barchan.wind.records import WindRecord

SECTORS = 16
"""Directions of a rose; fewer hide the variation of the wind."""

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


def sand_rose(drift: Drift, count: int = SECTORS) -> NDArray[np.float64]:
    """Sand moved by the winds of each sector, in the drift's unit; sectors are where the winds come from."""
    return np.bincount(sectors(drift.direction, count), drift.amount, count).astype(np.float64)


def wind_rose(
    record: WindRecord, limits: Sequence[float], count: int = SECTORS
) -> tuple[NDArray[np.float64], float]:
    """Shares of the time by sector (row) and class of speed (column), and the share of calms.

    ``limits`` (m/s) part the classes: below the first, between them, and from the last on.
    """
    blows = record.speed > 0.0
    share = record.duration / record.seconds
    group = np.searchsorted(np.asarray(limits), record.speed, side="right")
    columns = len(limits) + 1
    place = sectors(record.direction, count) * columns + group
    table = np.bincount(place[blows], share[blows], count * columns)
    return table.reshape(count, columns).astype(np.float64), float(share[~blows].sum())
