"""Polls, one after the other, by the numbered rules of ``docs/slabs.md``.

Rules that a model does without are None, and the compiler leaves them out: it can tell only where the rule is
an argument of its own, so functions take an optional rule first. All work is done in the wind's frame (see
``shadow``), on flat arrays of whole numbers.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.levels import move_level
from barchan.kernels.bed.relax import CHECKED, enqueue, enqueue_about, relax_queue
from barchan.kernels.bed.slopes import end_of_slope, has_sand, steepest
from barchan.kernels.bed.state import DOWNSLOPE, STABLE, UPSLOPE
from barchan.kernels.core.borrow import lent
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.random import GOLDEN, below, high, low, mix
from barchan.kernels.slabs.hop import fixed_hop, hop_cells, wrapped
from barchan.kernels.slabs.obstacles import hop_until_blocked, way_is_clear
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
def _chance_allows(mobility, cell, wind, state):
    """Whether the chance of erosion lets a slab go, and the random state after it was drawn."""
    if mobility is None:
        return True, state
    state += GOLDEN
    chance = np.int64(mobility[cell]) * wind.erosion_factor // MOBILE + wind.erosion_offset
    return np.int64(high(mix(state))) < chance, state


@njit(cache=True, forceinline=True)
def _hop_is_not_zero(speedup, levels, height):
    """Whether the wind carries a slab from this height at all."""
    if speedup is None:
        return True
    return hop_cells(height, levels, speedup) != 0.0


@njit(cache=True, forceinline=True)
def _erodes_outside_shadow(ray, axis, grid, wind, erodes, heights, row, col, here, peak):
    """Whether a cell that would erode lies outside the shadow zone, where that matters."""
    if wind.lee_erosion:
        return erodes
    if ray is not None:
        if not erodes:
            return False
    return not in_shadow(heights, row, col, here, peak, grid, axis, ray) and erodes


@njit(cache=True, forceinline=True)
def _may_erode(stacks, rules, heights, row, col, state, peak):
    """Whether a polled cell gives a slab, and the random state after it was asked."""
    cell = np.uint64(row * rules.grid.cols + col)
    here = stacks.surface[cell]
    erodes = has_sand(stacks.surface, stacks.sand, cell)
    allowed, state = _chance_allows(stacks.mobility, cell, rules.wind, state)
    erodes &= allowed
    erodes &= _hop_is_not_zero(rules.speedup, stacks.levels, here)
    erodes = _erodes_outside_shadow(
        rules.ray, rules.axis, rules.grid, rules.wind, erodes, heights, row, col, here, peak
    )
    return erodes, state


@njit(cache=True)
def find_eroding_cell(stacks, rules, heights, band, row, col, state, peak):
    """Look for a cell that may erode: at random within the band, then onwards through the lattice.

    Returns its row (negative where none is left), column and the advanced random state.
    """
    never_inline()
    stacks, rules = lent((stacks, rules))
    grid = rules.grid
    for attempt in range(FORCED_TRIES + grid.rows * grid.cols):
        if attempt < FORCED_TRIES:
            state += GOLDEN
            draw = mix(state)
            col = below(high(draw), grid.cols)
            row = band.first_row + below(low(draw), band.rows)
        else:
            col += 1
            if col == grid.cols:
                col = 0
                row = row + 1 if row + 1 < grid.rows else 0
        erodes, state = _may_erode(stacks, rules, heights, row, col, state, peak)
        if erodes:
            return row, col, state
    return -1, col, state


@njit(cache=True, forceinline=True)
def _change(stacks, sand, cell, slab, count):
    """Change a cell's stack by ``count`` slabs; returns its new height."""
    before = np.int64(stacks.surface[cell])
    move_level(stacks.levels, before, before + slab * count)
    stacks.surface[cell] += slab * count
    if sand is not None:
        sand[cell] += count
    return before + slab * count


@njit(cache=True)
def _relax_about(stacks, orders, unstable, row, col, key, grid, repose):
    """Relax the slopes about a cell until every one stands."""
    never_inline()
    length = enqueue(unstable, row * grid.cols + col, CHECKED, 0, 0)
    length = enqueue_about(unstable, row, col, 0, 0, length, grid)
    relax_queue(stacks, orders, unstable, length, key, grid, repose, None)


@njit(cache=True, forceinline=True)
def _is_too_steep(stacks, orders, order, row, col, sign, grid, repose):
    """Whether a step up (``sign`` 1) or down (-1) from a cell exceeds the static limit."""
    here = np.int64(stacks.surface[row * grid.cols + col])
    return steepest(stacks, orders, order, row, col, here, sign, True, grid, repose) != STABLE


@njit(cache=True, forceinline=True)
def pull_in(unstable, stacks, rules, row, col, state):
    """Take a slab from a cell and let the slope above it feed the cell; returns the random state.

    Slabs slide before the cell changes, or as an avalanche afterwards where there is a static limit.
    """
    grid, repose = rules.grid, rules.repose
    if unstable is None:
        row, col, state = end_of_slope(stacks, rules.orders, UPSLOPE, row, col, state, 1, grid, repose)
    _change(stacks, stacks.sand, np.uint64(row * grid.cols + col), repose.slab, -1)
    if unstable is not None:
        state += GOLDEN
        if _is_too_steep(stacks, rules.orders, UPSLOPE, row, col, 1, grid, repose):
            _relax_about(stacks, rules.relaxation_orders, unstable, row, col, mix(state), grid, repose)
    return state


@njit(cache=True, forceinline=True)
def lay_down(unstable, stacks, rules, row, col, state):
    """Lay a slab on a cell and let it slide down the slope; returns the height of the cell that it raises."""
    grid, repose = rules.grid, rules.repose
    if unstable is None:
        row, col, state = end_of_slope(stacks, rules.orders, DOWNSLOPE, row, col, state, -1, grid, repose)
    height = _change(stacks, stacks.sand, np.uint64(row * grid.cols + col), repose.slab, 1)
    if unstable is not None:
        state += GOLDEN
        if _is_too_steep(stacks, rules.orders, DOWNSLOPE, row, col, -1, grid, repose):
            _relax_about(stacks, rules.relaxation_orders, unstable, row, col, mix(state), grid, repose)
    return height


@njit(cache=True, forceinline=True)
def _first_hop(speedup, levels, wind, height):
    """The hop from a cell of this height, along and across, in 1/``CELL`` cells."""
    if speedup is None:
        return wind.hop_along, wind.hop_across
    hop = hop_cells(height, levels, speedup)
    return fixed_hop(hop, wind.unit_along), fixed_hop(hop, wind.unit_across)


@njit(cache=True, forceinline=True)
def next_hop(speedup, levels, wind, height, hop_along, hop_across, stays):
    """The hop from where a slab landed, and whether it stays there because that hop is zero."""
    if speedup is not None:
        if speedup.every_hop and not stays:
            hop = hop_cells(height, levels, speedup)
            hop_along = fixed_hop(hop, wind.unit_along)
            hop_across = fixed_hop(hop, wind.unit_across)
            stays = hop == 0.0
    return hop_along, hop_across, stays


@njit(cache=True, forceinline=True)
def has_fractions(speedup, hop_along, hop_across):
    """Whether hops may end between cells, so that slabs start anywhere within theirs."""
    fractions = (hop_along | hop_across) & (CELL - 1) != 0
    if speedup is not None:
        fractions |= not speedup.whole
    return fractions


@njit(cache=True, forceinline=True)
def hop_once(obstacles, surface, sand, heights, along, across, hop_along, hop_across, grid, repose):
    """One hop: the new position (negative: left the field), the distance, and whether a wall stopped it."""
    if obstacles is not None:
        if not way_is_clear(heights, along, across, hop_along, hop_across, grid, obstacles):
            return hop_until_blocked(
                surface, sand, along, across, hop_along, hop_across, grid, repose, obstacles
            )
    along = wrapped(along + hop_along, grid.cols, grid.wrap_along)
    if hop_across != 0:
        across = wrapped(across + hop_across, grid.rows, grid.wrap_across)
    return along, across, hop_along, hop_across, False


@njit(cache=True, forceinline=True)
def sticks(mobility, sandy, wind, cell, chance):
    """Whether the chance of deposition holds a slab where it landed."""
    deposit = wind.deposit_on_sand if sandy else wind.deposit_on_ground
    if mobility is None:
        return chance < deposit
    hops_on = (_ALL - np.int64(deposit)) * np.int64(mobility[cell]) // MOBILE
    return np.int64(chance) < _ALL - hops_on


@njit(cache=True, forceinline=True)
def sticks_in_shadow(axis, ray, grid, sticks, heights, row, col, here, peak):
    """Whether a slab stays where it landed, by chance or because it landed in shadow.

    The test along an axis is so short that it is made in any case: there is no branch to mispredict.
    """
    if axis is None:
        if sticks:
            return True
    return sticks | in_shadow(heights, row, col, here, peak, grid, axis, ray)


@njit(cache=True, forceinline=True)
def carry(stacks, rules, heights, row, col, hop_along, hop_across, state, peak):
    """Carry a slab from a cell, hop by hop, until it stays or leaves the field.

    Returns its last row and column, the random state, whether it is still in the field, whether it stays by
    itself and not because of ``max_hops``, and the distances travelled in 1/``TRAVEL_UNIT`` cells.
    """
    wind, grid = rules.wind, rules.grid
    surface, sand = stacks.surface, stacks.sand
    along = col << 32
    across = row << 32
    if has_fractions(rules.speedup, hop_along, hop_across):
        state += GOLDEN
        draw = mix(state)
        along |= np.int64(high(draw))
        across |= np.int64(low(draw))
    travel_along = np.int64(0)
    travel_across = np.int64(0)
    hops = 0
    ends = False
    stays = False
    while not ends:
        # 4 hop
        hops += 1
        along, across, hopped_along, hopped_across, stopped = hop_once(
            rules.obstacles, surface, sand, heights, along, across, hop_along, hop_across, grid, rules.repose
        )
        travel_along += hopped_along >> 16
        travel_across += hopped_across >> 16
        if along < 0 or across < 0:
            return row, col, state, False, False, travel_along, travel_across
        row = across >> 32
        col = along >> 32
        # 5 settle?
        state += GOLDEN
        cell = np.uint64(row * grid.cols + col)
        here = surface[cell]
        sandy = has_sand(surface, sand, cell)
        stays = sticks(stacks.mobility, sandy, wind, cell, high(mix(state))) | stopped
        stays = sticks_in_shadow(rules.axis, rules.ray, grid, stays, heights, row, col, here, peak)
        hop_along, hop_across, stays = next_hop(
            rules.speedup, stacks.levels, wind, here, hop_along, hop_across, stays
        )
        ends = stays | (hops == wind.max_hops)
    return row, col, state, True, stays, travel_along, travel_across


@njit(cache=True)
def run_polls(stacks, rules, work, band, count, redraw, target, peak, tally):
    """Run ``count`` prepared polls, one after the other, until ``target`` slabs have moved in all.

    With ``redraw`` a cell that may not erode is replaced by one that may. Returns a height that no cell
    exceeds now.
    """
    never_inline()
    stacks, rules, work = lent((stacks, rules, work))
    heights = stacks.surface.ctypes.data
    polls, unstable = work.polls, work.unstable
    moved = tally[MOVED]
    left = 0
    capped = 0
    travel_along = np.int64(0)
    travel_across = np.int64(0)
    for k in range(count):
        # 1 choose a cell
        row, col, state = polls.rows[np.uint64(k)], polls.cols[np.uint64(k)], polls.states[np.uint64(k)]
        # 2 may it erode?
        erodes, state = _may_erode(stacks, rules, heights, row, col, state, peak)
        if not erodes:
            if not redraw:
                continue
            row, col, state = find_eroding_cell(stacks, rules, heights, band, row, col, state, peak)
            if row < 0:
                tally[EXHAUSTED] += 1
                break
        moved += 1
        height = stacks.surface[np.uint64(row * rules.grid.cols + col)]
        hop_along, hop_across = _first_hop(rules.speedup, stacks.levels, rules.wind, height)
        # 3 take the slab
        state = pull_in(unstable, stacks, rules, row, col, state)
        # 4 hop, 5 settle?
        row, col, state, inside, stays, way_along, way_across = carry(
            stacks, rules, heights, row, col, hop_along, hop_across, state, peak
        )
        travel_along += way_along
        travel_across += way_across
        # 6 lay it down
        if inside:
            capped += not stays
            peak = max(peak, lay_down(unstable, stacks, rules, row, col, state))
        else:
            left += 1
        if moved == target:
            break
    tally[MOVED] = moved
    tally[LEFT] += left
    tally[CAPPED] += capped
    tally[TRAVEL_ALONG] += travel_along
    tally[TRAVEL_ACROSS] += travel_across
    return peak
