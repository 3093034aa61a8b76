"""The lattice and its slopes as kernels see them, told by numbers. Nothing here imports the compiler."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Grid(NamedTuple):
    """The lattice as a kernel sees it, in the wind's frame."""

    rows: int
    cols: int
    wrap_along: bool
    """Whether leaving downwind means entering upwind (periodic along the wind)."""
    wrap_across: bool


LEVEL_BITS = 20
"""Binary places of the heights (slabs) that hops are measured against."""


MEAN, DEVIATION = range(2)
"""Places in the levels: the surface's mean, and the sum over all cells of their distance from it."""


class ActiveLayer(NamedTuple):
    """Sand of several sizes: parcels by size class and cell, in the active layer and in the substrate."""

    surface: np.ndarray
    """Parcels in the active layer (int32, size class by cell)."""
    substrate: np.ndarray
    """Parcels below the active layer."""
    capacity: int
    """Parcels that the active layer of a cell holds."""
    rng_state: np.ndarray
    """State of the sequence of random numbers (one uint64)."""


EAST, NORTH, WEST, SOUTH, NORTHEAST, NORTHWEST, SOUTHWEST, SOUTHEAST = range(8)
"""Neighbours in the wind's frame, as seen with the wind blowing east."""


STABLE = -1
"""The way from a cell whose slopes all hold."""


CLOSED = -(1 << 62)
"""The code of a way that sand may not take: it sorts below every other."""


SLIDE, FEED, DRAWN = range(3)
"""Rows of a table of turns: whither a slab slides, whence one falls in, and a drawn sequence of either."""


class Repose(NamedTuple):
    """Which slopes hold; heights in the surface's units."""

    slab: int
    face_limit: int
    """Largest stable step to one of the four neighbours that share a face."""
    corner_limit: int
    corner_weight: float
    """What a step to a corner neighbour counts when the steepest one is sought (a face counts 1)."""
    corners: bool
    """Whether the four corner neighbours count at all (Moore) or not (von Neumann)."""
    random_order: bool
    """Whether neighbours are checked in a sequence drawn anew each time."""
    firm_face_limit: int
    """The same limits where plants hold the sand."""
    firm_corner_limit: int
    firm_below: int
    """Mobility up to which a cell is firm."""
    release_face: int
    """How far a step at rest may exceed its limit before it lets go."""
    release_corner: int


def turn_code(direction: int, place: int) -> int:
    """The code of the neighbour that is checked at ``place`` (0 to 7): earlier ones sort higher."""
    return (7 - place) << 3 | direction


def settling_sequences(corners: bool) -> NDArray[np.int64]:
    """Eight orders of neighbours: from each of four directions, one way round and the other."""
    sequences = np.full((8, 8), CLOSED, np.int64)
    for sequence in range(8):
        for place in range(4):
            way = (sequence + (place if sequence < 4 else -place)) % 4
            sequences[sequence, way] = turn_code(way, place)
            if corners:
                sequences[sequence, 4 + way] = turn_code(4 + way, 4 + place)
    return sequences
