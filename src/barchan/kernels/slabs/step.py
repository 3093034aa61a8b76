"""Slab transport: the polls of a step, band by band, and steps one after the other.

This is Werner's rule (1995, Geology 23, 1107-1110) with the variants of later models told apart by data; a
poll itself is in ``saltation``.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.levels import measure_levels
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
from barchan.kernels.slabs.state import BLOCK, EXHAUSTED, MOVED


@njit(cache=True)
def _poll_round(
    surface,
    sand,
    mobility,
    levels,
    turns,
    sequences,
    queue,
    waiting,
    grid,
    wind,
    speedup,
    path,
    repose,
    axis,
    ray,
    polls,
    schedule,
    poll_key,
    round_key,
    round_,
    start,
    stop,
    target,
    tally,
):
    """One round of polls, band by band.

    Drawn with replacement it is the polls ``start`` to ``stop`` of a step. Otherwise it is the cells
    ``start`` to ``stop`` of a shuffled round through the lattice, to which every band gives the same share
    of its own cells, so that a part of a round is spread over the field.
    """
    cells = grid.rows * grid.cols
    peak = np.int64(surface.max())
    exhausted = tally[EXHAUSTED]
    if not schedule.each_once:
        count_polls_by_row(polls, start, stop - start, derive(round_key, 1))
    shuffle_bands(polls, derive(round_key, 0 if schedule.each_once else 2))
    poll = start
    for band in polls.band_order:
        first_row = band * schedule.band_rows
        rows = min(schedule.band_rows, grid.rows - first_row)
        size = rows * grid.cols
        at = 0
        end = polls_in_band(polls, first_row, rows)
        if schedule.each_once:
            shuffle_cells(polls, size, derive(round_key, 1 + band))
            at = start * size // cells
            end = stop * size // cells
            poll = round_ * cells + first_row * grid.cols + at
        while at < end:
            n = min(BLOCK, end - at)
            if schedule.each_once:
                take_cells(polls, poll, at, n, first_row, grid.cols, poll_key)
            else:
                draw_cells(polls, poll, n, first_row, rows, grid.cols, poll_key)
            redraw = schedule.forced and not schedule.each_once
            peak = run_polls(
                surface,
                sand,
                mobility,
                levels,
                turns,
                sequences,
                queue,
                waiting,
                grid,
                wind,
                speedup,
                path,
                repose,
                axis,
                ray,
                polls.rows,
                polls.cols,
                polls.states,
                n,
                redraw,
                first_row,
                rows,
                target,
                peak,
                tally,
            )
            if tally[MOVED] == target or tally[EXHAUSTED] > exhausted:
                return
            poll += n
            at += n


@njit(cache=True)
def transport(
    surface,
    sand,
    mobility,
    levels,
    turns,
    sequences,
    queue,
    waiting,
    grid,
    wind,
    speedup,
    path,
    repose,
    axis,
    ray,
    polls,
    schedule,
    key,
    step,
    steps,
    first,
    count,
    tally,
):
    """Run the polls ``first`` to ``first + count`` of each of ``steps`` steps from ``step`` on.

    ``surface`` (flat, in whole units, with room for ``lanes.LANES`` numbers before it) and the slabs
    ``sand`` on it (None over flat ground, where the surface counts slabs) are changed in place. ``mobility``
    tells for each cell how freely the wind works there (None: everywhere), ``levels`` is room for what
    ``speedup`` measures heights against, and ``path`` tells what stops a slab in flight. ``turns`` orders the
    neighbours; where sand lets go at another angle than it rests at, ``sequences`` does, and ``queue`` and
    ``waiting`` are room for the cells that slide. One of ``axis`` and ``ray`` tells how shadows fall, and
    ``key`` is the stream's.
    What happens is added to ``tally``.
    """
    cells = grid.rows * grid.cols
    walking = schedule.each_once and schedule.forced
    for s in range(steps):
        step_key = derive(key, step + s)
        poll_key = derive(step_key, 0)
        before = tally[MOVED]
        target = -1
        round_ = first // cells
        if walking:
            poll_key = derive(derive(step_key, 4), first)
            target = before + count
            round_ = 0
        if speedup is not None:
            measure_levels(surface, levels, speedup)
        going = True
        while going:
            moved = tally[MOVED]
            round_key = step_key
            start = first
            stop = first + count
            if walking:
                round_key = derive(poll_key, round_)
                start = 0
                stop = cells
            elif schedule.each_once:
                round_key = derive(derive(step_key, 3), round_)
                start = max(first - round_ * cells, 0)
                stop = min(first + count - round_ * cells, cells)
            _poll_round(
                surface,
                sand,
                mobility,
                levels,
                turns,
                sequences,
                queue,
                waiting,
                grid,
                wind,
                speedup,
                path,
                repose,
                axis,
                ray,
                polls,
                schedule,
                poll_key,
                round_key,
                round_,
                start,
                stop,
                target,
                tally,
            )
            round_ += 1
            if walking:
                going = tally[MOVED] < target and tally[MOVED] > moved
                if tally[MOVED] == moved:
                    tally[EXHAUSTED] += 1
            else:
                going = schedule.each_once and round_ * cells < first + count
