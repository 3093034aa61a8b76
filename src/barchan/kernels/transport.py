"""Slab transport: polled cells give a slab to the wind, which carries it until it settles.

This is Werner's rule (1995, Geology 23, 1107-1110) with the variants of later models told apart by data.
All work is done in the wind's frame (see ``shadow``), on flat arrays of whole numbers.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.avalanche import (
    DRAWN,
    FEED,
    SLIDE,
    STABLE,
    draw_turns,
    has_sand,
    neighbour,
    steepest,
)
from barchan.kernels.polling import (
    BLOCK,
    count_polls_by_row,
    draw_cells,
    polls_in_band,
    shuffle_bands,
    shuffle_cells,
    take_cells,
)
from barchan.kernels.random import GOLDEN, below, derive, high, low, mix
from barchan.kernels.shadow import in_shadow

CELL = 1 << 32
"""One cell in the fixed-point numbers that positions and hops are kept in."""

TRAVEL_UNIT = 1 << 16
"""One cell in the tally of distances travelled."""

MOVED, LEFT, CAPPED, TRAVEL_ALONG, TRAVEL_ACROSS, SLICES, STILL, EXHAUSTED = range(8)
"""Places in a tally: slabs moved, slabs that left, slabs put down after ``max_hops``, distances
travelled on the wind, slices run, how many of the last slices moved nothing, and slices cut short
because no cell could erode."""
TALLY_SIZE = 8

FORCED_TRIES = 1000
"""Cells that a forced poll draws before it walks on through the lattice in order."""


class Wind(NamedTuple):
    """How the wind takes, carries and drops a slab."""

    lee_erosion: bool
    """Whether a cell in shadow may give a slab."""
    hop_along: int
    """One hop in 1/``CELL`` cells."""
    hop_across: int
    settle_on_sand: np.uint64
    """Chance of settling where there is sand, in 2**-32."""
    settle_on_ground: np.uint64
    max_hops: int


@njit(cache=True, forceinline=True)
def _may_erode(surface, sand, heights, row, col, peak, grid, wind, axis, ray):
    cell = np.uint64(row * grid.cols + col)
    sandy = has_sand(surface, sand, cell)
    if wind.lee_erosion or (ray is not None and not sandy):
        return sandy
    return not in_shadow(heights, row, col, surface[cell], peak, grid, axis, ray) and sandy


@njit(cache=True)
def _forced_cell(surface, sand, heights, first_row, rows, row, col, state, peak, grid, wind, axis, ray):
    """Look for a cell that can erode: at random within the band, then onwards through the lattice.

    Returns its row (negative where none is left), column and the advanced random state.
    """
    for attempt in range(FORCED_TRIES + grid.rows * grid.cols):
        if attempt < FORCED_TRIES:
            state += GOLDEN
            draw = mix(state)
            col = below(high(draw), grid.cols)
            row = first_row + below(low(draw), rows)
        else:
            col += 1
            if col == grid.cols:
                col = 0
                row = row + 1 if row + 1 < grid.rows else 0
        if _may_erode(surface, sand, heights, row, col, peak, grid, wind, axis, ray):
            return row, col, state
    return -1, col, state


@njit(cache=True, forceinline=True)
def _wrapped(place, size, wrap):
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


@njit(cache=True, forceinline=True)
def _change(surface, sand, row, col, grid, slab, count):
    cell = np.uint64(row * grid.cols + col)
    surface[cell] += slab * count
    if sand is not None:
        sand[cell] += count


@njit(cache=True)
def _run_polls(
    surface,
    sand,
    turns,
    grid,
    wind,
    repose,
    axis,
    ray,
    rows,
    cols,
    states,
    count,
    redraw,
    band_row,
    band_rows,
    target,
    peak,
    tally,
):
    """Let ``count`` polls happen, one after the other, until ``target`` slabs have moved in all.

    With ``redraw`` a cell that cannot erode is replaced by one that can. Returns a height that no cell
    exceeds now.
    """
    heights = surface.ctypes.data
    oblique = (wind.hop_along | wind.hop_across) & (CELL - 1) != 0
    moved = tally[MOVED]
    hops = 0
    left = 0
    capped = 0
    for k in range(count):
        row = rows[np.uint64(k)]
        col = cols[np.uint64(k)]
        state = states[np.uint64(k)]
        if not _may_erode(surface, sand, heights, row, col, peak, grid, wind, axis, ray):
            if not redraw:
                continue
            row, col, state = _forced_cell(
                surface, sand, heights, band_row, band_rows, row, col, state, peak, grid, wind, axis, ray
            )
            if row < 0:
                tally[EXHAUSTED] += 1
                break
        moved += 1

        r = row
        c = col
        turn = FEED
        way = 0
        while way != STABLE:
            here = np.int64(surface[np.uint64(r * grid.cols + c)]) - repose.slab
            way = steepest(surface, sand, turns, turn, r, c, here, 1, grid, repose)
            if repose.random_order and way != STABLE and turn == FEED:
                state += GOLDEN
                draw_turns(turns, FEED, mix(state))
                turn = DRAWN
            elif way != STABLE:
                r, c = neighbour(r, c, way, grid)
                turn = FEED
        _change(surface, sand, r, c, grid, repose.slab, -1)

        along = col << 32
        across = row << 32
        if oblique:
            state += GOLDEN
            draw = mix(state)
            along |= np.int64(high(draw))
            across |= np.int64(low(draw))
        flown = 0
        settled = False
        sticks = False
        while not settled:
            flown += 1
            along = _wrapped(along + wind.hop_along, grid.cols, grid.wrap_along)
            if wind.hop_across != 0:
                across = _wrapped(across + wind.hop_across, grid.rows, grid.wrap_across)
                row = across >> 32
            col = along >> 32
            if along < 0 or across < 0:
                break
            state += GOLDEN
            chance = high(mix(state))
            cell = np.uint64(row * grid.cols + col)
            settle = wind.settle_on_sand if has_sand(surface, sand, cell) else wind.settle_on_ground
            sticks = chance < settle
            if axis is not None or not sticks:
                sticks |= in_shadow(heights, row, col, surface[cell], peak, grid, axis, ray)
            settled = sticks | (flown == wind.max_hops)
        hops += flown
        if not settled:
            left += 1
        else:
            capped += not sticks
            turn = SLIDE
            way = 0
            while way != STABLE:
                here = np.int64(surface[np.uint64(row * grid.cols + col)]) + repose.slab
                way = steepest(surface, sand, turns, turn, row, col, here, -1, grid, repose)
                if repose.random_order and way != STABLE and turn == SLIDE:
                    state += GOLDEN
                    draw_turns(turns, SLIDE, mix(state))
                    turn = DRAWN
                elif way != STABLE:
                    row, col = neighbour(row, col, way, grid)
                    turn = SLIDE
            _change(surface, sand, row, col, grid, repose.slab, 1)
            peak = max(peak, np.int64(surface[np.uint64(row * grid.cols + col)]))
        if moved == target:
            break
    tally[MOVED] = moved
    tally[LEFT] += left
    tally[CAPPED] += capped
    tally[TRAVEL_ALONG] += hops * (wind.hop_along >> 16)
    tally[TRAVEL_ACROSS] += hops * (wind.hop_across >> 16)
    return peak


@njit(cache=True)
def _poll_round(
    surface,
    sand,
    turns,
    grid,
    wind,
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
            peak = _run_polls(
                surface,
                sand,
                turns,
                grid,
                wind,
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
    turns,
    grid,
    wind,
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
    ``sand`` on it (None over flat ground, where the surface counts slabs) are changed in place. ``turns``
    orders the neighbours, one of ``axis`` and ``ray`` tells how shadows fall, and ``key`` is the stream's.
    What happens is added to ``tally``; ``tally[SLICES]`` tells how many steps were run before
    ``schedule.still_limit`` ended the call.
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
                turns,
                grid,
                wind,
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
        tally[SLICES] += 1
        tally[STILL] = 0 if tally[MOVED] > before else tally[STILL] + 1
        if schedule.still_limit > 0 and tally[STILL] >= schedule.still_limit:
            return
