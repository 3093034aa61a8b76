"""Forced erosion: a poll whose cell may not erode looks for one that may, so bands wait for those before.

This is Werner's rule (1995, Geology 23, 1107-1110) with the variants of later models given as data; a poll
itself is in ``poll``, steps without forced erosion are in ``bands``.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.levels import measure_levels
from barchan.kernels.core.internal import internal, woven
from barchan.kernels.core.random import derive
from barchan.kernels.slabs.bands import run_band
from barchan.kernels.slabs.polling import band_of, count_polls_by_row, polls_in_band, shuffle_bands
from barchan.kernels.slabs.state import EXHAUSTED, MOVED, Round


@woven()
def _run_round(stacks, rules, work, schedule, part, tally):
    """Run one round of polls, band by band in random order, until its target is reached."""
    polls = work.polls
    peak = np.int64(stacks.surface.max())
    exhausted = tally[EXHAUSTED]
    if not schedule.each_once:
        count_polls_by_row(polls, part.start, part.stop - part.start, derive(part.key, 1))
    shuffle_bands(polls.band_order, derive(part.key, 0 if schedule.each_once else 2))
    first = part.start
    for number in polls.band_order:
        band = band_of(number, rules.grid.rows, schedule, rules.grid.rows, rules.grid.rows)
        count = polls_in_band(polls, band)
        peak = run_band(stacks, rules, work, schedule, part, band, first, count, peak, tally)
        if tally[MOVED] == part.target or tally[EXHAUSTED] > exhausted or rules.interruption[0] != 0:
            return
        first += count


@internal()
def _round_of(schedule, step_key, number, first, count, cells, target):
    """One of the rounds of a step: all of its polls; or all cells, each time in an order of its own."""
    poll_key = derive(step_key, 0)
    if not schedule.each_once:
        return Round(0, first, first + count, step_key, poll_key, -1)
    poll_key = derive(derive(step_key, 4), first)
    return Round(number, 0, cells, derive(poll_key, number), poll_key, target)


@njit(cache=True, nogil=True)
def run_forced_steps(stacks, rules, work, schedule, key, step, steps, first, count, tally):
    """Run the polls ``first`` to ``first + count`` of each of ``steps`` steps from ``step`` on.

    Where each cell is polled once, rounds through all cells go on until ``count`` slabs have moved or a whole
    round has moved none. The stacks are changed in place; their surface has room for ``SIMD_WIDTH`` numbers
    before it. ``key`` is the random stream's. Moved slabs, travel and the rest are added to ``tally``. Work
    that is broken off leaves stacks and tally as they happen to be.
    """
    cells = rules.grid.rows * rules.grid.cols
    for s in range(steps):
        step_key = derive(key, step + s)
        measure_levels(stacks.surface, stacks.levels)
        target = tally[MOVED] + count
        number, going = 0, rules.interruption[0] == 0
        while going:
            moved = tally[MOVED]
            part = _round_of(schedule, step_key, number, first, count, cells, target)
            _run_round(stacks, rules, work, schedule, part, tally)
            number += 1
            going = schedule.each_once and moved < tally[MOVED] < target and rules.interruption[0] == 0
            if schedule.each_once and tally[MOVED] == moved:
                tally[EXHAUSTED] += 1
