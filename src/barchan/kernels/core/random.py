"""Counter-based random numbers: every poll of every step starts a short sequence of its own.

There is no generator that has to be carried along. A key is derived from (seed, stream, step), a poll's
sequence from (key, poll), and a draw is one output of SplitMix64 (Steele, Lea & Flood 2014, OOPSLA,
doi:10.1145/2660193.2660195). So the numbers do not depend on how a run is cut into calls or threads.
"""

import numpy as np

from barchan.kernels.core.internal import internal

GOLDEN = np.uint64(0x9E3779B97F4A7C15)
"""SplitMix64's increment: the odd number nearest to 2**64 over the golden ratio."""

_FIRST = np.uint64(0xBF58476D1CE4E5B9)
_SECOND = np.uint64(0x94D049BB133111EB)
_HIGH = np.uint64(32)
_LOW = np.uint64(0xFFFFFFFF)
_FRACTION = 2.0**-53


@internal()
def mix(z: np.uint64) -> np.uint64:
    """SplitMix64's output function: a bijection of 64 bits that looks random."""
    z = (z ^ (z >> np.uint64(30))) * _FIRST
    z = (z ^ (z >> np.uint64(27))) * _SECOND
    return z ^ (z >> np.uint64(31))


@internal()
def derive(key: np.uint64, number: int) -> np.uint64:
    """The key, or the start of the sequence, that belongs to ``number`` under ``key``."""
    return mix(key + GOLDEN * np.uint64(number + 1))


@internal()
def high(draw: np.uint64) -> np.uint64:
    """The upper 32 bits of a draw."""
    return draw >> _HIGH


@internal()
def low(draw: np.uint64) -> np.uint64:
    """The lower 32 bits of a draw."""
    return draw & _LOW


@internal()
def below(half: np.uint64, count: int) -> np.int64:
    """A whole number in [0, count) from 32 random bits (multiply and shift, no division)."""
    return np.int64((half * np.uint64(count)) >> _HIGH)


@internal()
def shuffle(items: np.ndarray, count: int, key: np.uint64) -> None:
    """Put the first ``count`` items in a random order (Fisher and Yates), one draw a swap."""
    for last in range(count - 1, 0, -1):
        other = below(high(derive(key, last)), last + 1)
        items[last], items[other] = items[other], items[last]


@internal(error_model="numpy", forceinline=True)
def draw(start, number):
    """Draw ``number`` (from 1 on) of a sequence, from 0 to below 1."""
    return np.float64(mix(start + GOLDEN * np.uint64(number)) >> np.uint64(11)) * _FRACTION
