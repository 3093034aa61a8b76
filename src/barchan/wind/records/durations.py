"""How long each row of a record stands for."""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

GAP = 3.0
"""A row stands until the next one; rows further apart than this many usual steps have a gap between them."""

NEIGHBOURS = 12
"""Steps before, or after, of which the median is the usual one there."""


def durations(time: NDArray[np.float64]) -> tuple[float, NDArray[np.float64], int]:
    """The usual step (s), how long each row stands for (s), and the number of gaps.

    ``time`` (s) increases. The usual step is that of the rows nearby, so that a record whose interval
    changes,
    say from three hours to one, counts each row for its own.
    """
    steps = np.diff(time)
    before, after = _medians(steps)
    gap = steps > GAP * np.maximum(before, after)
    last = float(before[-1]) if len(steps) == 1 else float(np.median(steps[-NEIGHBOURS:]))
    usual = np.where(np.isfinite(before), before, after)
    return float(np.median(steps)), np.append(np.where(gap, usual, steps), last), int(np.count_nonzero(gap))


def _medians(steps: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Median of the steps before each step, and of those after it; its own median where there are none."""
    count = min(NEIGHBOURS, max(len(steps) - 1, 1))
    windows = np.median(sliding_window_view(steps, count), axis=1)
    places = np.arange(len(steps))
    before = windows[np.clip(places - count, 0, len(windows) - 1)]
    after = windows[np.clip(places + 1, 0, len(windows) - 1)]
    return before, after
