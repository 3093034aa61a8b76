"""Forced erosion: a poll whose cell may not erode looks for one that may, so bands wait for those before.

This is Werner's rule (1995, Geology 23, 1107-1110) with the variants of later models given as data; a poll
itself is in ``poll``, steps without forced erosion are in ``bands``.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.levels import measure_levels
from barchan.kernels.core.internal import woven
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


@woven()
def _walk(stacks, rules, work, schedule, step_key, first, count, tally):
    """Run rounds through all cells until ``count`` slabs have moved or a whole round has moved none."""
    cells = rules.grid.rows * rules.grid.cols
    poll_key = derive(derive(step_key, 4), first)
    target = tally[MOVED] + count
    number = 0
    going = True
    while going:
        moved = tally[MOVED]
        part = Round(number, 0, cells, derive(poll_key, number), poll_key, target)
        _run_round(stacks, rules, work, schedule, part, tally)
        number += 1
        going = tally[MOVED] < target and tally[MOVED] > moved and rules.interruption[0] == 0
        if tally[MOVED] == moved:
            tally[EXHAUSTED] += 1


@njit(cache=True, nogil=True)
def run_forced_steps(stacks, rules, work, schedule, key, step, steps, first, count, tally):
    """Run the polls ``first`` to ``first + count`` of each of ``steps`` steps from ``step`` on.

    The stacks are changed in place; their surface has room for ``SIMD_WIDTH`` numbers before it. ``key`` is
    the random stream's. Moved slabs, travel and the rest are added to ``tally``. Work that is broken off
    leaves stacks and tally as they happen to be.
    """
    for s in range(steps):
        if rules.interruption[0] != 0:
            return
        step_key = derive(key, step + s)
        measure_levels(stacks.surface, stacks.levels)
        if schedule.each_once:
            _walk(stacks, rules, work, schedule, step_key, first, count, tally)
        else:
            part = Round(0, first, first + count, step_key, derive(step_key, 0), -1)
            _run_round(stacks, rules, work, schedule, part, tally)
