"""The change from one survey of a surface to the next, with errors."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.measures.displacement import displacement
from barchan.measures.filters import Field, Periodic, smoothed
from barchan.measures.migration import LEAST_CORRELATION, has_relief, without_common_trend

WINDOWS = 4
"""Windows to a side in which displacements are compared."""

SMALLEST = 24
"""Cells to a side of the smallest window."""

FEWEST = 3
"""Windows from which on their spread gives an error."""

CERTAIN = 1.96
"""Standard errors beyond which a change is told from noise at 95 %."""

TOGETHER = 2.0
"""Width (cells) over which changes are smoothed to be told from noise together."""

FIELDS_OF_NOISE = 4
"""Fields of noise, each counted upwards and downwards, from which follows what noise adds to a volume."""


@dataclass(frozen=True)
class Estimate:
    """A value and its standard error, in the same unit; NaN where there is none."""

    value: float
    error: float


@dataclass(frozen=True)
class Displacement:
    """How far bedforms have moved between two surveys (cells)."""

    east: Estimate
    north: Estimate
    correlation: float
    """Of the first surface, moved, with the second."""
    windows: int
    """Parts of the field whose own displacements agree with it well enough to be counted."""


@dataclass(frozen=True)
class Budget:
    """Volumes between two surveys (m³)."""

    deposited: Estimate
    eroded: Estimate
    net: Estimate
    """All of the change, also what is within the noise."""
    noise: float
    """Standard deviation (m) of the noise of a cell's change."""
    area: float
    """Area (m²) that both surveys know."""
    certain_share: float
    """Share of it whose change is told from noise."""


def displacement_between(
    before: NDArray, after: NDArray, periodic: Periodic = (False, False), width: float = 2.0
) -> Displacement:
    """Displacement of bedforms from one surface to the next, by cross-correlation, with its error.

    As in ``migration``. The field is cut into up to 4 × 4 windows of 24 cells or more to a side, and each
    one's displacement is sought near that of the field; those that correlate by 0.5 count. The error is their
    standard deviation over the square root of their number: it holds the noise of the surveys and the
    differences of the dunes' own speeds. NaN where surfaces correlate by less than 0.5, errors NaN where
    fewer than 3 windows count. Raises ValueError where the shapes differ.
    """
    _require_alike(before, after)
    nothing = Estimate(float("nan"), float("nan"))
    pair = [np.asarray(before, float), np.asarray(after, float)]
    if not all(map(has_relief, pair)):
        return Displacement(nothing, nothing, float("nan"), 0)
    first, second = (smoothed(one, width, periodic) for one in without_common_trend(pair, periodic))
    shift, correlation = displacement(first, second, None, periodic)
    if correlation < LEAST_CORRELATION:
        return Displacement(nothing, nothing, correlation, 0)
    parts = np.array(list(_in_windows(first, second, shift))).reshape(-1, 2)
    errors = parts.std(axis=0, ddof=1) / np.sqrt(len(parts)) if len(parts) >= FEWEST else np.full(2, np.nan)
    north, east = (Estimate(float(v), float(e)) for v, e in zip(shift, errors, strict=True))
    return Displacement(east, north, correlation, len(parts))


def _in_windows(first: Field, second: Field, shift: Field) -> Iterator[Field]:
    """The displacements of the windows that correlate."""
    cuts = []
    for size, moved in zip(first.shape, shift, strict=True):
        count = min(WINDOWS, int(size // max(SMALLEST, 3 * abs(moved))))
        cuts.append([slice(size * i // count, size * (i + 1) // count) for i in range(count)])
    least = 0.25 * float(np.nanvar(first))
    for rows in cuts[0]:
        for columns in cuts[1]:
            one, other = first[rows, columns], second[rows, columns]
            known = np.isfinite(one) & np.isfinite(other)
            if known.mean() < 0.5 or min(one.var(where=known), other.var(where=known)) < least:
                continue
            found, alike = displacement(one, other, shift, (False, False))
            if alike >= LEAST_CORRELATION:
                yield found


def budget(
    before: NDArray,
    after: NDArray,
    cell_area: float,
    noise: float | None = None,
    offset: float = 0.0,
) -> Budget:
    """Volumes deposited, eroded and both together between two surfaces (m), on cells of an area (m²).

    ``noise`` (m) is the standard deviation of the random error of a cell's change, estimated by
    ``difference_noise`` where it is not given. A cell counts as deposited or eroded where its change exceeds
    1.96 of it or, as dunes are wider than cells, where the change smoothed over 2 cells exceeds 1.96 of the
    noise that smoothing leaves; what noise alone leads one to expect so on the cells that did not change is
    taken off.
    ``offset`` (m) is the standard error of the level of one survey against the other, common to all
    cells; the surveys themselves cannot tell it. Errors are all together: sqrt(n) · noise, the scatter of
    what noise adds, and n · offset, on n cells. Cells of NaN in either are left out. Raises ValueError where
    the shapes differ.
    """
    _require_alike(before, after)
    change = np.asarray(after, float) - np.asarray(before, float)
    sigma = difference_noise(change) if noise is None else noise
    known = change[np.isfinite(change)]
    up, down = (change[where] for where in _told(change, sigma))
    by_chance = _by_chance(change, sigma, known.size - up.size - down.size)

    def volume(part: Field, chance: Estimate) -> Estimate:
        random = np.hypot(np.sqrt(part.size) * sigma, chance.error)
        error = float(np.hypot(random, part.size * offset))
        return Estimate((float(part.sum()) - chance.value) * cell_area, error * cell_area)

    return Budget(
        deposited=volume(up, by_chance),
        eroded=volume(-down, by_chance),
        net=volume(known, Estimate(0.0, 0.0)),
        noise=sigma,
        area=known.size * cell_area,
        certain_share=(up.size + down.size) / known.size if known.size else float("nan"),
    )


_MASK = np.array([[1.0, -2.0, 1.0], [-2.0, 4.0, -2.0], [1.0, -2.0, 1.0]])


def _told(change: Field, sigma: float) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Cells that rose and that fell (m) beyond noise, by themselves or with those about them."""
    if sigma == 0.0:
        return change > 0.0, change < 0.0
    wide, limit = smoothed(change, TOGETHER, (False, False)), CERTAIN * sigma
    # a Gaussian of width w leaves 1 / (2 √π w) of the deviation of white noise
    least = limit / (2.0 * np.sqrt(np.pi) * TOGETHER)
    risen = (change > limit) | ((wide > least) & (change >= -limit))
    fallen = (change < -limit) | ((wide < -least) & (change <= limit))
    return risen, fallen


def _by_chance(change: Field, sigma: float, still: int) -> Estimate:
    """Sum (m) of what noise alone lets count as a rise on a field where so many cells seem not to change.

    Mean and standard deviation of some fields of noise, always the same.
    """
    if not sigma > 0.0 or not still:
        return Estimate(0.0, 0.0)
    rng, known, sums = np.random.default_rng(1), np.isfinite(change), []
    for _ in range(FIELDS_OF_NOISE):
        noise = np.where(known, rng.normal(0.0, sigma, change.shape), np.nan)
        rises, falls = _told(noise, sigma)
        share = min(still / max(int(known.sum() - rises.sum() - falls.sum()), 1), 1.0)
        sums += [share * noise[rises].sum(), -share * noise[falls].sum()]
    return Estimate(float(np.mean(sums)), float(np.std(sums, ddof=1)))


def difference_noise(change: NDArray) -> float:
    """Standard deviation (m) of the noise of a change that is independent from cell to cell.

    A mask that planes and second-degree surfaces do not pass (Immerkær 1996), and the median of its sizes,
    so that brinks and slip faces do not count. Noise that neighbours share is not seen: of resampled surveys
    the true error is larger. NaN where fewer than nine cells are known.
    """
    passed = scipy.ndimage.convolve(np.asarray(change, float), _MASK, mode="nearest")
    inner = passed[1:-1, 1:-1]
    inner = inner[np.isfinite(inner)]
    return float(np.median(np.abs(inner)) / 0.674490 / 6.0) if inner.size else float("nan")


def _require_alike(before: NDArray, after: NDArray) -> None:
    if before.shape != after.shape:
        raise ValueError(f"surfaces of {before.shape} and {after.shape} cells; allowed: the same")
