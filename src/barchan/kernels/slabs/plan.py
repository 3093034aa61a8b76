"""The division of rounds of polls among threads, band by band. Nothing here imports the compiler."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.core.state import LINE
from barchan.kernels.slabs.state import Round, Schedule

BROKEN_OFF, RUNNING = 0, LINE
"""Places in ``Plan.signals``: why the work was broken off (``STRAYED``, ``FULL``), and threads at work."""


class Plan(NamedTuple):
    """Rounds of polls, and how far each band has got with them.

    Bands that lie farther apart than ``distance`` bands touch no common row. So a band waits only for those
    within that distance: for all of them in the round before, and in this round for those that come first in
    the random order of bands. Whoever runs the bands, and when, the bed is the one that one thread makes that
    runs them in order.
    """

    rounds: NDArray[np.int64]
    """Number, first and last poll of each round, by row."""
    keys: NDArray[np.uint64]
    """The key of the orders and that of the polls of each round, by row."""
    places: NDArray[np.int64]
    """Each band's place in the order of each round (round by band)."""
    first: NDArray[np.int64]
    """First poll of each band in each round."""
    polls: NDArray[np.int64]
    """Polls of each band in each round."""
    taken: NDArray[np.int64]
    """Rounds that each band has begun; the last number is of rounds whose polls were counted."""
    done: NDArray[np.int64]
    """Rounds that each band has ended, likewise."""
    peaks: NDArray[np.int64]
    """A height that no cell of each band exceeds."""
    signals: NDArray[np.int64]
    distance: int
    near: int
    """Rows beyond its own on which an oblique wind works at once."""
    reach: int
    """Rows beyond its own that a band may touch."""
    begins: int
    """How many times a round is begun or, for slabs that hop far to land, the last one ended."""
    in_step: bool
    """Whether a round begins only when the one before has ended."""
    measures: bool
    """Whether the heights that hops depend on are measured at each round, and not at the first one alone."""


def plan_rounds(
    rounds: Sequence[Round],
    bands: int,
    peak: int,
    bounds: tuple[int, int, int],
    *,
    lands: bool,
    measures: bool,
) -> Plan:
    """A plan with nothing done yet.

    No cell exceeds the height ``peak``; ``bounds`` are distance, near and reach. Slabs that hop far land
    at the end of a round if it ``lands`` them.
    """
    return Plan(
        np.array([(r.number, r.start, r.stop) for r in rounds], np.int64).reshape(-1, 3),
        np.array([(r.key, r.poll_key) for r in rounds], np.uint64).reshape(-1, 2),
        np.zeros((len(rounds), bands), np.int64),
        np.zeros((len(rounds), bands), np.int64),
        np.zeros((len(rounds), bands), np.int64),
        np.zeros(bands + 1, np.int64),
        np.zeros(bands + 1, np.int64),
        np.full(bands, peak, np.int64),
        np.zeros(2 * LINE, np.int64),
        *bounds,
        len(rounds) + lands,
        lands or measures,
        measures,
    )


def near_of(schedule: Schedule) -> int:
    """Rows beyond its own on which an oblique wind works at once: half of those that it may touch."""
    return (schedule.band_rows - 1) // 4


def reach_of(distance: int, rows: int, schedule: Schedule, periodic: bool) -> int:
    """Rows beyond its own that a band may touch if bands ``distance`` apart or less wait for each other.

    Two bands that do not wait have at least ``distance`` bands between them, of which the last one of the
    lattice may have fewer rows. What one changes the other must not read, and it reads a row beyond.
    """
    last = rows % schedule.band_rows
    between = distance * schedule.band_rows
    if last and periodic:
        between += last - schedule.band_rows
    return max((between - 1) // 2, 0)
