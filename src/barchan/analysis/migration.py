"""How fast, and which way, bedforms travel."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from barchan.analysis.field import Field, Periodic, smoothed, tapered


@dataclass(frozen=True)
class Migration:
    """Mean displacement of the surface per step."""

    x: float
    """Eastwards (cells per step)."""
    y: float
    """Northwards (cells per step)."""
    correlation: float
    """How alike the surface and its shifted earlier self are (at most 1), over the longest lag used."""

    @property
    def speed(self) -> float:
        """Cells per step."""
        return float(np.hypot(self.x, self.y))

    def along(self, x: float, y: float) -> float:
        """Speed (cells per step) in the direction of a unit vector."""
        return self.x * x + self.y * y


NOWHERE = Migration(float("nan"), float("nan"), float("nan"))


def migration(
    steps: Sequence[int] | NDArray[np.integer],
    surfaces: Sequence[NDArray],
    periodic: Periodic = (True, True),
    width: float = 2.0,
    lags: int = 4,
) -> Migration:
    """Migration from surfaces (any unit) at several steps, to a fraction of a cell.

    Displacements are the peaks of the cross-correlations of the last surface with up to ``lags`` earlier
    ones, smoothed over ``width`` cells. Each lag's peak is sought near where the shorter lags point, so
    that crests are not mistaken for their neighbours; displacement against time is fitted by least
    squares through the origin. The shortest lag must be shorter than half a spacing over the speed.
    NaN where the bed has no relief or there are fewer than two surfaces.
    """
    if len(surfaces) < 2:
        return NOWHERE
    fields = [tapered(smoothed(s, width, periodic), periodic) for s in surfaces[-lags - 1 :]]
    if min(float(np.abs(f).max()) for f in fields) <= 0:
        return NOWHERE
    times = np.asarray(steps[-lags - 1 :], float)
    last = fft.rfft2(fields[-1])
    velocity = np.zeros(2)
    sums = np.zeros(2), 0.0
    correlation = 1.0
    for field, time in zip(fields[-2::-1], times[-2::-1], strict=True):
        elapsed = times[-1] - time
        guess = velocity * elapsed if sums[1] else None
        shift, correlation = _shift(field, last, guess)
        sums = sums[0] + shift * elapsed, sums[1] + elapsed**2
        velocity = sums[0] / sums[1]
    return Migration(float(velocity[1]), float(velocity[0]), correlation)


def _shift(before: Field, after: NDArray, guess: Field | None) -> tuple[Field, float]:
    """Displacement (rows, columns) from ``before`` to the field of spectrum ``after``."""
    shape = before.shape
    spectrum = fft.rfft2(before)
    product = np.conj(spectrum) * after
    surface = fft.irfft2(product, shape)
    norm = np.sqrt(
        fft.irfft2(np.abs(spectrum) ** 2, shape)[0, 0] * fft.irfft2(np.abs(after) ** 2, shape)[0, 0]
    )
    peak = np.unravel_index(int(np.argmax(surface * _near(shape, guess))), shape)
    place = np.array([_refined(surface, peak, axis) for axis in (0, 1)])
    nearest = np.zeros(2) if guess is None else guess
    size = np.array(shape)
    shift = place - np.round((place - nearest) / size) * size
    return shift, float(surface[peak] / norm)


def _near(shape: tuple[int, ...], guess: Field | None) -> Field:
    """A weight that favours displacements near a guess, or without one slightly the short ones."""
    weights = []
    for axis, size in enumerate(shape):
        centre = 0.0 if guess is None else guess[axis]
        spread = size / 2 if guess is None else max(2.0, abs(centre) / 4)
        distance = (np.arange(size) - centre + size / 2) % size - size / 2
        weights.append(np.exp(-0.5 * (distance / spread) ** 2))
    return np.asarray(weights[0][:, None] * weights[1][None, :])


def _refined(surface: Field, peak: tuple[np.intp, ...], axis: int) -> float:
    """A peak's place along an axis to a fraction of a cell, by a parabola through its neighbours."""
    size = surface.shape[axis]
    index = list(peak)
    values = []
    for step in (-1, 0, 1):
        index[axis] = np.intp((peak[axis] + step) % size)
        values.append(float(surface[tuple(index)]))
    left, middle, right = values
    curvature = left - 2 * middle + right
    return float(peak[axis]) + (0.5 * (left - right) / curvature if curvature < 0 else 0.0)
