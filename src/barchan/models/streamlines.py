"""Streamlines of a wind over a bed of waves: how steeply they rise and fall, how much faster it blows."""

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, rfft2

from barchan.bed import Lattice
from barchan.wind.segment import downwind

STEEPEST = 0.3
"""Slope of streamlines at most: over steeper ground the flow comes off, which this theory does not tell."""

LEAST, MOST = 0.1, 2.0
"""Speed over that above a level bed, in the troughs of waves at least and over their crests at most."""


def wind_over_waves(
    surface: NDArray, lattice: Lattice, direction: float, height: float, speedup: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Slope of a wind, and its speed over that above a level bed.

    It is ``speedup`` times as much faster over crests as a flow without friction; see ``streamlines``. Both
    are bounded, for the theory is one of low waves.
    """
    slope, faster = streamlines(surface, lattice, direction, height)
    return np.clip(slope, -STEEPEST, STEEPEST), np.clip(1.0 + speedup * faster, LEAST, MOST)


def streamlines(
    surface: NDArray, lattice: Lattice, direction: float, height: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Slope (rise over run) of streamlines along a wind from ``direction`` (degrees), and its speed-up.

    At a ``height`` (m) over a ``surface`` (m) of low waves the flow without friction follows a wave h with
    wave number k by the share exp(-k height), and is faster by (k_w² / k) h exp(-k height), k_w being the
    component of k along the wind (Lamb 1932). The speed-up is a share, 0 over a flat bed. One value for each
    mesh cell, the square between a stack and its neighbours in the east and north; at an open edge the bed
    is mirrored and the last slopes are 0.
    """
    joined = lattice.periodic
    rows, columns = lattice.shape
    mirrored = [(0, 0 if wraps else size) for wraps, size in zip(joined, lattice.shape, strict=True)]
    bed = np.pad(np.asarray(surface, np.float64), mirrored, mode="symmetric")
    across, along = (2 * np.pi * np.fft.fftfreq(size, lattice.cell_size) for size in bed.shape)
    across, along = across[:, None], np.abs(along[: bed.shape[1] // 2 + 1])
    number = np.hypot(across, along)
    east, north = downwind(direction)
    waves = rfft2(bed) * np.exp(-number * height)
    faster = (east * along + north * across) ** 2 / np.where(number > 0.0, number, 1.0)
    line, gain = (irfft2(part, s=bed.shape)[:rows, :columns] for part in (waves, faster * waves))
    slope = east * _mean_step(line, 1, joined) + north * _mean_step(line, 0, joined)
    middle = 0.5 * (gain + _next(gain, 1, joined[1]))
    return slope / lattice.cell_size, 0.5 * (middle + _next(middle, 0, joined[0]))


def _mean_step(line: NDArray[np.float64], axis: int, joined: tuple[bool, bool]) -> NDArray[np.float64]:
    """The mean of the steps along an axis at both sides of each mesh cell."""
    step = _next(line, axis, joined[axis]) - line
    return 0.5 * (step + _next(step, 1 - axis, joined[1 - axis]))


def _next(values: NDArray[np.float64], axis: int, joined: bool) -> NDArray[np.float64]:
    """The values one place on along an axis; at an open edge the last ones again."""
    moved = np.roll(values, -1, axis)
    if not joined:
        last = [slice(None), slice(None)]
        last[axis] = slice(-1, None)
        moved[tuple(last)] = values[tuple(last)]
    return moved
