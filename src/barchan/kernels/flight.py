"""A slab on the wind: how far it hops and where it comes down.

Positions and hops are fixed-point numbers in the wind's frame, along and across the columns' axis.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

CELL = 1 << 32
"""One cell in the fixed-point numbers that positions and hops are kept in."""

LEVEL_BITS = 20
"""Binary places of the heights (slabs) that hops are measured against."""

MOBILE = 1 << 20
"""A cell's mobility where the wind works unhindered."""

MEAN, DEVIATION = range(2)
"""Places in the levels: the surface's mean, and the sum over all cells of their distance from it."""


class Wind(NamedTuple):
    """How the wind takes, carries and drops a slab."""

    lee_erosion: bool
    """Whether a cell in shadow may give a slab."""
    hop_along: int
    """One hop in 1/``CELL`` cells."""
    hop_across: int
    unit_along: float
    """A hop of one cell in 1/``CELL`` cells."""
    unit_across: float
    settle_on_sand: np.uint64
    """Chance of settling where there is sand, in 2**-32."""
    settle_on_ground: np.uint64
    give_share: int
    """Chance of giving a slab that a whole ``MOBILE`` adds, in 2**-32."""
    give_shift: int
    """Chance of giving a slab where the mobility is none, in 2**-32."""
    max_hops: int


class Speedup(NamedTuple):
    """How hops grow with height above a reference (Momiji et al. 2000; Bishop et al. 2002)."""

    linear: float
    """Cells a slab of height."""
    quadratic: float
    """Cells a slab squared, above the reference."""
    base: float
    """Hop (cells) at the reference."""
    longest: float
    slabs: float
    """Slabs in one unit of the surface."""
    shift: int
    """Binary places from units of the surface to those of the levels."""
    share: float
    """What of the deviation is taken off the mean to give the reference."""
    whole: bool
    """Whether hops are rounded to whole cells."""
    every_hop: bool
    """Whether each hop of a flight is measured where it starts, or all where the flight does."""


@njit(cache=True, forceinline=True)
def wrapped(place, size, wrap):
    """A fixed-point position brought back into the field, or -1 where it has left."""
    length = size << 32
    while place >= length:
        if not wrap:
            return -1
        place -= length
    while place < 0:
        if not wrap:
            return -1
        place += length
    return place


@njit(cache=True)
def measure_levels(surface, levels, speedup):
    """Take the levels anew from the whole surface."""
    total = np.int64(0)
    for cell in range(surface.size):
        total += np.int64(surface[cell])
    levels[MEAN] = (total << speedup.shift) // surface.size
    levels[DEVIATION] = 0
    for cell in range(surface.size):
        levels[DEVIATION] += abs((np.int64(surface[cell]) << speedup.shift) - levels[MEAN])


@njit(cache=True, forceinline=True)
def move_level(levels, before, after, speedup):
    """Follow one cell from one height to another."""
    mean = levels[MEAN]
    levels[DEVIATION] += abs((after << speedup.shift) - mean) - abs((before << speedup.shift) - mean)


@njit(cache=True, forceinline=True)
def hop_cells(height, levels, speedup):
    """Hop (cells, negative: against the wind) from a cell of this height."""
    reference = np.float64(levels[MEAN]) - speedup.share * np.float64(levels[DEVIATION])
    rise = np.float64(height) * speedup.slabs - reference * (1.0 / (1 << LEVEL_BITS))
    hop = speedup.base + speedup.linear * rise
    if rise > 0.0:
        hop += speedup.quadratic * rise * rise
    hop = min(max(hop, -speedup.longest), speedup.longest)
    return np.floor(hop + 0.5) if speedup.whole else hop


@njit(cache=True, forceinline=True)
def fixed_hop(hop, unit):
    """A hop's part along an axis in 1/``CELL`` cells."""
    return np.int64(np.rint(hop * unit))
