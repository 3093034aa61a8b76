"""Polls, one after the other, by the numbered rules of ``docs/slabs.md``.

Rules that a model does without are None, and the compiler leaves them out: it can tell only where the rule is
an argument of its own, so functions take an optional rule first. All work is done in the wind's frame (see
``shadow``), on flat arrays of whole numbers.
"""

import numpy as np

from barchan.kernels.bed.relax import CHECKED, NO_END, enqueue, enqueue_about, relax_queue
from barchan.kernels.bed.sliding import next_on_slope
from barchan.kernels.bed.slopes import steepest
from barchan.kernels.bed.state import AT_REST, DOWN, DOWNSLOPE, STABLE, UP, UPSLOPE
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.core.prefetch import prefetch
from barchan.kernels.core.random import GOLDEN, mix
from barchan.kernels.slabs.carry import HOPS_FAR, IS_CAPPED, LEAVES, carry, first_hop, take_off
from barchan.kernels.slabs.erosion import find_eroding_cell, may_erode
from barchan.kernels.slabs.flights import address_of, put_aside
from barchan.kernels.slabs.shadow import is_near
from barchan.kernels.slabs.state import (
    BLOCK,
    CAPPED,
    EXHAUSTED,
    FULL,
    LEFT,
    MOVED,
    STRAYED,
    TRAVEL_ACROSS,
    TRAVEL_ALONG,
    View,
)

AHEAD = 6
"""Polls by which the memory of a cell is asked for beforehand."""


@internal(forceinline=True)
def _change(stacks, sand, cell, slab, count):
    """Change a cell's stack by ``count`` slabs; returns its new height."""
    stacks.surface[cell] += slab * count
    if sand is not None:
        sand[cell] += count
    return np.int64(stacks.surface[cell])


@internal()
def _relax_about(stacks, orders, unstable, row, col, key, grid, repose):
    """Relax the slopes about a cell until every one stands."""
    never_inline()
    length = enqueue(unstable, row * grid.cols + col, CHECKED, 0, 0)
    length = enqueue_about(unstable, row, col, 0, 0, length, grid)
    relax_queue(stacks, orders, unstable, (0, length, 0, 0), NO_END, key, grid, repose, None)


@internal(forceinline=True)
def _is_too_steep(stacks, orders, row, col, sign, grid, repose):
    """Whether a step up (``sign`` 1) or down (-1) from a cell exceeds the static limit."""
    order = UPSLOPE if sign > 0 else DOWNSLOPE
    here = np.int64(stacks.surface[row * grid.cols + col])
    return steepest(stacks, orders, order, row, col, here, sign, AT_REST, grid, repose) != STABLE


@internal(forceinline=True)
def _next_on_slope(unstable, stacks, orders, order, row, col, state, sign, grid, repose):
    """One step up (``sign`` 1) or down (-1) a slope that does not stand, where slabs slide one by one.

    Where there is a static limit (``unstable``) an avalanche follows once the cell itself has changed.
    """
    if unstable is not None:
        return row, col, order, state, False
    return next_on_slope(stacks, orders, order, row, col, state, sign, grid, repose)


@internal(forceinline=True)
def _relax_after(unstable, stacks, orders, relaxation_orders, row, col, state, sign, grid, repose):
    """Let an avalanche go from a cell that was lowered (``sign`` 1) or raised (-1); the random state."""
    if unstable is None:
        return state
    state += GOLDEN
    if _is_too_steep(stacks, orders, row, col, sign, grid, repose):
        _relax_about(stacks, relaxation_orders, unstable, row, col, mix(state), grid, repose)
    return state


@internal(forceinline=True)
def _strays(sliding, row, band, grid):
    """Whether a walk has come to a row that the polls of the band may not touch."""
    if not sliding:
        return False
    return not is_near(row, band.touched, grid)


@internal(forceinline=True)
def _fetch(polls, k, surface, bytes_of_row, width):
    """Ask for the memory about the cell of a later poll: on large fields it comes later than a poll ends."""
    later = np.uint64(k & (BLOCK - 1))
    address = surface + polls.rows[later] * bytes_of_row + polls.cols[later] * width
    prefetch(address)
    prefetch(address + bytes_of_row)
    prefetch(address - bytes_of_row)


@internal()
def lay_down(unstable, stacks, rules, row, col, state):
    """Lay a slab on a cell and let it slide down the slope; returns the height of the cell that it raises."""
    grid, repose, orders = rules.grid, rules.repose, rules.orders
    order, sliding = DOWNSLOPE, True
    while sliding:
        row, col, order, state, sliding = _next_on_slope(
            unstable, stacks, orders, order, row, col, state, DOWN, grid, repose
        )
    cell = np.uint64(row * grid.cols + col)
    height = _change(stacks, stacks.sand, cell, repose.slab, 1)
    _relax_after(unstable, stacks, orders, rules.relaxation_orders, row, col, state, DOWN, grid, repose)
    return height


@internal()
def run_polls(stacks, rules, work, band, count, redraw, target, peak, tally):
    """Run ``count`` prepared polls, one after the other, until ``target`` slabs have moved in all.

    With ``redraw`` a cell that may not erode is replaced by one that may. Returns a height that no cell
    exceeds now; or, with polls left undone, ``STRAYED`` before a walk touches a row that it may not, and
    ``FULL`` where there is no room for another slab that hops far.
    """
    never_inline()
    stacks, rules, work = borrowed((stacks, rules, work))
    surface = stacks.surface.ctypes.data
    view = View(surface, address_of(work.before, surface), band.near)
    grid, repose, orders, relaxation_orders = rules.grid, rules.repose, rules.orders, rules.relaxation_orders
    polls, unstable = work.polls, work.unstable
    moved = tally[MOVED]
    left = 0
    capped = 0
    travel_along = np.int64(0)
    travel_across = np.int64(0)
    bytes_of_row = grid.cols * stacks.surface.itemsize
    for k in range(count):
        _fetch(polls, k + AHEAD, surface, bytes_of_row, stacks.surface.itemsize)
        # 1 choose a cell
        row, col, state = polls.rows[np.uint64(k)], polls.cols[np.uint64(k)], polls.states[np.uint64(k)]
        # 2 may it erode?
        erodes, along, across, state = may_erode(stacks, rules, view, row, col, state, peak)
        if not erodes:
            if not redraw:
                continue
            along, across, state = find_eroding_cell(stacks, rules, view, band, row, col, state, peak)
            if across < 0:
                tally[EXHAUSTED] += 1
                break
            row, col = across >> 32, along >> 32
        moved += 1
        height = stacks.surface[np.uint64(row * grid.cols + col)]
        hop_along, hop_across = first_hop(rules.speedup, stacks.levels, rules.wind, height)
        # 3 take the slab, and let the slope above feed its cell
        r, c, order, sliding = row, col, UPSLOPE, True
        while sliding:
            r, c, order, state, sliding = _next_on_slope(
                unstable, stacks, orders, order, r, c, state, UP, grid, repose
            )
            if _strays(sliding, r, band, grid):
                return np.int64(STRAYED)
        _change(stacks, stacks.sand, np.uint64(r * grid.cols + c), repose.slab, -1)
        state = _relax_after(unstable, stacks, orders, relaxation_orders, r, c, state, UP, grid, repose)
        # 4 hop, 5 settle?
        along, across, state = take_off(
            rules.box, rules.speedup, along, across, hop_along, hop_across, state, grid
        )
        along, across, hop_along, hop_across, state, hops, fate, way_along, way_across = carry(
            stacks, rules, view, along, across, hop_along, hop_across, state, 0, peak
        )
        travel_along += way_along
        travel_across += way_across
        if fate == HOPS_FAR:
            slab = (along, across, hop_along, hop_across, np.int64(state), hops)
            if not put_aside(work.flights, band.number, slab):
                return np.int64(FULL)
        elif fate == LEAVES:
            left += 1
        else:
            # 6 lay it down, and let it slide down the slope
            capped += fate == IS_CAPPED
            row, col, order, sliding = across >> 32, along >> 32, DOWNSLOPE, True
            while sliding:
                row, col, order, state, sliding = _next_on_slope(
                    unstable, stacks, orders, order, row, col, state, DOWN, grid, repose
                )
                if _strays(sliding, row, band, grid):
                    return np.int64(STRAYED)
            cell = np.uint64(row * grid.cols + col)
            peak = max(peak, _change(stacks, stacks.sand, cell, repose.slab, 1))
            _relax_after(unstable, stacks, orders, relaxation_orders, row, col, state, DOWN, grid, repose)
        if moved == target:
            break
    tally[MOVED] = moved
    tally[LEFT] += left
    tally[CAPPED] += capped
    tally[TRAVEL_ALONG] += travel_along
    tally[TRAVEL_ACROSS] += travel_across
    return peak
