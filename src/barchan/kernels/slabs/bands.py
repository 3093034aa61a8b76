"""Transport over a bed of any kind (``beds``): the polls of a round, band by band, in any number of threads.

The bands of a round have a random order. Polls of a band touch few rows beyond its own, so bands that lie
farther apart may be run at the same time, and a band need not wait for all of the round before: ``Plan`` says
which it waits for. Every order that it allows gives the bed of one thread that runs all in order, to the bit.
"""

from numba import njit

from barchan.kernels.core.atomics import add, give_way, load, store, swap
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal, woven
from barchan.kernels.core.random import derive
from barchan.kernels.core.work_queue import wait_a_moment
from barchan.kernels.slabs.beds import lattice_rules, measure_bed, poll_bed
from barchan.kernels.slabs.flights import forget_flights
from barchan.kernels.slabs.late_landing import land_flights
from barchan.kernels.slabs.plan import BROKEN_OFF, RUNNING
from barchan.kernels.slabs.polling import (
    band_of,
    count_polls_by_row,
    draw_cells,
    polls_in_band,
    shuffle_bands,
    shuffle_cells,
    take_cells,
)
from barchan.kernels.slabs.state import BLOCK, EXHAUSTED, FULL, MOVED, STRAYED, Round

_NOTHING, _LATER = -1, -2
"""In place of a band: none is left, and all that are left wait for others."""

_AHEAD = 3
"""Rounds whose polls are counted before the slowest band begins them."""


@woven()
def run_band(bed, rules, work, schedule, part, band, first, count, peak, tally):
    """Run a band's polls of a round, from poll ``first`` on; returns a height that no cell exceeds now.

    Drawn with replacement it is ``count`` of the polls ``start`` to ``stop`` of a step. Otherwise the cells
    ``start`` to ``stop`` of a shuffled round through the lattice are polled, to which every band gives the
    same share of its own cells, so that a part of a round is spread over the field.
    """
    shared, polls = lattice_rules(rules), work.polls
    cols = shared.grid.cols
    exhausted = tally[EXHAUSTED]
    redraw = schedule.forced and not schedule.each_once
    at, end = 0, count
    if schedule.each_once:
        cells, size = shared.grid.rows * cols, band.rows * cols
        shuffle_cells(polls, size, derive(part.key, 1 + band.number))
        at = part.start * size // cells
        end = part.stop * size // cells
        first = part.number * cells + band.first_row * cols + at
    while at < end:
        n = min(BLOCK, end - at)
        if schedule.each_once:
            take_cells(polls, first, at, n, band.first_row, cols, part.poll_key)
        else:
            draw_cells(polls, first, n, band, cols, part.poll_key)
        peak = poll_bed(bed, rules, work, band, n, redraw, part.target, peak, tally)
        if peak < 0 or tally[MOVED] == part.target or tally[EXHAUSTED] > exhausted:
            return peak
        if shared.interruption[0] != 0:
            return peak
        first += n
        at += n
    return peak


@internal()
def _remember(before, surface):
    """Keep the surface as it is when a round begins (None: nobody asks for it)."""
    if before is not None:
        for cell in range(surface.size):  # of a slice the compiler would make the text of an error too
            before[cell] = surface[cell]


@internal()
def _end_round(flights, bed, rules, work, plan, number, tally):
    """Land the slabs that hopped far in a round (None: none does)."""
    never_inline()
    if flights is None:
        return
    order = work.polls.band_order
    for band in range(order.size):
        order[plan.places[number, band]] = band
    peak = land_flights(flights, bed, rules, work, order, plan.peaks.max(), tally)
    plan.peaks[:] = peak


@internal()
def _begin_round(bed, work, schedule, plan, number):
    """Draw the order of the bands in a round, and how many polls each of them gets."""
    never_inline()
    polls = work.polls
    forget_flights(work.flights)
    _remember(work.before, bed.surface)
    if plan.measures or number == 0:
        measure_bed(bed)
    key = plan.keys[number, 0]
    start, stop = plan.rounds[number, 1], plan.rounds[number, 2]
    if not schedule.each_once:
        count_polls_by_row(polls, start, stop - start, derive(key, 1))
    shuffle_bands(polls.band_order, derive(key, 0 if schedule.each_once else 2))
    rows = polls.row_polls.size
    first = start
    for place in range(polls.band_order.size):
        band = polls.band_order[place]
        count = polls_in_band(polls, band_of(band, rows, schedule, 0, 0))
        plan.places[number, band] = place
        plan.first[number, band] = first
        plan.polls[number, band] = count
        first += count


@internal()
def _waits(plan, band, number, wrap):
    """Whether a band must wait for another one before it begins a round."""
    bands = plan.peaks.size
    place = plan.places[number, band]
    for step in range(-plan.distance, plan.distance + 1):
        other = band + step
        if wrap:
            other %= bands
        if 0 <= other < bands and other != band:
            comes_first = plan.places[number, other] < place
            if load(plan.done, other) < number + (1 if comes_first else 0):
                return True
    return False


@internal()
def _round_to_begin(plan, slowest):
    """Whether the polls of one more round are to be counted now: not far ahead of the slowest band."""
    bands = plan.peaks.size
    counted = load(plan.done, bands)
    ahead = 0 if plan.in_step else _AHEAD
    if load(plan.taken, bands) != counted:
        return False
    return counted < plan.begins and counted <= slowest + ahead


@internal()
def _next_band(plan, wrap):
    """The band to run next, of those that need not wait: of the earliest round, the first in its order.

    Returns the band and its round; after the last band comes the count of polls of a round. A band that
    another thread may be about to take is offered too.
    """
    bands, last = plan.peaks.size, plan.rounds.shape[0]
    counted = load(plan.done, bands)
    found, found_round, found_place = _LATER, last, bands
    slowest, left = last, load(plan.taken, bands) < plan.begins
    for band in range(bands):
        number = load(plan.done, band)
        slowest = min(slowest, number)
        begun = load(plan.taken, band)
        left |= begun < last
        if begun == number and number < min(counted, last) and number <= found_round:
            place = plan.places[number, band]
            if (number < found_round or place < found_place) and not _waits(plan, band, number, wrap):
                found, found_round, found_place = band, number, place
    if not left:
        return _NOTHING, last
    if _round_to_begin(plan, slowest):
        return bands, counted
    return found, found_round


@internal()
def _peak_about(plan, band, wrap):
    """A height that no cell of a band exceeds, nor any that its neighbours may have raised."""
    bands = plan.peaks.size
    peak = plan.peaks[band]
    for step in range(-plan.distance, plan.distance + 1):
        other = band + step
        if wrap:
            other %= bands
        if 0 <= other < bands:
            peak = max(peak, plan.peaks[other])
    return peak


@woven()
def _run(bed, rules, work, schedule, plan, band, number, tally):
    """Run a band's polls of a round; or end the round before, and count the polls of the next one."""
    if band == plan.peaks.size:
        if number > 0:
            _end_round(work.flights, bed, rules, work, plan, number - 1, tally)
        if number < plan.rounds.shape[0]:
            _begin_round(bed, work, schedule, plan, number)
        return
    part = Round(
        plan.rounds[number, 0],
        plan.rounds[number, 1],
        plan.rounds[number, 2],
        plan.keys[number, 0],
        plan.keys[number, 1],
        -1,
    )
    grid = lattice_rules(rules).grid
    rows = band_of(band, grid.rows, schedule, plan.near, plan.reach)
    first, count = plan.first[number, band], plan.polls[number, band]
    peak = _peak_about(plan, band, grid.wrap_across)
    peak = run_band(bed, rules, work, schedule, part, rows, first, count, peak, tally)
    if peak in (STRAYED, FULL):
        store(plan.signals, BROKEN_OFF, peak)
    plan.peaks[band] = peak


@njit(cache=True, nogil=True)
def run_rounds(bed, rules, work, schedule, plan, tally):
    """Run bands of a plan's rounds until none is left to begin, beside other threads that do the same.

    The bed is changed in place; its surface has room for ``SIMD_WIDTH`` numbers before it. Moved slabs,
    travel and the rest are added to ``tally``, which is this thread's own, as the work space and the rules'
    orders are. Work that is broken off leaves bed and tally as they happen to be.
    """
    bed, rules, work, plan, tally = borrowed((bed, rules, work, plan, tally))
    wrap, interruption = lattice_rules(rules).grid.wrap_across, lattice_rules(rules).interruption
    add(plan.signals, RUNNING, 1)
    spins = 0
    band, number = _next_band(plan, wrap)
    while band != _NOTHING and load(plan.signals, BROKEN_OFF) == 0 and interruption[0] == 0:
        if band != _LATER and swap(plan.taken, band, number, number + 1):
            _run(bed, rules, work, schedule, plan, band, number, tally)
            if load(plan.signals, BROKEN_OFF) == 0 and interruption[0] == 0:
                add(plan.done, band, 1)
            spins = 0
        elif band == _LATER:
            spins = wait_a_moment(spins)
        band, number = _next_band(plan, wrap)
    add(plan.signals, RUNNING, -1)


@njit(cache=True, nogil=True)
def await_rounds(plan):
    """Wait until no thread is at work on a plan; why it was broken off (``STRAYED``, ``FULL``), or 0."""
    while load(plan.signals, RUNNING) != 0:
        give_way()
    return load(plan.signals, BROKEN_OFF)
