"""Flow over relief: a wind over waves by linear theory, how it climbs, speeds up, and drags at the bed."""

from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.edges import mirrored
from barchan.aeolian.mesh import following, over_mesh
from barchan.aeolian.transforms import several, sum_of_waves, waves_of
from barchan.directions import downwind
from barchan.lattice import Lattice

STEEPEST = 0.3
"""Largest slope of streamlines, and largest ratio of crosswind: over steeper ground the flow separates, which
linear theory cannot describe."""

LEAST, MOST = 0.1, 2.0
"""Least speed in the troughs of waves, and largest over their crests, over the speed above a level bed."""

_KEPT = 2
"""Lattices and winds whose wave numbers and spectral factors are kept for the next use."""


class ReliefWind(NamedTuple):
    """A wind over waves beside one above a level bed; None: they do not differ.

    All but the stress are by mesh cell: the squares between a stack and its neighbours in the east and north.
    """

    streamline_slope: NDArray[np.float64] | None = None
    """Rise over run of streamlines along the wind."""
    speedup: NDArray[np.float64] | None = None
    """Speed over that above a level bed."""
    crosswind_ratio: NDArray[np.float64] | None = None
    """Speed to the left of the wind over the speed along it."""
    stress: NDArray[np.float64] | None = None
    """Shear stress along the wind on each cell over that on a level bed."""
    crosswind_stress: NDArray[np.float64] | None = None
    """Shear stress to the left of the wind over that on a level bed."""


class WaveNumbers:
    """Wave numbers of the waves on a lattice, and along a wind from ``direction`` (degrees) and to its left.

    At an open edge the bed is mirrored.
    """

    def __init__(self, lattice: Lattice, direction: float) -> None:
        """Find them, and the unit vector along the wind."""
        shape = [
            size if wraps else 2 * size for size, wraps in zip(lattice.shape, lattice.periodic, strict=True)
        ]
        self.rows, self.columns = shape
        across, along = (2 * np.pi * np.fft.fftfreq(size, lattice.cell_size) for size in shape)
        across, along = across[:, None], np.abs(along[: self.columns // 2 + 1])
        self.number = np.hypot(across, along)
        self.east, self.north = downwind(direction)
        self.along_wind = self.east * along + self.north * across
        self.to_left = self.east * across - self.north * along
        self.ahead = self.along_wind / np.where(self.number > 0.0, self.number, 1.0)

    def wavelength_over(self, length: float) -> NDArray[np.float64]:
        """Wavelength over a ``length`` (m); 1 for the mean, which has none."""
        return 2.0 * np.pi / np.where(self.number > 0.0, self.number * length, 2.0 * np.pi)


@lru_cache(_KEPT)
def _wave_numbers(lattice: Lattice, direction: float) -> WaveNumbers:
    return WaveNumbers(lattice, direction)


@lru_cache(_KEPT)
def _streamline_factor(lattice: Lattice, direction: float, height: float) -> NDArray[np.float64]:
    """Amplitude of streamlines at a ``height`` (m) over that of each wave: exp(-k height)."""
    return np.asarray(np.exp(-_wave_numbers(lattice, direction).number * height))


Stress = tuple[float | None, float | None]
"""A and B of the stress on the bed; None: by roughness."""


@lru_cache(_KEPT)
def _stress_factors(
    lattice: Lattice, direction: float, stress: Stress, roughness: float
) -> tuple[NDArray, NDArray]:
    """Stress along the wind and to its left over the amplitude of each wave; see ``LinearFlow.stress``."""
    waves = _wave_numbers(lattice, direction)
    published = stress_coefficients(waves.wavelength_over(roughness))
    a, b = (one if given is None else given for given, one in zip(stress, published, strict=True))
    complex_factor = waves.ahead * (a + 1j * b * np.sign(waves.along_wind))
    return complex_factor * waves.along_wind, complex_factor * waves.to_left


@lru_cache(_KEPT)
def _spread_factor(lattice: Lattice, direction: float, along: float, across: float) -> NDArray[np.float64]:
    """Amplitude of each wave after a Gaussian of a length (m) ``along`` the wind and a width ``across``."""
    waves = _wave_numbers(lattice, direction)
    return np.asarray(np.exp(-0.5 * ((along * waves.along_wind) ** 2 + (across * waves.to_left) ** 2)))


class LinearFlow:
    """The waves of a bed, or of any field, that a wind from ``direction`` (degrees) blows over.

    A wave h has wave number k, of which k_w is along the wind and k_l to its left.
    """

    def __init__(self, surface: NDArray, lattice: Lattice, direction: float) -> None:
        """Take the ``surface`` apart."""
        self.lattice, self.direction = lattice, direction
        self.numbers = _wave_numbers(lattice, direction)
        self.waves = waves_of(mirrored(np.asarray(surface, np.float64), lattice))

    def field(self, factor: NDArray) -> NDArray[np.float64]:
        """The sum over all waves, each times its ``factor``."""
        rows, columns = self.lattice.shape
        whole = sum_of_waves(factor * self.waves, (self.numbers.rows, self.numbers.columns))
        return whole[:rows, :columns]

    def slope(self, height: float) -> NDArray[np.float64]:
        """Rise over run of streamlines at a ``height`` (m): they follow waves by the share exp(-k height)."""
        line = self.field(_streamline_factor(self.lattice, self.direction, height))
        east, north = (_mean_step(line, axis, self.lattice.periodic) for axis in (1, 0))
        return (self.numbers.east * east + self.numbers.north * north) / self.lattice.cell_size

    def speedup(self, height: float) -> NDArray[np.float64]:
        """Relative speed gained without friction: (k_w² / k) h exp(-k height) (Lamb 1932)."""
        return self._over_mesh(self.numbers.along_wind, height)

    def crosswind(self, height: float) -> NDArray[np.float64]:
        """Relative speed gained to the left without friction: (k_w k_l / k) h exp(-k height)."""
        return self._over_mesh(self.numbers.to_left, height)

    def _over_mesh(self, component: NDArray[np.float64], height: float) -> NDArray[np.float64]:
        factor = self.numbers.ahead * component * _streamline_factor(self.lattice, self.direction, height)
        return over_mesh(self.field(factor), self.lattice.periodic)

    def stress(self, stress: Stress, roughness: float) -> NDArray[np.float64]:
        """Relative stress on the bed gained along the wind.

        It is (A + i B) (k_w² / k) h, for waves with k_w > 0. A is the rise on crests, B the rise on faces
        that look upwind, so that the stress is highest ahead of crests. Both depend on the wavelength over
        the ``roughness`` length (m; Fourrière et al. 2010), unless they are given.
        """
        return self.field(_stress_factors(self.lattice, self.direction, stress, roughness)[0])

    def crosswind_stress(self, stress: Stress, roughness: float) -> NDArray[np.float64]:
        """Relative stress on the bed gained to the left of the wind: (A + i B) (k_w k_l / k) h."""
        return self.field(_stress_factors(self.lattice, self.direction, stress, roughness)[1])

    def spread(self, along: float, across: float) -> NDArray[np.float64]:
        """The field smoothed by a Gaussian of a length (m) ``along`` the wind and a width ``across`` it."""
        return self.field(_spread_factor(self.lattice, self.direction, along, across))


def wind_over_relief(
    surface: NDArray,
    lattice: Lattice,
    direction: float,
    height: float | None,
    speedup: float,
    stress: Stress,
    roughness: float,
) -> ReliefWind:
    """A wind over the waves of a ``surface`` (m), beside one over a level bed.

    Its streamlines are those of a ``height`` (m), and level where not given. Its speed differs by ``speedup``
    times the difference without friction, the stress on the bed by A and B. All are bounded, for the theory
    is one of low waves.
    """
    drags = any(one is None or one > 0.0 for one in stress)
    if height is None and not drags:
        return ReliefWind()
    flow, fields = LinearFlow(surface, lattice, direction), {}
    if height is not None:
        fields["streamline_slope"] = partial(flow.slope, height)
        if speedup > 0.0:
            fields["speedup"] = partial(flow.speedup, height)
            fields["crosswind_ratio"] = partial(flow.crosswind, height)
    if drags:
        fields["stress"] = partial(flow.stress, stress, roughness)
        fields["crosswind_stress"] = partial(flow.crosswind_stress, stress, roughness)
    gained = several(list(fields.values()), lattice.cells)
    return _bounded(dict(zip(fields, gained, strict=True)), speedup)


def _bounded(gained: dict[str, NDArray[np.float64]], speedup: float) -> ReliefWind:
    """A wind by what it gains, by the names of its fields."""
    wind = ReliefWind(**gained)
    if wind.streamline_slope is not None:
        wind = wind._replace(streamline_slope=np.clip(wind.streamline_slope, -STEEPEST, STEEPEST))
    if wind.speedup is not None and wind.crosswind_ratio is not None:
        factor = np.clip(1.0 + speedup * wind.speedup, LEAST, MOST)
        ratio = np.clip(speedup * wind.crosswind_ratio, -STEEPEST, STEEPEST)
        wind = wind._replace(speedup=factor, crosswind_ratio=ratio)
    if wind.stress is not None and wind.crosswind_stress is not None:
        along = np.clip(1.0 + wind.stress, LEAST**2, MOST**2)
        wind = wind._replace(stress=along, crosswind_stress=np.clip(wind.crosswind_stress, -along, along))
    return wind


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
