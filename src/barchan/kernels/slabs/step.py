"""Slab transport: the polls of a step, band by band, and steps one after the other.

This is Werner's rule (1995, Geology 23, 1107-1110) with the variants of later models given as data; a poll
itself is in ``poll``.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.levels import measure_levels
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import derive
from barchan.kernels.slabs.poll import run_polls
from barchan.kernels.slabs.polling import (
    count_polls_by_row,
    draw_cells,
    polls_in_band,
    shuffle_bands,
    shuffle_cells,
    take_cells,
)
from barchan.kernels.slabs.state import BLOCK, EXHAUSTED, MOVED, Band, Round


@internal()
def _run_round(stacks, rules, work, schedule, part, tally):
    """Run one round of polls, band by band.

    Drawn with replacement it is the polls ``start`` to ``stop`` of a step. Otherwise it is the cells
    ``start`` to ``stop`` of a shuffled round through the lattice, to which every band gives the same share
    of its own cells, so that a part of a round is spread over the field.
    """
    never_inline()
    grid, polls = rules.grid, work.polls
    cells = grid.rows * grid.cols
    peak = np.int64(stacks.surface.max())
    exhausted = tally[EXHAUSTED]
    redraw = schedule.forced and not schedule.each_once
    if not schedule.each_once:
        count_polls_by_row(polls, part.start, part.stop - part.start, derive(part.key, 1))
    shuffle_bands(polls, derive(part.key, 0 if schedule.each_once else 2))
    poll = part.start
    for number in polls.band_order:
        first_row = number * schedule.band_rows
        band = Band(first_row, min(schedule.band_rows, grid.rows - first_row))
        size = band.rows * grid.cols
        at = 0
        end = polls_in_band(polls, band)
        if schedule.each_once:
            shuffle_cells(polls, size, derive(part.key, 1 + number))
            at = part.start * size // cells
            end = part.stop * size // cells
            poll = part.number * cells + first_row * grid.cols + at
        while at < end:
            n = min(BLOCK, end - at)
            if schedule.each_once:
                take_cells(polls, poll, at, n, first_row, grid.cols, part.poll_key)
            else:
                draw_cells(polls, poll, n, band, grid.cols, part.poll_key)
            peak = run_polls(stacks, rules, work, band, n, redraw, part.target, peak, tally)
            if tally[MOVED] == part.target or tally[EXHAUSTED] > exhausted or rules.interruption[0] != 0:
                return
            poll += n
            at += n


@internal()
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


@internal()
def _run_rounds(stacks, rules, work, schedule, step_key, first, count, tally):
    """Run the polls ``first`` to ``first + count`` of a step that polls each cell once a round."""
    cells = rules.grid.rows * rules.grid.cols
    poll_key = derive(step_key, 0)
    number = first // cells
    going = True
    while going:
        start = max(first - number * cells, 0)
        stop = min(first + count - number * cells, cells)
        key = derive(derive(step_key, 3), number)
        _run_round(stacks, rules, work, schedule, Round(number, start, stop, key, poll_key, -1), tally)
        number += 1
        going = number * cells < first + count and rules.interruption[0] == 0


@njit(cache=True, nogil=True)
def run_steps(stacks, rules, work, schedule, key, step, steps, first, count, tally):
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
        if not schedule.each_once:
            part = Round(0, first, first + count, step_key, derive(step_key, 0), -1)
            _run_round(stacks, rules, work, schedule, part, tally)
        elif schedule.forced:
            _walk(stacks, rules, work, schedule, step_key, first, count, tally)
        else:
            _run_rounds(stacks, rules, work, schedule, step_key, first, count, tally)
