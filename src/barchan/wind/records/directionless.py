"""Winds of a known speed without a direction, as those that stations report as variable (VRB)."""

import numpy as np
from numpy.typing import NDArray

from barchan.wind.clock import DAY, spoken
from barchan.wind.records.record import WindRecord
from barchan.words import counted


def direction_before(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    """Directions (degrees); where one is missing (NaN) that of the row before, or else of the row after."""
    known = ~np.isnan(direction)
    last = np.maximum.accumulate(np.where(known, np.arange(len(direction)), -1))
    return direction[np.where(last < 0, int(np.argmax(known)), last)]


def undirected_remarks(record: WindRecord) -> list[str]:
    """How many rows have no direction, how fast their winds are, and how long at most none is known."""
    which = record.undirected
    if which is None:
        return []
    share = float(record.duration[which].sum()) / record.seconds
    ends = np.append(np.flatnonzero(np.diff(which)), len(which) - 1)
    lasting = np.diff(np.cumsum(record.duration)[ends], prepend=0.0)[which[ends]]
    longest = float(lasting.max())
    long = f", for up to {spoken(longest)} on end" if longest > DAY else ""
    return [
        (
            f"in {counted(int(np.count_nonzero(which)), 'row')} ({100 * share:.1f} % of the time) there is a "
            f"speed, up to {record.speed[which].max():.1f} m/s, and no direction{long}; in a run the wind "
            "blows from the direction before"
        )
    ]
