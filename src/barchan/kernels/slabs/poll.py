"""Polls, one after the other: a cell gives a slab, the wind carries it, it settles, slopes slide.

What a model does without is None, and the compiler leaves it out. All work is done in the wind's frame (see
``shadow``), on flat arrays of whole numbers.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.grid import neighbour
from barchan.kernels.bed.levels import move_level
from barchan.kernels.bed.relax import CHECKED, let_go, upset
from barchan.kernels.bed.slopes import draw_turns, has_sand, steepest
from barchan.kernels.bed.state import DRAWN, FEED, SLIDE, STABLE
from barchan.kernels.core.random import GOLDEN, below, high, low, mix
from barchan.kernels.slabs.hop import fixed_hop, hop_cells, wrapped
from barchan.kernels.slabs.obstacles import fly, way_is_clear
from barchan.kernels.slabs.shadow import in_shadow
from barchan.kernels.slabs.state import (
    CAPPED,
    CELL,
    EXHAUSTED,
    LEFT,
    MOBILE,
    MOVED,
    TRAVEL_ACROSS,
    TRAVEL_ALONG,
)

FORCED_TRIES = 1000
"""Cells that a forced poll draws before it walks on through the lattice in order."""

_ALL = 1 << 32
"""A chance of one."""


@njit(cache=True, forceinline=True)
def _gives(surface, sand, mobility, levels, heights, row, col, state, peak, grid, wind, speedup, axis, ray):
    """Whether a polled cell gives a slab, and the random state after it was asked."""
    cell = np.uint64(row * grid.cols + col)
    gives = has_sand(surface, sand, cell)
    if mobility is not None:
        state += GOLDEN
        share = np.int64(mobility[cell]) * wind.give_share // MOBILE + wind.give_shift
        gives &= np.int64(high(mix(state))) < share
    if speedup is not None:
        gives &= hop_cells(surface[cell], levels, speedup) != 0.0
    if wind.lee_erosion or (ray is not None and not gives):
        return gives, state
    return not in_shadow(heights, row, col, surface[cell], peak, grid, axis, ray) and gives, state


@njit(cache=True)
def _forced_cell(
    surface,
    sand,
    mobility,
    levels,
    heights,
    first_row,
    rows,
    row,
    col,
    state,
    peak,
    grid,
    wind,
    speedup,
    axis,
    ray,
):
    """Look for a cell that gives a slab: at random within the band, then onwards through the lattice.

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
        gives, state = _gives(
            surface, sand, mobility, levels, heights, row, col, state, peak, grid, wind, speedup, axis, ray
        )
        if gives:
            return row, col, state
    return -1, col, state


@njit(cache=True, forceinline=True)
def _change(surface, sand, levels, row, col, grid, slab, count, speedup):
    cell = np.uint64(row * grid.cols + col)
    if speedup is not None:
        before = np.int64(surface[cell])
        move_level(levels, before, before + slab * count, speedup)
    surface[cell] += slab * count
    if sand is not None:
        sand[cell] += count


@njit(cache=True)
def _slide_from(
    surface,
    sand,
    mobility,
    levels,
    turns,
    sequences,
    queue,
    waiting,
    row,
    col,
    sign,
    key,
    grid,
    speedup,
    repose,
):
    """Let slopes slide that a cell's change, down (``sign`` 1) or up (-1), took over the release."""
    cell = row * grid.cols + col
    turn = SLIDE if sign < 0 else FEED
    here = np.int64(surface[cell])
    way = steepest(surface, sand, mobility, turns, turn, row, col, here, sign, True, grid, repose)
    if way == STABLE:
        return
    length = upset(cell, CHECKED, queue, waiting, 0, 0)
    for k in range(8):
        r, c = neighbour(row, col, k, grid)
        length = upset(r * grid.cols + c, CHECKED, queue, waiting, 0, length)
    let_go(
        surface, sand, mobility, levels, sequences, queue, waiting, length, key, grid, speedup, repose, None
    )


@njit(cache=True)
def run_polls(
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
    hop_along = wind.hop_along
    hop_across = wind.hop_across
    moved = tally[MOVED]
    left = 0
    capped = 0
    travel_along = np.int64(0)
    travel_across = np.int64(0)
    for k in range(count):
        row = rows[np.uint64(k)]
        col = cols[np.uint64(k)]
        state = states[np.uint64(k)]
        gives, state = _gives(
            surface, sand, mobility, levels, heights, row, col, state, peak, grid, wind, speedup, axis, ray
        )
        if not gives:
            if not redraw:
                continue
            row, col, state = _forced_cell(
                surface,
                sand,
                mobility,
                levels,
                heights,
                band_row,
                band_rows,
                row,
                col,
                state,
                peak,
                grid,
                wind,
                speedup,
                axis,
                ray,
            )
            if row < 0:
                tally[EXHAUSTED] += 1
                break
        moved += 1
        if speedup is not None:
            hop = hop_cells(surface[np.uint64(row * grid.cols + col)], levels, speedup)
            hop_along = fixed_hop(hop, wind.unit_along)
            hop_across = fixed_hop(hop, wind.unit_across)

        r = row
        c = col
        if queue is None:
            turn = FEED
            way = 0
            while way != STABLE:
                here = np.int64(surface[np.uint64(r * grid.cols + c)]) - repose.slab
                way = steepest(surface, sand, mobility, turns, turn, r, c, here, 1, False, grid, repose)
                if repose.random_order and way != STABLE and turn == FEED:
                    state += GOLDEN
                    draw_turns(turns, FEED, mix(state))
                    turn = DRAWN
                elif way != STABLE:
                    r, c = neighbour(r, c, way, grid)
                    turn = FEED
        _change(surface, sand, levels, r, c, grid, repose.slab, -1, speedup)
        if queue is not None:
            state += GOLDEN
            _slide_from(
                surface,
                sand,
                mobility,
                levels,
                turns,
                sequences,
                queue,
                waiting,
                r,
                c,
                1,
                mix(state),
                grid,
                speedup,
                repose,
            )

        along = col << 32
        across = row << 32
        spread = (hop_along | hop_across) & (CELL - 1) != 0
        if speedup is not None:
            spread |= not speedup.whole
        if spread:
            state += GOLDEN
            draw = mix(state)
            along |= np.int64(high(draw))
            across |= np.int64(low(draw))
        flown = 0
        settled = False
        sticks = False
        while not settled:
            flown += 1
            clear = True
            stopped = False
            if path is not None:
                clear = way_is_clear(heights, along, across, hop_along, hop_across, grid, path)
                if not clear:
                    along, across, flown_along, flown_across, stopped = fly(
                        surface, sand, along, across, hop_along, hop_across, grid, repose, path
                    )
                    travel_along += flown_along >> 16
                    travel_across += flown_across >> 16
                    row = across >> 32
            if clear:
                travel_along += hop_along >> 16
                travel_across += hop_across >> 16
                along = wrapped(along + hop_along, grid.cols, grid.wrap_along)
                if hop_across != 0:
                    across = wrapped(across + hop_across, grid.rows, grid.wrap_across)
                    row = across >> 32
            col = along >> 32
            if along < 0 or across < 0:
                break
            state += GOLDEN
            chance = high(mix(state))
            cell = np.uint64(row * grid.cols + col)
            settle = wind.settle_on_sand if has_sand(surface, sand, cell) else wind.settle_on_ground
            if mobility is None:
                sticks = chance < settle
            if mobility is not None:
                hops_on = (_ALL - np.int64(settle)) * np.int64(mobility[cell]) // MOBILE
                sticks = np.int64(chance) < _ALL - hops_on
            sticks |= stopped
            if axis is not None or not sticks:
                sticks |= in_shadow(heights, row, col, surface[cell], peak, grid, axis, ray)
            if speedup is not None:
                if speedup.every_hop and not sticks:
                    hop = hop_cells(surface[cell], levels, speedup)
                    hop_along = fixed_hop(hop, wind.unit_along)
                    hop_across = fixed_hop(hop, wind.unit_across)
                    sticks = hop == 0.0
            settled = sticks | (flown == wind.max_hops)
        if not settled:
            left += 1
        else:
            capped += not sticks
            if queue is None:
                turn = SLIDE
                way = 0
                while way != STABLE:
                    here = np.int64(surface[np.uint64(row * grid.cols + col)]) + repose.slab
                    way = steepest(
                        surface, sand, mobility, turns, turn, row, col, here, -1, False, grid, repose
                    )
                    if repose.random_order and way != STABLE and turn == SLIDE:
                        state += GOLDEN
                        draw_turns(turns, SLIDE, mix(state))
                        turn = DRAWN
                    elif way != STABLE:
                        row, col = neighbour(row, col, way, grid)
                        turn = SLIDE
            _change(surface, sand, levels, row, col, grid, repose.slab, 1, speedup)
            peak = max(peak, np.int64(surface[np.uint64(row * grid.cols + col)]))
            if queue is not None:
                state += GOLDEN
                _slide_from(
                    surface,
                    sand,
                    mobility,
                    levels,
                    turns,
                    sequences,
                    queue,
                    waiting,
                    row,
                    col,
                    -1,
                    mix(state),
                    grid,
                    speedup,
                    repose,
                )
        if moved == target:
            break
    tally[MOVED] = moved
    tally[LEFT] += left
    tally[CAPPED] += capped
    tally[TRAVEL_ALONG] += travel_along
    tally[TRAVEL_ACROSS] += travel_across
    return peak
