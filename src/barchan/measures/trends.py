"""How measures change in time: whether they are steady, and how bedforms coarsen."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.measures.fits import PowerLaw, power_law


@dataclass(frozen=True)
class Steadiness:
    """A series over a window of time."""

    mean: float
    spread: float
    """Range (highest less lowest) over the mean, without a unit."""
    drift: float
    """Change of the fitted straight line over the window, over the mean."""


def steadiness(times: NDArray, values: NDArray, window: float) -> Steadiness:
    """How much a series varies over the last ``window`` of its time.

    A window that is longer than the series takes all of it. All NaN where a value in it is NaN, where there
    are fewer than 3, or where the mean is 0.
    """
    t, v = np.asarray(times, float), np.asarray(values, float)
    inside = t >= t[-1] - window if t.size else np.zeros(0, bool)
    t, v = t[inside], v[inside]
    if len(v) < 3 or not np.isfinite(v).all() or v.mean() == 0.0:
        return Steadiness(float("nan"), float("nan"), float("nan"))
    mean = float(v.mean())
    about = t - t.mean()
    slope = float((about * v).sum() / (about**2).sum())
    return Steadiness(mean, float(np.ptp(v)) / abs(mean), slope * float(np.ptp(t)) / abs(mean))


def coarsening(times: NDArray, sizes: NDArray, first: float = 0.0, last: float = float("inf")) -> PowerLaw:
    """The power law size = factor · time^exponent between two times, with the exponent's 95 % interval.

    Times count from the flat bed. Neighbouring frames resemble each other and count as fewer; see
    ``power_law``. Choose a window without the first growth, whose spacing stands still, and without the time
    when only a few bedforms are left in the field.
    """
    t, s = np.asarray(times, float), np.asarray(sizes, float)
    inside = (t >= first) & (t <= last)
    return power_law(t[inside], s[inside], in_order=True)
