"""How far bedforms stand apart."""

import numpy as np
from numpy.typing import NDArray
from scipy import fft, ndimage

from barchan.analysis.field import Field, Periodic, smoothed, tapered
from barchan.wind.segment import downwind


def dominant_spacing(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
    width: float = 1.0,
) -> float:
    """Dominant distance (m) from one bedform to the next along the wind from ``direction`` (degrees).

    It is the lag of the first maximum of the surface's autocorrelation along the wind, after smoothing
    over ``width`` cells. NaN where there is none: a flat bed, a single ridge that fills the field.
    """
    lags, correlation = autocorrelation_along(elevation, direction, periodic, width)
    falling = np.flatnonzero(np.diff(correlation) > 0)
    if falling.size == 0:
        return float("nan")
    trough = falling[0]
    peaks = (
        np.flatnonzero((correlation[1:-1] >= correlation[:-2]) & (correlation[1:-1] > correlation[2:])) + 1
    )
    peaks = peaks[peaks > trough]
    if peaks.size == 0:
        return float("nan")
    peak = int(peaks[np.argmax(correlation[peaks] > 0.5 * correlation[peaks].max())])
    return float((lags[peak] + _vertex(correlation[peak - 1 : peak + 2]) * (lags[1] - lags[0])) * cell_size)


def autocorrelation_along(
    elevation: NDArray, direction: float, periodic: Periodic, width: float
) -> tuple[Field, Field]:
    """Lags (cells) along the wind, up to half the field, and the autocorrelation there."""
    field = tapered(smoothed(elevation, width, periodic), periodic)
    shape = [n if p else 2 * n for n, p in zip(field.shape, periodic, strict=True)]
    spectrum = fft.rfft2(field, shape)
    correlation = fft.irfft2(np.abs(spectrum) ** 2, shape)
    x, y = downwind(direction)
    rows, cols = field.shape
    limits = [n / 2 / abs(s) for n, s in ((cols, x), (rows, y)) if abs(s) > 1e-9]
    lags = np.arange(0.0, min(limits), 0.5)
    along = ndimage.map_coordinates(correlation, [lags * y, lags * x], order=3, mode="grid-wrap")
    top = correlation[0, 0]
    return lags, along / top if top > 0 else np.zeros_like(along)


def _vertex(three: Field) -> float:
    """Where the parabola through three equally spaced values peaks, from the middle one."""
    left, middle, right = three
    curvature = left - 2 * middle + right
    return float(0.5 * (left - right) / curvature) if curvature < 0 else 0.0
