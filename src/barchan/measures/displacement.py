"""How far one surface lies from another, by cross-correlation."""

import numpy as np
import scipy

from barchan.measures.filters import Field, Periodic, tapered

PASSES = 3
"""Times that a displacement is sought where edges are open; each leaves about a tenth of the error."""


def displacement(before: Field, after: Field, guess: Field | None, periodic: Periodic) -> tuple[Field, float]:
    """Displacement (rows, columns) between two fields, near a guess, and their correlation there.

    A window at rest would hold back bedforms that move through it: the windows of open edges move along.
    """
    for _ in range(1 if all(periodic) else PASSES):
        half = np.zeros(2) if guess is None else guess / 2
        first, second = tapered(before, periodic, -half), tapered(after, periodic, half)
        correlations = _correlations(first, second, np.isfinite(before), np.isfinite(after))
        shift, correlation = _peak(correlations, guess)
        guess = shift
    return shift, correlation


def _correlations(first: Field, second: Field, known: Field, known_after: Field) -> Field:
    """Correlation of two fields at every displacement, both as if periodic.

    Where cells are unknown each correlation is over the cells that are known in both fields: a sum over all
    would favour the displacement that lays unknown cells on each other.
    """
    if known.all() and known_after.all():
        norm = np.linalg.norm(first) * np.linalg.norm(second)
        return _crossed(first, second) / norm if norm else np.zeros(first.shape)
    powers = _crossed(first**2, known_after) * _crossed(known, second**2)
    shared = _crossed(known, known_after) >= 0.25 * min(known.sum(), known_after.sum())
    usable = shared & (powers > 1e-12 * powers.max(initial=0.0))
    return np.where(usable, _crossed(first, second) / np.sqrt(np.where(usable, powers, 1.0)), 0.0)


def _crossed(first: Field, second: Field) -> Field:
    return scipy.fft.irfft2(np.conj(scipy.fft.rfft2(first)) * scipy.fft.rfft2(second), first.shape)


def _peak(correlations: Field, guess: Field | None) -> tuple[Field, float]:
    """Place of the highest correlation (rows, columns), to a fraction of a cell, and its value."""
    shape = correlations.shape
    peak = np.unravel_index(int(np.argmax(correlations * _near(shape, guess))), shape)
    place = np.array([_refined(correlations, peak, axis) for axis in (0, 1)])
    nearest = np.zeros(2) if guess is None else guess
    size = np.array(shape)
    return place - np.round((place - nearest) / size) * size, float(correlations[peak])


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
