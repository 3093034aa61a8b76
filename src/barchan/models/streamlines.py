"""Streamlines of a wind over a bed of waves: how steeply they rise and fall, how much faster it blows."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, rfft2

from barchan.bed import Lattice
from barchan.models.grain_mesh import following, over_mesh
from barchan.wind.segment import downwind

STEEPEST = 0.3
"""Slope of streamlines at most, and how far they turn: over steeper ground the flow comes off, which this
theory does not tell."""

LEAST, MOST = 0.1, 2.0
"""Speed over that above a level bed, in the troughs of waves at least and over their crests at most."""


class Streamlines(NamedTuple):
    """How a wind differs over waves from that above a level bed, for each mesh cell.

    That is the square between a stack and its neighbours in the east and north.
    """

    slope: NDArray[np.float64]
    """Rise over run along the wind."""
    faster: NDArray[np.float64]
    """Speed that comes to it, as a share."""
    aside: NDArray[np.float64]
    """Speed to the left of it, as a share."""


def wind_over_waves(
    surface: NDArray, lattice: Lattice, direction: float, height: float, speedup: float
) -> Streamlines:
    """Slope of a wind, its speed over that above a level bed, and the part of it that blows to its left.

    Speeds differ by ``speedup`` times as much as those of a flow without friction; see ``streamlines``. All
    are bounded, for the theory is one of low waves.
    """
    slope, faster, aside = streamlines(surface, lattice, direction, height)
    speed = np.clip(1.0 + speedup * faster, LEAST, MOST)
    turned = np.clip(speedup * aside, -STEEPEST, STEEPEST)
    return Streamlines(np.clip(slope, -STEEPEST, STEEPEST), speed, turned)


def streamlines(surface: NDArray, lattice: Lattice, direction: float, height: float) -> Streamlines:
    """How a wind from ``direction`` (degrees) without friction flows over a ``surface`` (m) of low waves.

    At a ``height`` (m) over it the flow follows a wave h with wave number k by the share exp(-k height), is
    faster by (k_w² / k) h exp(-k height) and turns to the left by (k_w k_l / k) h exp(-k height), k_w and
    k_l being the components of k along the wind and to its left (Lamb 1932). At an open edge the bed is
    mirrored and the last slopes are 0.
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
    ahead = (east * along + north * across) / np.where(number > 0.0, number, 1.0)
    shares = (1.0, ahead * (east * along + north * across), ahead * (east * across - north * along))
    line, faster, aside = (irfft2(share * waves, s=bed.shape)[:rows, :columns] for share in shares)
    slope = east * _mean_step(line, 1, joined) + north * _mean_step(line, 0, joined)
    return Streamlines(slope / lattice.cell_size, over_mesh(faster, joined), over_mesh(aside, joined))


def _mean_step(line: NDArray[np.float64], axis: int, joined: tuple[bool, bool]) -> NDArray[np.float64]:
    """The mean of the steps along an axis at both sides of each mesh cell."""
    step = following(line, axis, joined[axis]) - line
    return 0.5 * (step + following(step, 1 - axis, joined[1 - axis]))
