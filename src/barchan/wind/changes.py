"""A quantity of the weather that changes with time, constant over pieces of whole steps."""

import math
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

from barchan.wind.interval import FOR_EVER
from barchan.wind.ramps import Ramp

_MOMENTS = 64
"""Parts of a ramp whose changes are compared to find its steepest."""

_ROUNDING = 1e-9
"""Slack, in pieces, for times that are those of a piece's end but for rounding."""


@dataclass(frozen=True)
class Change:
    """A change from a first to a last value.

    It is made in pieces of equal numbers of whole steps, from one to the next of which the value changes by
    ``fineness`` or less (a piece lasts one step at least); each has the value in its middle. The pieces
    are counted from the change's own start, so that they do not depend on how a run is advanced.
    """

    first: float
    last: float
    ramp: Ramp
    fineness: float

    def value(self, over: float, duration: float) -> float:
        """The value after ``over`` of the ``duration`` (steps)."""
        if over >= duration:
            return self.last
        piece = self._piece(duration)
        start = piece * math.floor(over / piece + _ROUNDING)
        middle = (start + min(start + piece, duration)) / 2
        return self.first + (self.last - self.first) * self.ramp.share(middle / duration)

    def lasts(self, over: float, duration: float) -> int:
        """Number of steps, the first of them after ``over`` steps, that have one value in their middles."""
        middle = over + 0.5
        if middle >= duration:
            return FOR_EVER
        piece = self._piece(duration)
        end = min(piece * (math.floor(middle / piece + _ROUNDING) + 1), duration)
        return max(math.ceil(end - middle - _ROUNDING * piece), 1)

    def range(self) -> tuple[float, float]:
        """Least and greatest value."""
        values = [self.first + (self.last - self.first) * share for share in self.ramp.extremes()]
        return min(values), max(values)

    def _piece(self, duration: float) -> int:
        """Length of a piece (steps)."""
        shares = _shares(self.ramp)
        steepest = max(abs(b - a) for a, b in pairwise(shares)) * _MOMENTS
        change = steepest * abs(self.last - self.first)
        return max(math.floor(duration * self.fineness / change), 1) if change else math.ceil(duration)


@lru_cache(maxsize=64)
def _shares(ramp: Ramp) -> tuple[float, ...]:
    return tuple(ramp.share(k / _MOMENTS) for k in range(_MOMENTS + 1))
