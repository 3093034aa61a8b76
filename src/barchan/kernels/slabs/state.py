"""The rules, the schedule and the work space of the slab kernel. Nothing here imports the compiler."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.bed.state import Grid, Repose, Unstable
from barchan.kernels.slabs.shadow_lines import AxisShadow, BoxShadow, RayShadow

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
    """The same across the columns' axis."""
    unit_along: float
    """A hop of one cell in 1/``CELL`` cells."""
    unit_across: float
    deposit_on_sand: np.uint64
    """Chance that a slab that lands on sand is deposited, in 2**-32."""
    deposit_on_ground: np.uint64
    """The same on bare ground."""
    erosion_factor: int
    """Chance of erosion that a whole ``MOBILE`` adds, in 2**-32; used only where cells have a mobility."""
    erosion_offset: int
    """Chance of erosion of a cell without mobility, in 2**-32."""
    max_hops: int
    """Hops after which a slab is put down wherever it is."""


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
    deviation_weight: float
    """Part of the summed deviation by which the reference lies below the mean."""
    whole: bool
    """Whether hops are rounded to whole cells."""
    every_hop: bool
    """Whether each hop of a flight is measured where it starts, or all where the flight does."""


class ObstacleRule(NamedTuple):
    """Which steps stop a slab in flight."""

    sand: bool
    """Whether sand that is too steep stops it too, or only ground."""
    limit: int
    """Largest step to a face neighbour that a slab passes, of the surface's type."""
    width: int
    """Bytes of one height."""
    clear: int = 0
    """Address of each cell's clear distance: cells that a slab may pass before ground can stop it (uint8)."""
    clear_back: int = 0
    """The same against the wind, last cell first."""


class SlabRules(NamedTuple):
    """The rules of a slab model under one wind; what a model does without is None."""

    grid: Grid
    wind: Wind
    speedup: Speedup | None
    """How hops depend on height; None: all hops are alike."""
    obstacles: ObstacleRule | None
    """None: a slab passes over everything."""
    repose: Repose
    axis: AxisShadow | None
    """Shadow lines of a wind along a lattice axis; one of ``axis`` and ``ray`` is None."""
    ray: RayShadow | None
    box: BoxShadow | None
    """Shadow lines from a slab's own place, in place of those of ``axis`` or ``ray``."""
    orders: NDArray[np.int64]
    """Neighbour orders for slabs that slide: rows ``DOWNSLOPE``, ``UPSLOPE`` and ``SHUFFLED`` (scratch)."""
    relaxation_orders: NDArray[np.int64]
    """Neighbour orders of avalanches that go on until every slope stands."""
    interruption: NDArray[np.int64]
    """One number, looked at from time to time: other than 0, the work is to be broken off."""


BLOCK = 256
"""Polls prepared at a time: small enough to stay in the nearest cache."""


class Schedule(NamedTuple):
    """How the polls of a step are drawn."""

    each_once: bool
    """Poll each cell once a step, in random order, instead of drawing with replacement."""
    forced: bool
    """Look for another cell when the polled one cannot erode."""
    band_rows: int


class Rows(NamedTuple):
    """Some rows of the lattice, counted from the first one on, round its edge."""

    first: int
    number: int


class Band(NamedTuple):
    """A band of rows."""

    number: int
    first_row: int
    rows: int
    near: Rows
    """The rows that an oblique wind works on at once: slabs that hop farther land when the round ends."""
    touched: Rows
    """The rows that its polls may touch."""


class View(NamedTuple):
    """The heights of the surface as the polls of a band see them."""

    now: int
    """Address of the surface."""
    before: int
    """Address of the surface as it was when the round began."""
    near: Rows
    """Rows of the band and about it. A shadow line of an oblique wind meets them as they are now, and the
    others as they were."""


class Flights(NamedTuple):
    """Slabs that hop farther than the near rows of their bands, in the order of the polls of each band."""

    slabs: NDArray[np.int64]
    """The next slab of the band (``NO_SLAB``: none), position, hop, random state and number of hops."""
    first: NDArray[np.int64]
    """The first slab of each band."""
    last: NDArray[np.int64]
    used: NDArray[np.int64]


NO_SLAB = -1


class Round(NamedTuple):
    """A part of a step: some polls of every band, or of every cell in random order."""

    number: int
    start: int
    """Polls before the first one: of the step, or of a shuffled round through the lattice."""
    stop: int
    key: np.uint64
    """Key of the order of bands and cells."""
    poll_key: np.uint64
    """Key of the polls' own random sequences."""
    target: int
    """The round ends once the tally has this many moved slabs; -1: never."""


class Polls(NamedTuple):
    """Work space: the prepared polls, and the orders in which they are drawn."""

    rows: NDArray[np.int64]
    cols: NDArray[np.int64]
    states: NDArray[np.uint64]
    """Where each poll's random sequence starts."""
    band_order: NDArray[np.int64]
    row_polls: NDArray[np.int64]
    """Polls that fall on each row."""
    permutation: NDArray[np.int32]
    """The cells of a band, shuffled."""


class EdgeInflux(NamedTuple):
    """Mean number of slabs that enter in a step at each cell of the upwind edges, in the wind's frame."""

    along: NDArray[np.float64]
    """Across the edge where columns begin, by row; empty where that is joined to the other end."""
    across: NDArray[np.float64]
    """Across the edge where rows begin (end, if the wind blows towards lower rows), by column; or empty."""


class Work(NamedTuple):
    """Work space of the slab kernel."""

    polls: Polls
    unstable: Unstable | None
    """For avalanches that go on until every slope stands; None: sand at rest slides at the repose angle."""
    before: NDArray[np.integer] | None = None
    """The surface when the round began; None along an axis, where the wind keeps to its row."""
    flights: Flights | None = None
    """None along an axis."""


def prepared_polls(rows: int, cols: int, schedule: Schedule) -> Polls:
    """Room for prepared polls on a lattice of ``rows`` by ``cols`` cells."""
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


STRAYED, FULL = -1, -2
"""In place of a height: a walk left the rows that its band may touch; a slab in flight found no room."""

MOVED, LEFT, CAPPED, TRAVEL_ALONG, TRAVEL_ACROSS, EXHAUSTED, ENTERED = range(7)
"""Places in a tally: slabs moved, slabs that left, slabs put down after ``max_hops``, distances
travelled on the wind, steps cut short because no cell could erode, and slabs that entered."""

TALLY_SIZE = 7
