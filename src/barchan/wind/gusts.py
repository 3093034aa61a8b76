"""Gusts: a speed that varies about its mean, with a memory."""

import math
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.parameters import Parameters, parameter
from barchan.streams import Stream

MOST_SAMPLES = 32
"""Largest number of moments of an interval at which the speed is computed."""

_JUSTUS = -1.086
"""Exponent of the Weibull shape in the intensity (Justus et al. 1978, J. Appl. Meteorol. 17, 350-353)."""


class Gusts(Parameters):
    """How a wind's speed varies about its mean, in time.

    Independent normal numbers stand one correlation time apart; between two of them the number is their
    mean weighted by distance, scaled to a variance of 1. The distribution turns it into a factor of mean 1
    (``normal``: and not below 0) on the speed.
    """

    intensity: float = parameter(
        0.2,
        unit="-",
        ge=0,
        le=1,
        meaning="Standard deviation of the speed over its mean.",
        source="about 0.1 to 0.2 over open ground (Kaimal & Finnigan 1994)",
    )
    distribution: Literal["normal", "lognormal", "weibull"] = parameter(
        "normal", unit="-", meaning="How the speeds of gusts are distributed."
    )
    correlation_time: float = parameter(
        10.0,
        unit="s",
        gt=0,
        le=1e6,
        scale="log",
        meaning="Time after which gusts are independent of each other.",
    )

    def factors(self, start: float, duration: float, stream: Stream) -> NDArray[np.float64]:
        """Factors on the mean speed at moments (at most 32) spread evenly over a time (s)."""
        count = min(max(math.ceil(duration / self.correlation_time), 1), MOST_SAMPLES)
        moments = start + (np.arange(count, dtype=np.float64) + 0.5) * (duration / count)
        return self._factor(correlated(moments / self.correlation_time, stream))

    def _factor(self, number: NDArray[np.float64]) -> NDArray[np.float64]:
        if self.intensity == 0.0:
            return np.ones_like(number)
        if self.distribution == "normal":
            return np.maximum(1.0 + self.intensity * number, 0.0)
        if self.distribution == "lognormal":
            spread = math.sqrt(math.log1p(self.intensity**2))
            return np.exp(spread * number - spread**2 / 2)
        from scipy.special import ndtr

        shape = self.intensity**_JUSTUS
        scale = 1.0 / math.gamma(1.0 + 1.0 / shape)
        return scale * (-np.log(ndtr(-number))) ** (1.0 / shape)


def uniform(stream: Stream, number: int) -> float:
    """A number between 0 and 1, always the same under ``number``."""
    draw = int(stream.draws(number, 1)[0])
    return ((draw >> 11) + 0.5) * 2.0**-53


def normal(stream: Stream, number: int) -> float:
    """A normal number, always the same under ``number``."""
    from scipy.special import ndtri

    return float(ndtri(uniform(stream, number)))


def correlated(moments: NDArray[np.float64], stream: Stream) -> NDArray[np.float64]:
    """Normal numbers at moments, in correlation times: independent when more than one apart."""
    before = np.floor(moments).astype(np.int64)
    nodes = np.unique(np.concatenate([before, before + 1]))
    random = np.array([normal(stream, int(node)) for node in nodes])
    left, right = (random[np.searchsorted(nodes, before + k)] for k in (0, 1))
    near = moments - before
    mixed: NDArray[np.float64] = ((1 - near) * left + near * right) / np.hypot(1 - near, near)
    return mixed
