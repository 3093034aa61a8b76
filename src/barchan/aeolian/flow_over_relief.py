"""A wind over a bed of waves: how steeply it rises and falls, how fast it blows, how it drags at the bed."""

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, rfft2

from barchan.aeolian.mesh import following, over_mesh
from barchan.directions import downwind
from barchan.lattice import Lattice

STEEPEST = 0.3
"""Slope of streamlines at most, and how far they turn: over steeper ground the flow comes off, which this
theory does not tell."""

LEAST, MOST = 0.1, 2.0
"""Speed over that above a level bed, in the troughs of waves at least and over their crests at most."""

_KEPT = 2
"""Lattices and winds whose wave numbers, and shares of waves, are kept: they are found anew at every wind."""


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


class WaveNumbers:
    """Wave numbers of the waves on a lattice, and along a wind from ``direction`` (degrees) and to its left.

    At an open edge the bed is mirrored.
    """

    def __init__(self, lattice: Lattice, direction: float) -> None:
        """Find them, and the unit vector along the wind."""
        mirrored = [
            size if wraps else 2 * size for size, wraps in zip(lattice.shape, lattice.periodic, strict=True)
        ]
        self.rows, self.columns = mirrored
        across, along = (2 * np.pi * np.fft.fftfreq(size, lattice.cell_size) for size in mirrored)
        across, along = across[:, None], np.abs(along[: self.columns // 2 + 1])
        self.number = np.hypot(across, along)
        self.east, self.north = downwind(direction)
        self.along_wind = self.east * along + self.north * across
        self.to_left = self.east * across - self.north * along
        self.ahead = self.along_wind / np.where(self.number > 0.0, self.number, 1.0)


@lru_cache(_KEPT)
def _wave_numbers(lattice: Lattice, direction: float) -> WaveNumbers:
    return WaveNumbers(lattice, direction)


@lru_cache(_KEPT)
def _streamline_shares(lattice: Lattice, direction: float, height: float) -> NDArray[np.float64]:
    """What streamlines at a ``height`` (m) have of each wave: exp(-k height)."""
    return np.asarray(np.exp(-_wave_numbers(lattice, direction).number * height))


@lru_cache(_KEPT)
def _stress_shares(
    lattice: Lattice, direction: float, crests: float, stoss: float
) -> tuple[NDArray, NDArray]:
    """What the stress has of each, along the wind and to its left; see ``Spectrum.stress``."""
    waves = _wave_numbers(lattice, direction)
    turned = waves.ahead * (crests + 1j * stoss * np.sign(waves.along_wind))
    return turned * waves.along_wind, turned * waves.to_left


@lru_cache(_KEPT)
def _sharing_shares(lattice: Lattice, direction: float, along: float, across: float) -> NDArray[np.float64]:
    """What is left of each by a Gaussian's width (m) ``along`` the wind and one ``across`` it."""
    waves = _wave_numbers(lattice, direction)
    return np.asarray(np.exp(-0.5 * ((along * waves.along_wind) ** 2 + (across * waves.to_left) ** 2)))


class Spectrum:
    """The waves of a bed, or of any field, that a wind from ``direction`` (degrees) blows over.

    A wave h has wave number k, of which k_w is along the wind and k_l to its left.
    """

    def __init__(self, surface: NDArray, lattice: Lattice, direction: float) -> None:
        """Take the ``surface`` apart."""
        self.lattice, self.direction = lattice, direction
        self.numbers = _wave_numbers(lattice, direction)
        bed = np.asarray(surface, np.float64)
        if not all(lattice.periodic):
            mirrored = [
                (0, 0 if wraps else size) for wraps, size in zip(lattice.periodic, lattice.shape, strict=True)
            ]
            bed = np.pad(bed, mirrored, mode="symmetric")
        self.waves = rfft2(bed)

    def field(self, share: NDArray) -> NDArray[np.float64]:
        """The sum over all waves of the ``share`` of each."""
        rows, columns = self.lattice.shape
        whole = irfft2(share * self.waves, s=(self.numbers.rows, self.numbers.columns))
        return np.asarray(whole[:rows, :columns])

    def slope(self, height: float) -> NDArray[np.float64]:
        """Rise over run of streamlines at a ``height`` (m): they follow waves by the share exp(-k height)."""
        line = self.field(_streamline_shares(self.lattice, self.direction, height))
        east, north = (_mean_step(line, axis, self.lattice.periodic) for axis in (1, 0))
        return (self.numbers.east * east + self.numbers.north * north) / self.lattice.cell_size

    def faster(self, height: float) -> NDArray[np.float64]:
        """Speed that comes to it without friction, as a share: (k_w² / k) h exp(-k height) (Lamb 1932)."""
        return self._over_mesh(self.numbers.along_wind, height)

    def aside(self, height: float) -> NDArray[np.float64]:
        """Speed to the left that comes to it, as a share: (k_w k_l / k) h exp(-k height)."""
        return self._over_mesh(self.numbers.to_left, height)

    def _over_mesh(self, way: NDArray[np.float64], height: float) -> NDArray[np.float64]:
        share = self.numbers.ahead * way * _streamline_shares(self.lattice, self.direction, height)
        return over_mesh(self.field(share), self.lattice.periodic)

    def stress(self, crests: float, stoss: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Stress on the bed that comes to it along the wind and to its left, as a share.

        It is (A + i B) (k_w / k) h times k_w and times k_l, for waves with k_w > 0. A (``crests``) is what it
        rises by on crests, B (``stoss``) on faces that look upwind, so that it is highest ahead of crests
        (Fourrière et al. 2010).
        """
        along, aside = _stress_shares(self.lattice, self.direction, crests, stoss)
        return self.field(along), self.field(aside)

    def shared(self, along: float, across: float) -> NDArray[np.float64]:
        """The field spread by a Gaussian of a width (m) ``along`` the wind and one ``across`` it."""
        return self.field(_sharing_shares(self.lattice, self.direction, along, across))


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


def stress_coefficients(ratio: Any) -> tuple[Any, Any]:
    """A (in phase with height) and B (in phase with slope) for wavelengths over roughness lengths.

    Fourrière, A., Claudin, P. & Andreotti, B. (2010), Journal of Fluid Mechanics 649, 287-328.
    """
    r = np.log(np.maximum(ratio, 1.0))
    a = 2 + (1.0702 + 0.093069 * r + 0.10838 * r**2 + 0.024835 * r**3) / (
        1 + 0.041603 * r**2 + 0.0010625 * r**4
    )
    b = (0.036989 + 0.15765 * r + 0.11518 * r**2 + 0.0020249 * r**3) / (
        1 + 0.0028725 * r**2 + 0.00053483 * r**4
    )
    return a, b
