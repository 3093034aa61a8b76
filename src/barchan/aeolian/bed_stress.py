"""Shear stress on a bed by linear theory, for slabs and snow."""

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.edges import ramped_to_mean
from barchan.aeolian.flow_over_relief import stress_coefficients
from barchan.aeolian.transforms import sum_of_waves, waves_of
from barchan.directions import downwind
from barchan.lattice import Lattice


def bed_stress(
    elevation: NDArray[np.float64],
    lattice: Lattice,
    direction: float,
    *,
    roughness: float,
    saturation_angle: float,
    smoothing: float,
) -> NDArray[np.float64]:
    """Shear stress over that on a flat bed, for a wind from ``direction`` (degrees).

    A wave of height h_k and wave number k (rad/m) that runs at an angle a to the wind changes it by
    k (A + i B) cos² a h_k, A and B functions of the wavelength over the ``roughness`` length (m; Fourrière et
    al. 2010). On windward slopes steeper than ``saturation_angle`` (degrees) the change is reduced in
    proportion. The surface is smoothed over ``smoothing`` cells first; over open edges it is continued to its
    mean.
    """
    surface, inside = ramped_to_mean(elevation, lattice)
    response, slope = _response(surface.shape, lattice.cell_size, direction, roughness, smoothing)
    waves = waves_of(surface)
    change = sum_of_waves(waves * response, surface.shape)[inside]
    rise = sum_of_waves(waves * slope, surface.shape)[inside]
    steepest = math.tan(math.radians(saturation_angle))
    stress: NDArray[np.float64] = 1.0 + change * steepest / np.maximum(rise, steepest)
    return np.maximum(stress, 0.0, out=stress)


@lru_cache(maxsize=16)
def _response(
    shape: tuple[int, int], cell_size: float, direction: float, roughness: float, smoothing: float
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Factors from a surface's spectrum (m) to those of the stress's change and of the streamwise slope."""
    ky = 2 * np.pi * np.fft.fftfreq(shape[0], cell_size)[:, None]
    kx = 2 * np.pi * np.fft.rfftfreq(shape[1], cell_size)[None, :]
    x, y = downwind(direction)
    along = kx * x + ky * y
    k = np.hypot(kx, ky)
    k[0, 0] = 1.0
    a, b = stress_coefficients(2 * np.pi / (k * roughness))
    smooth = np.exp(-0.5 * (k * smoothing * cell_size) ** 2)
    shortest = 0.999999 * np.pi / cell_size
    smooth = smooth * (np.abs(kx) < shortest) * (np.abs(ky) < shortest)
    response = k * (a + 1j * b * np.sign(along)) * (along / k) ** 2 * smooth
    response[0, 0] = 0.0
    return response, 1j * along * smooth
