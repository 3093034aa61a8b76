"""What the kernel of slab models is told, as structs. Nothing here imports the compiler."""

from typing import NamedTuple

import numpy as np

CELL = 1 << 32
"""One cell in the fixed-point numbers that positions and hops are kept in."""


MOBILE = 1 << 20
"""A cell's mobility where the wind works unhindered."""


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


class AxisShadow(NamedTuple):
    """Shadow lines of a wind along a lattice axis."""

    falls: int
    """Address of how far the line has fallen: ``d`` cells downwind at index ``size - d``."""
    size: int
    shift: int
    """Binary places of a height below one slab."""
    reach: int
    """Cells, in 2**-16, that a line of one slab's height reaches downwind, rounded up."""
    width: int
    """Bytes of one height."""


class RayShadow(NamedTuple):
    """Shadow lines of an oblique wind; entry ``k`` is where the ray crosses the column ``k + 1`` upwind."""

    rows: int
    """Address of the row of the cell below the crossing, relative to the sheltered cell (int64)."""
    weights: int
    """Address of the share of the next row's cell in the height at the crossing (float64)."""
    falls: int
    """Address of how far the line has fallen from the crossing to the sheltered cell (float64)."""
    size: int
    width: int


class Path(NamedTuple):
    """What stops a slab on its way."""

    sand: bool
    """Whether sand that is too steep stops it too, or only ground."""
    limit: int
    """Step to a face neighbour that a slab passes, of the surface's type."""
    width: int
    """Bytes of one height."""
    clear: int = 0
    """Address of how many cells a slab may come over from each one before ground could stop it (uint8)."""
    clear_back: int = 0
    """The same against the wind, last cell first."""


BLOCK = 256
"""Polls prepared at a time: small enough to stay in the nearest cache."""


class Schedule(NamedTuple):
    """How the polls of a step are drawn."""

    each_once: bool
    """Poll each cell once a step, in random order, instead of drawing with replacement."""
    forced: bool
    """Look for another cell when the polled one cannot erode."""
    band_rows: int


class Polls(NamedTuple):
    """Work space: the polls at hand and what their order is drawn with."""

    rows: np.ndarray
    cols: np.ndarray
    states: np.ndarray
    """Where each poll's random sequence starts."""
    band_order: np.ndarray
    row_polls: np.ndarray
    """Polls that fall on each row."""
    permutation: np.ndarray
    """The cells of a band, shuffled."""


def work_space(rows: int, cols: int, schedule: Schedule) -> Polls:
    """Work space for a lattice of ``rows`` by ``cols`` cells."""
    bands = -(-rows // schedule.band_rows)
    band_cells = min(rows, schedule.band_rows) * cols if schedule.each_once else 1
    return Polls(
        np.zeros(BLOCK, np.int64),
        np.zeros(BLOCK, np.int64),
        np.zeros(BLOCK, np.uint64),
        np.zeros(bands, np.int64),
        np.zeros(rows, np.int64),
        np.zeros(band_cells, np.int32),
    )


MOVED, LEFT, CAPPED, TRAVEL_ALONG, TRAVEL_ACROSS, EXHAUSTED = range(6)
"""Places in a tally: slabs moved, slabs that left, slabs put down after ``max_hops``, distances
travelled on the wind, and steps cut short because no cell could erode."""

TALLY_SIZE = 6
