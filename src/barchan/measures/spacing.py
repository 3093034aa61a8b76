"""How far bedforms stand apart."""

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.filters import Field, Periodic, smoothed, tapered, without_trend


def dominant_spacing(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
    width: float = 1.0,
) -> float:
    """Dominant distance (m) from one bedform to the next along the wind from ``direction`` (degrees).

    The inverse of the mean wavenumber along the wind, each wavenumber weighted with the square of its
    power: the wavelength itself for a train of waves, hardly moved by the harmonics of sharp crests, and
    steady where several wavelengths compete. A trend towards open edges is removed and the surface smoothed
    over ``width`` cells first; cells that are NaN are left out. NaN on a bed without relief along the wind.
    """
    surface = smoothed(without_trend(elevation, periodic), width, periodic)
    wavenumber, power = streamwise_spectrum(surface, cell_size, direction, periodic)
    weight = power**2
    if not weight.sum() > 0:
        return float("nan")
    return float(weight.sum() / (weight * wavenumber).sum())


def streamwise_spectrum(
    elevation: NDArray, cell_size: float, direction: float, periodic: Periodic = (True, True)
) -> tuple[Field, Field]:
    """Wavenumbers along the wind (cycles per metre) and the power of a surface at them.

    Power is summed over all waves with the same component along the wind, which for a wind along a
    lattice axis is the mean spectrum of the profiles along it; variation across the wind alone is left
    out.
    """
    field = tapered(np.asarray(elevation, float), periodic)
    power = np.abs(scipy.fft.fft2(field)) ** 2
    rows, cols = field.shape
    x, y = downwind(direction)
    along = np.abs(
        np.add.outer(scipy.fft.fftfreq(rows, cell_size) * y, scipy.fft.fftfreq(cols, cell_size) * x)
    ).ravel()
    step = 1.0 / (abs(x) * cols + abs(y) * rows) / cell_size
    place = np.rint(along / step).astype(np.int64)
    total = np.bincount(place, power.ravel()).astype(np.float64)
    moment = np.bincount(place, power.ravel() * along).astype(np.float64)
    rounding = 1e-24 * elevation.size * float(np.nansum(np.square(elevation, dtype=float)))
    filled = (np.arange(total.size) > 0) & (total > rounding)
    return moment[filled] / total[filled], total[filled]
