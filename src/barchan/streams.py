"""Named random streams: random numbers of one purpose never shift those of another."""

import hashlib
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

MASK = (1 << 64) - 1
GOLDEN = 0x9E3779B97F4A7C15
"""SplitMix64's increment, as in ``kernels.random``."""

STREAMS = {
    "ground": "uneven ground",
    "initial surface": "sand at the start",
    "sizes": "size class of each parcel at the start",
    "vegetation": "plants at the start",
    "transport": "polls, hops, flights and avalanches",
    "wind direction": "spread of a wind's direction",
    "gusts": "gusts of a wind's speed",
    "storms": "made-up storms",
    "wind record": "intervals taken from a recorded wind",
    "paths": "grains whose paths are drawn; they change nothing on the bed",
}
"""Streams of Barchan's own parts, each with its purpose; a model may add streams of its own."""


def mix(z: int) -> int:
    """SplitMix64's output function on a Python integer, equal to ``kernels.random.mix``."""
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


def derive(key: int, number: int) -> int:
    """The key that belongs to ``number`` under ``key``, equal to ``kernels.random.derive``."""
    return mix((key + GOLDEN * (number + 1)) & MASK)


@dataclass(frozen=True)
class Stream:
    """The random numbers of one purpose in one run: a key made of the run's seed and the stream's name."""

    seed: int
    name: str

    @cached_property
    def key(self) -> int:
        """The stream's 64-bit key."""
        digest = hashlib.sha256(self.name.encode()).digest()
        return derive(int.from_bytes(digest[:8], "little"), self.seed)

    def draws(self, number: int, count: int) -> NDArray[np.uint64]:
        """``count`` independent 64-bit draws under ``number`` (a step, a layer), always the same ones."""
        start = np.uint64(derive(self.key, number))
        z = start + np.uint64(GOLDEN) * np.arange(1, count + 1, dtype=np.uint64)
        z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        return z ^ (z >> np.uint64(31))


def below(half: NDArray[np.uint64], count: int) -> NDArray[np.int64]:
    """Whole numbers in [0, count) from 32 random bits each."""
    return ((half * np.uint64(count)) >> np.uint64(32)).astype(np.int64)


def high(draws: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """The upper 32 bits of each draw."""
    return draws >> np.uint64(32)


def low(draws: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """The lower 32 bits of each draw."""
    return draws & np.uint64(0xFFFFFFFF)
