"""How fast, and which way, bedforms travel."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise, takewhile

import numpy as np
from numpy.typing import NDArray

from barchan.measures.displacement import displacement
from barchan.measures.filters import Field, Periodic, smoothed, trend

LEAST_CORRELATION = 0.5
"""Surfaces that are less alike than this are not followed; ours."""

WHOLE = 0.05
"""Share of the wind's cycle by which a time may miss whole cycles of it; ours."""


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
    cycle: float = 0.0,
    path: Field | None = None,
) -> Migration:
    """Migration from surfaces (any unit) at several steps, to a fraction of a cell.

    Displacements are the peaks of the cross-correlations of the last surface with up to ``lags`` earlier
    ones, without their common trend towards open edges and smoothed over ``width`` cells; cells that are NaN
    are left out. Each lag's peak is sought near where the shorter lags point, so that crests are not mistaken
    for their neighbours; displacement against time is fitted by least squares through the origin. The
    shortest lag must be shorter than half a spacing over the speed.

    Where the wind repeats itself every ``cycle`` steps, only surfaces whole cycles earlier are compared (to
    5 % of a cycle): dunes that swing to and fro are where they were after each. The surfaces in between lead
    to where the peaks are sought; give them all, or the ``path`` that ``followed`` finds in them.

    Surfaces are compared back to the last flat one. NaN where the bed has no relief, where no surface is
    earlier by whole cycles, and where the surfaces' correlation is below 0.5: such surfaces are not the same
    one moved. Ground that stands still holds the peaks back: give the surface of the bedforms
    (``bedform_surface``).
    """
    earlier = whole_cycles(np.asarray(steps, float), cycle, lags)
    used = list(takewhile(lambda number: has_relief(surfaces[number]), earlier))
    if not used or not has_relief(surfaces[-1]):
        return NOWHERE
    compared = [np.asarray(surfaces[number], float) for number in (*used, -1)]
    if path is None and cycle:
        path = followed(surfaces, periodic, width)
    before = [step - steps[-1] for step in (steps[number] for number in used)]
    guesses = None if path is None else [path[-1] - path[number] for number in used]
    fields = [smoothed(field, width, periodic) for field in without_common_trend(compared, periodic)]
    return _fitted(-np.asarray(before, float), fields, guesses, periodic)


def has_relief(surface: NDArray) -> bool:
    """Whether a surface is not flat."""
    known = surface[np.isfinite(surface)]
    return bool(known.size and np.ptp(known) > 0)


def without_common_trend(surfaces: Sequence[Field], periodic: Periodic) -> list[Field]:
    """Surfaces less the trend of their mean; each one's own would move with its bedforms."""
    common = trend(np.mean(surfaces, axis=0), periodic)
    return [surface - common for surface in surfaces]


def whole_cycles(times: Field, cycle: float, lags: int) -> list[int]:
    """Numbers of up to ``lags`` times before the last by whole cycles, the latest first, one a cycle.

    Of several times about as many cycles earlier it is the one that misses them least.
    """
    earlier = range(len(times) - 2, -1, -1)
    if not cycle:
        return list(earlier)[:lags]
    best: dict[int, tuple[float, int]] = {}
    for number in earlier:
        cycles = (times[-1] - times[number]) / cycle
        whole = round(cycles)
        missed = abs(cycles - whole)
        if whole and missed <= WHOLE:
            best[whole] = min(best.get(whole, (missed, number)), (missed, number))
    return [best[whole][1] for whole in sorted(best)][:lags]


def followed(surfaces: Sequence[NDArray], periodic: Periodic, width: float = 2.0) -> Field:
    """Displacements (rows, columns) since the first of several surfaces, each found from the one before."""
    steps = [np.zeros(2), *(moved(before, after, periodic, width) for before, after in pairwise(surfaces))]
    return np.cumsum(steps, axis=0)


def moved(before: NDArray, after: NDArray, periodic: Periodic, width: float = 2.0) -> Field:
    """Displacement (rows, columns) from one surface to the next; 0 where they do not correlate."""
    pair = [np.asarray(before, float), np.asarray(after, float)]
    if not all(map(has_relief, pair)):
        return np.zeros(2)
    fields = [smoothed(field, width, periodic) for field in without_common_trend(pair, periodic)]
    shift, alike = displacement(fields[0], fields[1], None, periodic)
    return shift if alike >= LEAST_CORRELATION else np.zeros(2)


def _fitted(
    elapsed: Field, fields: Sequence[Field], guesses: Sequence[Field] | None, periodic: Periodic
) -> Migration:
    """The least-squares velocity of the last of some fields since each of the others.

    Peaks are sought near the ``guesses``, or without them where shorter lags point. A lag that does not
    correlate ends the search.
    """
    velocity, moments, square, correlation = np.zeros(2), np.zeros(2), 0.0, float("nan")
    for number, (time, before) in enumerate(zip(elapsed, fields[:-1], strict=True)):
        guess = velocity * time if square else None
        if guesses is not None:
            guess = guesses[number]
        shift, alike = displacement(before, fields[-1], guess, periodic)
        if alike < LEAST_CORRELATION:
            correlation = correlation if square else alike
            break
        correlation = alike
        moments, square = moments + shift * time, square + time**2
        velocity = moments / square
    if not square:
        return Migration(float("nan"), float("nan"), correlation)
    return Migration(float(velocity[1]), float(velocity[0]), correlation)
