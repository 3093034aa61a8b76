"""Fits of laws to measured values, with confidence intervals."""

import warnings
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.measures.filters import Field

FEWEST = 4
"""Values from which on a law is fitted."""


@dataclass(frozen=True)
class Fitted:
    """A fitted number and the interval that holds it with a confidence of 95 %."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        return f"{self.value:.3g} ({self.low:.3g} to {self.high:.3g})"


NOT_FITTED = Fitted(float("nan"), float("nan"), float("nan"))


@dataclass(frozen=True)
class PowerLaw:
    """y = factor · x^exponent."""

    factor: float
    exponent: Fitted
    scatter: float
    """Standard deviation of ln y about the law."""
    count: float
    """Values that count as independent."""


NO_POWER_LAW = PowerLaw(float("nan"), NOT_FITTED, float("nan"), 0.0)


def power_law(x: NDArray, y: NDArray, in_order: bool = False) -> PowerLaw:
    """The power law through values above 0, by least squares of their logarithms.

    Values ``in_order`` of time follow each other closely: they count as n (1 - r) / (1 + r) independent ones,
    r the correlation of neighbouring residuals (Bartlett 1935). Pairs with a NaN or a value that is not above
    0 are left out. NaN where there are fewer than 4 (independent) values, or all x are the same.
    """
    return _fitted_power_law(*_positive(x, y), in_order)


def _positive(x: NDArray, y: NDArray) -> tuple[Field, Field]:
    one, other = np.asarray(x, float), np.asarray(y, float)
    used = np.isfinite(one) & np.isfinite(other) & (one > 0) & (other > 0)
    return np.log(one[used]), np.log(other[used])


def _fitted_power_law(x: Field, y: Field, in_order: bool) -> PowerLaw:
    if len(x) < FEWEST or np.ptp(x) <= 1e-12:
        return NO_POWER_LAW
    about = x - x.mean()
    exponent = float((about * y).sum() / (about**2).sum())
    rest = y - y.mean() - exponent * about
    count = _independent(rest) if in_order else float(len(x))
    factor = float(np.exp(y.mean() - exponent * x.mean()))
    if count < FEWEST:
        return PowerLaw(factor, Fitted(exponent, float("nan"), float("nan")), float(rest.std()), count)
    scatter = float(np.sqrt((rest**2).mean() * count / (count - 2)))
    error = scatter / float(np.sqrt((about**2).mean() * count)) * _student(count - 2)
    return PowerLaw(factor, Fitted(exponent, exponent - error, exponent + error), scatter, count)


def _independent(rest: Field) -> float:
    """How many independent values residuals in order are worth."""
    power = float((rest**2).sum())
    r = float((rest[1:] * rest[:-1]).sum()) / power if power > 1e-24 * len(rest) else 0.0
    return len(rest) * (1 - max(r, 0.0)) / (1 + max(r, 0.0))


@dataclass(frozen=True)
class SpeedSizeLaw:
    """c = flux / (height + offset): what carries a dune's sand over its crest moves it."""

    flux: Fitted
    """Flux over crests: m² per unit of the speed's time."""
    offset: Fitted
    """Height (m) that dunes seem to have more, by the growth of the flux towards their crests."""


def speed_size(heights: NDArray, speeds: NDArray) -> SpeedSizeLaw:
    """The law between the heights (m) of dunes and their speeds, by least squares of logarithms.

    Bagnold's c = q / H with the offset that dunes measured in the field show (Andreotti, Claudin and Douady
    2002). Intervals follow from the covariance of the fit. NaN where there are fewer than 4 dunes, where all
    are as high, or where higher dunes are not slower.
    """
    from scipy.optimize import OptimizeWarning, curve_fit

    used = np.isfinite(heights) & np.isfinite(speeds) & (np.asarray(heights) > 0) & (np.asarray(speeds) > 0)
    h, c = np.asarray(heights, float)[used], np.asarray(speeds, float)[used]
    if len(h) < FEWEST or np.ptp(h) <= 1e-12:
        return SpeedSizeLaw(NOT_FITTED, NOT_FITTED)
    slope, level = np.polyfit(h, 1.0 / c, 1, w=c)  # 1/c is linear in h: a start for the fit
    if not slope > 0:
        return SpeedSizeLaw(NOT_FITTED, NOT_FITTED)
    with warnings.catch_warnings():
        warnings.simplefilter("error", OptimizeWarning)
        try:
            start = 1 / slope, max(level / slope, -0.9 * h.min())
            best, covariance = curve_fit(_log_speed, h, np.log(c), start)
        except (RuntimeError, OptimizeWarning):
            return SpeedSizeLaw(NOT_FITTED, NOT_FITTED)
    errors = np.sqrt(np.diag(covariance)) * _student(len(h) - 2)
    flux, offset = (Fitted(float(v), float(v - e), float(v + e)) for v, e in zip(best, errors, strict=True))
    return SpeedSizeLaw(flux, offset)


def _log_speed(height: Field, flux: float, offset: float) -> Field:
    return np.asarray(np.log(np.maximum(flux, 1e-300) / np.maximum(height + offset, 1e-300)))


def _student(freedom: float) -> float:
    """Standard errors on either side that hold 95 % of Student's distribution, by its degrees of freedom."""
    from scipy import stats  # takes most of a second to load

    return float(stats.t.ppf(0.975, freedom))
