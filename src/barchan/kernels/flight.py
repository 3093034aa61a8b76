"""A slab on the wind: how far it hops, where it comes down, and what stands in its way.

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


class Path(NamedTuple):
    """What stops a slab on its way."""

    sand: bool
    """Whether sand that is too steep stops it too, or only ground."""


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


@njit(cache=True)
def _stands_in_the_way(surface, sand, cell, other, limit, slab, path):
    """Whether what a slab over ``cell`` comes upon next is too high to pass."""
    top = np.int64(surface[other])
    if not path.sand:
        top = np.int64(0)
        if sand is not None:
            top = np.int64(surface[other]) - np.int64(sand[other]) * slab
    return top - np.int64(surface[cell]) > limit


@njit(cache=True)
def fly(surface, sand, along, across, hop_along, hop_across, grid, repose, path):
    """One hop, cell by cell, as far as nothing stands in its way (seed 000, Alg. 7).

    Returns the new position (negative where the slab has left), the distance flown, and whether the slab
    was stopped.
    """
    pieces = (max(abs(hop_along), abs(hop_across)) + CELL - 1) >> 32
    a = along
    c = across
    flown_along = np.int64(0)
    flown_across = np.int64(0)
    for piece in range(1, pieces + 1):
        next_along = hop_along if piece == pieces else hop_along // pieces * piece
        next_across = hop_across if piece == pieces else hop_across // pieces * piece
        next_a = wrapped(along + next_along, grid.cols, grid.wrap_along)
        next_c = wrapped(across + next_across, grid.rows, grid.wrap_across)
        if next_a < 0 or next_c < 0:
            return np.int64(-1), np.int64(-1), hop_along, hop_across, False
        cell = (c >> 32) * grid.cols + (a >> 32)
        other = (next_c >> 32) * grid.cols + (next_a >> 32)
        corner = c >> 32 != next_c >> 32 and a >> 32 != next_a >> 32
        limit = repose.corner_limit if corner else repose.face_limit
        if cell != other and _stands_in_the_way(surface, sand, cell, other, limit, repose.slab, path):
            return a, c, flown_along, flown_across, True
        a = next_a
        c = next_c
        flown_along = next_along
        flown_across = next_across
    return a, c, flown_along, flown_across, False
