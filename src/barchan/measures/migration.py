"""How fast, and which way, bedforms travel."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from barchan.measures.filters import Field, Periodic, smoothed, tapered


@dataclass(frozen=True)
class Migration:
    """Mean displacement of the surface per step."""

    x: float
    """Eastwards (cells per step)."""
    y: float
    """Northwards (cells per step)."""
    correlation: float
    """Correlation of the surface with its shifted earlier self (at most 1), over the longest lag used."""

    def __repr__(self) -> str:
        return (
            f"<Migration {self.x:.3g} east, {self.y:.3g} north (cells per step), "
            f"correlation {self.correlation:.2f}>"
        )

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
    surfaces = surfaces[-lags - 1 :]
    if len(surfaces) < 2 or any(np.ptp(surface) == 0 for surface in surfaces):
        return NOWHERE
    fields = [smoothed(surface, width, periodic) for surface in surfaces]
    times = np.asarray(steps[-lags - 1 :], float)
    velocity = np.zeros(2)
    sums = np.zeros(2), 0.0
    correlation = 1.0
    for field, time in zip(fields[-2::-1], times[-2::-1], strict=True):
        elapsed = times[-1] - time
        guess = velocity * elapsed if sums[1] else None
        shift, correlation = _followed(field, fields[-1], guess, periodic)
        sums = sums[0] + shift * elapsed, sums[1] + elapsed**2
        velocity = sums[0] / sums[1]
    return Migration(float(velocity[1]), float(velocity[0]), correlation)


PASSES = 3
"""Times that a displacement is sought where edges are open; each leaves about a tenth of the error."""


def _followed(before: Field, after: Field, guess: Field | None, periodic: Periodic) -> tuple[Field, float]:
    """Displacement (rows, columns) between two fields.

    A window at rest would hold back bedforms that move through it: the windows of open edges move along.
    """
    for _ in range(1 if all(periodic) else PASSES):
        half = np.zeros(2) if guess is None else guess / 2
        shift, correlation = _shift(tapered(before, periodic, -half), tapered(after, periodic, half), guess)
        guess = shift
    return shift, correlation


def _shift(before: Field, after: Field, guess: Field | None) -> tuple[Field, float]:
    """Displacement (rows, columns) from ``before`` to ``after``, both as if periodic."""
    shape = before.shape
    first, second = fft.rfft2(before), fft.rfft2(after)
    surface = fft.irfft2(np.conj(first) * second, shape)
    norm = np.linalg.norm(before) * np.linalg.norm(after)
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
