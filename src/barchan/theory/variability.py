"""How many directions a wind has: the classes of Fryberger & Dean (1979)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.theory.drift import Drift

WITHIN = 45
"""Degrees within which a narrow wind has most of its drift."""

SMOOTHING = 12.0
"""Standard deviation (degrees) over which directions are smoothed before modes are counted; ours.

Wide enough for winds that are known by sectors of 30 degrees.
"""


@dataclass(frozen=True)
class Limits:
    """The limits between the classes; those of modes are ours."""

    narrow: float = 0.9
    """Least share of the drift that a narrow wind has within 45°."""
    acute: float = 90.0
    """Degrees up to which two modes are acute."""
    prominence: float = 0.2
    """A mode rises above the saddles beside it by at least this share of its own height."""
    least: float = 0.2
    """A mode is at least this share as high as the highest one."""


LIMITS = Limits()


@dataclass(frozen=True)
class Variability:
    """How the directions of a wind are distributed."""

    name: str
    """Narrow or wide unimodal, acute or obtuse bimodal, complex; still, where nothing moves."""
    modes: tuple[float, ...] = ()
    """Directions that the modes come from (degrees), the strongest first."""


def variability(drift: Drift, limits: Limits = LIMITS) -> Variability:
    """The directional class of a drift, and its modes.

    Narrow unimodal: 90 % of the drift within 45°. Otherwise by the number of modes of the smoothed
    distribution: one is wide unimodal; two are acute bimodal, up to 90° apart, or obtuse bimodal; any other
    number is complex. Fryberger & Dean name the classes; how modes are counted is ours.
    """
    if not drift.total > 0:
        return Variability("still")
    amount = drift.by_degree().amount
    modes = _modes(_smoothed(amount), limits)
    if _most_within(amount, WITHIN) >= limits.narrow * amount.sum():
        return Variability("narrow unimodal", modes[:1])
    if len(modes) == 1:
        return Variability("wide unimodal", modes)
    if len(modes) == 2:
        apart = abs((modes[0] - modes[1] + 180.0) % 360.0 - 180.0)
        return Variability("acute bimodal" if apart <= limits.acute else "obtuse bimodal", modes)
    return Variability("complex", modes)


def _most_within(amount: NDArray, width: int) -> float:
    """The largest sum over an arc of ``width`` degrees, both ends included."""
    sums = np.cumsum(np.concatenate([[0.0], amount, amount[:width]]))
    return float((sums[width + 1 :] - sums[: -width - 1]).max())


def _smoothed(amount: NDArray) -> NDArray[np.float64]:
    from scipy.ndimage import gaussian_filter1d

    return gaussian_filter1d(amount, SMOOTHING, mode="wrap")


def _modes(density: NDArray, limits: Limits) -> tuple[float, ...]:
    """Directions (degrees) of the modes of a distribution by whole degrees, the strongest first."""
    from scipy.signal import find_peaks

    lowest = int(np.argmin(density))
    turned = np.roll(density, -lowest)
    peaks, found = find_peaks(
        np.append(turned, turned[0]), height=limits.least * density.max(), prominence=0.0
    )
    peaks = peaks[found["prominences"] >= limits.prominence * turned[peaks]]
    strongest = peaks[np.argsort(-turned[peaks], kind="stable")]
    return tuple(float((peak + lowest) % 360) for peak in strongest)
