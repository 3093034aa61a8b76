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
    for _ in range(FORCED_TRIES):
        state += GOLDEN
        draw = mix(state)
        col = below(high(draw), grid.cols)
        row = first_row + below(low(draw), rows)
        if _may_erode(surface, sand, heights, row, col, peak, grid, wind, axis, ray):
            return row, col, state
    for _ in range(grid.rows * grid.cols):
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
        way = 0
        while way != STABLE:
            here = np.int64(surface[np.uint64(r * grid.cols + c)]) - repose.slab
            way = steepest(surface, sand, turns, FEED, r, c, here, 1, grid, repose)
            if way != STABLE:
                if repose.random_order:
                    state += GOLDEN
                    draw_turns(turns, FEED, mix(state))
                    way = steepest(surface, sand, turns, DRAWN, r, c, here, 1, grid, repose)
                r, c = neighbour(r, c, way, grid)
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
            settled = (chance < settle) | (flown == wind.max_hops)
            if axis is not None or not settled:
                settled |= in_shadow(heights, row, col, surface[cell], peak, grid, axis, ray)
        hops += flown
        if flown == wind.max_hops:
            capped += 1
        if not settled:
            left += 1
        else:
            way = 0
            while way != STABLE:
                here = np.int64(surface[np.uint64(row * grid.cols + col)]) + repose.slab
                way = steepest(surface, sand, turns, SLIDE, row, col, here, -1, grid, repose)
                if way != STABLE:
                    if repose.random_order:
                        state += GOLDEN
                        draw_turns(turns, SLIDE, mix(state))
                        way = steepest(surface, sand, turns, DRAWN, row, col, here, -1, grid, repose)
                    row, col = neighbour(row, col, way, grid)
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
def _poll_at_random(
    surface, sand, turns, grid, wind, repose, axis, ray, polls, schedule, key, first, count, tally
):
    """Polls ``first`` to ``first + count`` of a step, drawn with replacement."""
    peak = np.int64(surface.max())
    exhausted = tally[EXHAUSTED]
    count_polls_by_row(polls, first, count, derive(key, 1))
    shuffle_bands(polls, derive(key, 2))
    poll = first
    for band in polls.band_order:
        first_row = band * schedule.band_rows
        rows = min(schedule.band_rows, grid.rows - first_row)
        left = polls_in_band(polls, first_row, rows)
        while left > 0:
            n = min(BLOCK, left)
            draw_cells(polls, poll, n, first_row, rows, grid.cols, derive(key, 0))
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
                schedule.forced,
                first_row,
                rows,
                -1,
                peak,
                tally,
            )
            if tally[EXHAUSTED] > exhausted:
                return
            poll += n
            left -= n


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
    key,
    round_,
    start,
    stop,
    target,
    tally,
):
    """Cells ``start`` to ``stop`` of one shuffled round through the whole lattice.

    Every band gives the same share of its own cells, so that a part of a round is spread over the field.
    """
    cells = grid.rows * grid.cols
    peak = np.int64(surface.max())
    shuffle_bands(polls, derive(key, 0))
    for band in polls.band_order:
        first_row = band * schedule.band_rows
        rows = min(schedule.band_rows, grid.rows - first_row)
        size = rows * grid.cols
        shuffle_cells(polls, size, derive(key, 1 + band))
        at = start * size // cells
        end = stop * size // cells
        while at < end:
            n = min(BLOCK, end - at)
            poll = round_ * cells + first_row * grid.cols + at
            take_cells(polls, poll, at, n, first_row, grid.cols, poll_key)
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
                False,
                first_row,
                rows,
                target,
                peak,
                tally,
            )
            if tally[MOVED] == target:
                return
            at += n


@njit(cache=True)
def _poll_each_once(
    surface, sand, turns, grid, wind, repose, axis, ray, polls, schedule, key, first, count, tally
):
    """Polls ``first`` to ``first + count`` of a step that goes through the cells in random order."""
    cells = grid.rows * grid.cols
    poll_key = derive(key, 0)
    for round_ in range(first // cells, (first + count - 1) // cells + 1):
        start = max(first - round_ * cells, 0)
        stop = min(first + count - round_ * cells, cells)
        round_key = derive(derive(key, 3), round_)
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
            -1,
            tally,
        )


@njit(cache=True)
def _poll_each_once_forced(
    surface, sand, turns, grid, wind, repose, axis, ray, polls, schedule, key, first, count, tally
):
    """Rounds through the cells in random order until ``count`` slabs have moved or none can."""
    cells = grid.rows * grid.cols
    target = tally[MOVED] + count
    slice_key = derive(derive(key, 4), first)
    round_ = 0
    while tally[MOVED] < target:
        before = tally[MOVED]
        key = derive(slice_key, round_)
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
            slice_key,
            key,
            round_,
            0,
            cells,
            target,
            tally,
        )
        if tally[MOVED] == before:
            tally[EXHAUSTED] += 1
            return
        round_ += 1


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

    ``bed`` is (surface, sand, grid, wind, repose, axis, ray, mixed): the flat surface in whole units and
    the slabs on it (None over flat ground, where the surface counts slabs), both changed in place; the
    rules; the shadow of a wind along an axis or oblique, the other None; and work space for eight
    directions. ``key`` is the stream's. Counts are added to ``tally``; ``tally[SLICES]`` tells how many
    steps were run before ``schedule.still_limit`` ended the call.
    """
    for s in range(steps):
        step_key = derive(key, step + s)
        before = tally[MOVED]
        if not schedule.each_once:
            _poll_at_random(
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
                step_key,
                first,
                count,
                tally,
            )
        elif schedule.forced:
            _poll_each_once_forced(
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
                step_key,
                first,
                count,
                tally,
            )
        else:
            _poll_each_once(
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
                step_key,
                first,
                count,
                tally,
            )
        tally[SLICES] += 1
        tally[STILL] = 0 if tally[MOVED] > before else tally[STILL] + 1
        if schedule.still_limit > 0 and tally[STILL] >= schedule.still_limit:
            return
