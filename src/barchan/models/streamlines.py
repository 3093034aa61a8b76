"""A wind over a bed of waves: how steeply it rises and falls, how fast it blows, how it drags at the bed."""

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


class WindOverWaves(NamedTuple):
    """How a wind differs over waves from that above a level bed; None: it does not.

    All but the stress are of mesh cells: squares between a stack and its neighbours in the east and north.
    """

    rise: NDArray[np.float64] | None = None
    """Rise over run along the wind."""
    gain: NDArray[np.float64] | None = None
    """Speed over that above a level bed."""
    aside: NDArray[np.float64] | None = None
    """Speed to the left over that above a level bed."""
    stress: NDArray[np.float64] | None = None
    """Shear stress along the wind on each cell over that on a level bed."""
    side_stress: NDArray[np.float64] | None = None
    """The same to the left of it."""


class Spectrum:
    """The waves of a bed, or of any field, that a wind from ``direction`` (degrees) blows over.

    A wave h has wave number k, of which k_w is along the wind and k_l to its left. At an open edge the bed is
    mirrored.
    """

    def __init__(self, surface: NDArray, lattice: Lattice, direction: float) -> None:
        """Take the ``surface`` apart."""
        self.shape, self.joined, self.cell_size = lattice.shape, lattice.periodic, lattice.cell_size
        mirrored = [(0, 0 if wraps else size) for wraps, size in zip(self.joined, self.shape, strict=True)]
        bed = np.pad(np.asarray(surface, np.float64), mirrored, mode="symmetric")
        self._size = bed.shape
        across, along = (2 * np.pi * np.fft.fftfreq(size, lattice.cell_size) for size in bed.shape)
        across, along = across[:, None], np.abs(along[: bed.shape[1] // 2 + 1])
        self.number = np.hypot(across, along)
        self.east, self.north = downwind(direction)
        self.along_wind = self.east * along + self.north * across
        self.to_left = self.east * across - self.north * along
        self.ahead = self.along_wind / np.where(self.number > 0.0, self.number, 1.0)
        self.waves = rfft2(bed)

    def field(self, share: NDArray[np.float64]) -> NDArray[np.float64]:
        """The sum over all waves of the ``share`` of each."""
        rows, columns = self.shape
        return np.asarray(irfft2(share * self.waves, s=self._size)[:rows, :columns])

    def slope(self, height: float) -> NDArray[np.float64]:
        """Rise over run of streamlines at a ``height`` (m): they follow waves by the share exp(-k height)."""
        line = self.field(np.exp(-self.number * height))
        east, north = (_mean_step(line, axis, self.joined) for axis in (1, 0))
        return (self.east * east + self.north * north) / self.cell_size

    def faster(self, height: float) -> NDArray[np.float64]:
        """Speed that comes to it without friction, as a share: (k_w² / k) h exp(-k height) (Lamb 1932)."""
        return over_mesh(
            self.field(self.ahead * self.along_wind * np.exp(-self.number * height)), self.joined
        )

    def aside(self, height: float) -> NDArray[np.float64]:
        """Speed to the left that comes to it, as a share: (k_w k_l / k) h exp(-k height)."""
        return over_mesh(self.field(self.ahead * self.to_left * np.exp(-self.number * height)), self.joined)

    def stress(self, crests: float, stoss: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Stress on the bed that comes to it along the wind and to its left, as a share.

        It is (A + i B) (k_w / k) h times k_w and times k_l, for waves with k_w > 0. A (``crests``) is what it
        rises by on crests, B (``stoss``) on faces that look upwind, so that it is highest ahead of crests
        (Fourrière et al. 2010).
        """
        turned = self.ahead * (crests + 1j * stoss * np.sign(self.along_wind))
        return self.field(turned * self.along_wind), self.field(turned * self.to_left)


def wind_over_waves(
    surface: NDArray,
    lattice: Lattice,
    direction: float,
    height: float | None,
    speedup: float,
    stress: tuple[float, float],
) -> WindOverWaves:
    """How a wind over the waves of a ``surface`` (m) differs from one over a level bed.

    Its streamlines are those of a ``height`` (m), and level where not given. Its speed differs by ``speedup``
    times as much as without friction, the ``stress`` on the bed by A and B. All are bounded, for the theory
    is one of low waves.
    """
    if height is None and not any(stress):
        return WindOverWaves()
    waves = Spectrum(surface, lattice, direction)
    found = WindOverWaves()
    if height is not None:
        found = found._replace(rise=np.clip(waves.slope(height), -STEEPEST, STEEPEST))
        if speedup > 0.0:
            gain = np.clip(1.0 + speedup * waves.faster(height), LEAST, MOST)
            aside = np.clip(speedup * waves.aside(height), -STEEPEST, STEEPEST)
            found = found._replace(gain=gain, aside=aside)
    if any(stress):
        along, aside = waves.stress(*stress)
        along = np.clip(1.0 + along, LEAST**2, MOST**2)
        found = found._replace(stress=along, side_stress=np.clip(aside, -along, along))
    return found


def _mean_step(line: NDArray[np.float64], axis: int, joined: tuple[bool, bool]) -> NDArray[np.float64]:
    """The mean of the steps along an axis at both sides of each mesh cell."""
    step = following(line, axis, joined[axis]) - line
    return 0.5 * (step + following(step, 1 - axis, joined[1 - axis]))
