"""Polls of snow: may a cell give a quantum, where is it carried, and where does it come to rest.

The rules are numbered as in ``docs/snow.md``. Everything is done in the wind's frame, on flat arrays of whole
numbers; with all closures off the same random numbers are drawn for the same questions as for slabs of sand.
"""

import math

import numpy as np

from barchan.kernels.bed.grid import neighbour
from barchan.kernels.bed.state import (
    EAST,
    NORTH,
    NORTHEAST,
    NORTHWEST,
    SOUTH,
    SOUTHEAST,
    SOUTHWEST,
    WEST,
)
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import GOLDEN, below, high, low, mix
from barchan.kernels.slabs.carry import take_off
from barchan.kernels.slabs.erosion import place_in_cell
from barchan.kernels.slabs.hop import wrapped
from barchan.kernels.slabs.shadow import in_shadow, is_near, whole_view
from barchan.kernels.slabs.state import CAPPED, LEFT, MOVED, STRAYED, TRAVEL_ACROSS, TRAVEL_ALONG
from barchan.kernels.snow.layers import pop, state_class
from barchan.kernels.snow.slopes import feed, lay_down
from barchan.kernels.snow.state import UPWIND

_ROOT_OF_TWO = math.sqrt(2.0)

_ALL = 1 << 32
"""A chance of one."""

_AXES, _TIE = np.uint64(1), np.uint64(2)
"""Bits that choose an axis, and one of two neighbours that are equally low."""

_AROUND = np.array([EAST, NORTHEAST, NORTH, NORTHWEST, WEST, SOUTHWEST, SOUTH, SOUTHEAST])
"""Directions of the neighbours, anticlockwise, in the wind's frame."""

_ASIDE = np.array([-1, 1, -2, 2])
"""Places in ``_AROUND`` from the upwind cell to those upwind to either side, and to those beside."""


@internal()
def exposure(giving, pack, grid, row, col, here, state):
    """How far (0 to 1) a cell stands out of the bed upwind, over the saltation layer's height.

    Grains do not come along one line: of twenty comparisons sixteen are with the cell upwind, one each with
    those upwind to either side and beside it. Under oblique winds the cell upwind is now the one along the
    axis and now the one at the corner, so that the mean direction is the wind's.
    """
    pack = borrowed(pack)
    draw = mix(state)
    place = UPWIND if np.int64(low(draw)) >= giving.oblique else giving.corner
    side = below(high(draw), 20)
    if side < _ASIDE.size:
        place = (place + _ASIDE[side]) & 7
    r, c = neighbour(row, col, _AROUND[place], grid)
    rise = np.int64(here) - np.int64(pack.surface[np.uint64(r * grid.cols + c)])
    return min(max(rise, 0), giving.exposure_height) / giving.exposure_height


@internal(forceinline=True)
def _chance_allows(giving, stress, pack, rules, row, col, cell, here, state):
    """Whether the wind's excess over the threshold, or abrasion, takes a quantum; the random state."""
    if giving is None:
        return True, state
    state += GOLDEN
    kind = state_class(pack.top[cell], rules.epoch, rules.tables.age_class)
    felt = np.float64(1.0)
    if stress is not None:
        felt = np.float64(stress[cell])
    excess = felt - np.float64(rules.tables.threshold[kind])
    if giving.spread > 0.0:
        gentler = np.float64(rules.tables.threshold[kind]) ** giving.power
        excess = 0.5 * math.erfc((gentler - felt**giving.power) / (giving.spread * _ROOT_OF_TWO))
    chance = max(excess, 0.0) * np.float64(rules.tables.yields[kind])
    draw = np.float64(high(mix(state))) * 2.0**-32
    if giving.abrades:
        wears = np.float64(rules.tables.wears[kind])
        if wears > 0.0 and draw < chance + wears:
            chance += wears * exposure(giving, pack, rules.slabs.grid, row, col, here, state + GOLDEN)
        state += GOLDEN
    return draw < chance, state


@internal(forceinline=True)
def may_give(pack, rules, view, row, col, state, peak):
    """Whether a polled cell gives a quantum, where in the cell that lies, and the random state afterwards."""
    slabs = rules.slabs
    along, across, state = place_in_cell(slabs.box, row, col, state)
    cell = np.uint64(row * slabs.grid.cols + col)
    here = pack.surface[cell]
    gives = pack.quanta[cell] > 0
    if gives:
        allowed, state = _chance_allows(rules.giving, rules.stress, pack, rules, row, col, cell, here, state)
        gives = allowed and not in_shadow(
            view, along, across, here, peak, slabs.grid, slabs.axis, slabs.ray, slabs.box
        )
    return gives, along, across, state


@internal(forceinline=True)
def _stays_by_chance(stress, pack, rules, cell, chance):
    """Whether a quantum comes to rest where it landed: the more likely the weaker the stress there."""
    wind = rules.slabs.wind
    deposit = wind.deposit_on_ground
    if pack.quanta[cell] > 0:
        kind = state_class(pack.top[cell], rules.epoch, rules.tables.age_class)
        if rules.tables.bonded[kind] == 0:
            deposit = wind.deposit_on_sand
    if stress is None:
        return chance < deposit
    excess = (np.float64(stress[cell]) - rules.impact_threshold) / (1.0 - rules.impact_threshold)
    goes_on = np.float64(_ALL - np.int64(deposit)) * min(max(excess, 0.0), 1.0)
    return np.int64(chance) < _ALL - np.int64(goes_on)


@internal(forceinline=True)
def carry(pack, rules, view, along, across, travelled, state, peak):
    """Carry a quantum hop by hop until it rests or leaves the field.

    ``travelled`` says whether it has just come down from a first hop. Returns its last row and column, the
    random state, whether it is still in the field, whether it stays by itself, whether it lies in shadow, and
    the distances travelled.
    """
    slabs = rules.slabs
    grid, wind = slabs.grid, slabs.wind
    way_along, way_across = np.int64(0), np.int64(0)
    row, col = across >> 32, along >> 32
    hops, stays, sheltered = 0, False, False
    while not stays and hops < wind.max_hops and slabs.interruption[0] == 0:
        if hops > 0 or not travelled:
            along = wrapped(along + wind.hop_along, grid.cols, grid.wrap_along)
            if wind.hop_across != 0:
                across = wrapped(across + wind.hop_across, grid.rows, grid.wrap_across)
            way_along += wind.hop_along >> 16
            way_across += wind.hop_across >> 16
        hops += 1
        if along < 0 or across < 0:
            return row, col, state, False, False, False, way_along, way_across
        row, col = across >> 32, along >> 32
        state += GOLDEN
        cell = np.uint64(row * grid.cols + col)
        here = pack.surface[cell]
        sheltered = in_shadow(view, along, across, here, peak, grid, slabs.axis, slabs.ray, slabs.box)
        stays = sheltered or _stays_by_chance(rules.stress, pack, rules, cell, high(mix(state)))
    return row, col, state, True, stays, sheltered, way_along, way_across


@internal()
def _pushed(creep, pack, grid, touched, row, col, state):
    """The cell where a quantum lies after it was pushed down the slope, cell by cell.

    It ends at the first row that is not among those that may be ``touched``.

    It is pushed along one of the axes, chosen at random each time, towards the lower neighbour; the mean
    number of pushes down an even slope is the drop to a neighbour times ``per_height``.
    """
    left = np.float64(0.0)
    while True:
        state += GOLDEN
        draw = mix(state)
        direction = np.int64(low(draw) & _AXES)
        r, c = neighbour(row, col, direction, grid)
        other_r, other_c = neighbour(row, col, direction + 2, grid)
        there = np.int64(pack.surface[np.uint64(r * grid.cols + c)])
        other = np.int64(pack.surface[np.uint64(other_r * grid.cols + other_c)])
        if other < there or (other == there and low(draw) & _TIE != 0):
            r, c, there = other_r, other_c, other
        drop = np.int64(pack.surface[np.uint64(row * grid.cols + col)]) - there
        if drop <= 0 or high(draw) * 2.0**-32 >= drop * creep.per_height + left:
            return row, col, state
        row, col = r, c
        if not is_near(row, touched, grid):
            return row, col, state
        left -= 1.0


@internal(forceinline=True)
def _roll(creep, pack, grid, touched, row, col, sheltered, state):
    """The cell where a quantum lies after it has rolled, by chance, to a lower face neighbour."""
    if creep is None:
        return row, col, state
    if creep.by_slope:
        # no grains strike the bed in shadow, where the flow has come off
        if sheltered:
            return row, col, state
        return _pushed(creep, pack, grid, touched, row, col, state)
    state += GOLDEN
    if np.int64(high(mix(state))) >= creep.chance:
        return row, col, state
    lowest = pack.surface[np.uint64(row * grid.cols + col)]
    to_row, to_col = row, col
    for direction in range(4):
        r, c = neighbour(row, col, direction, grid)
        there = pack.surface[np.uint64(r * grid.cols + c)]
        if there < lowest:
            lowest, to_row, to_col = there, r, c
    return to_row, to_col, state


@internal(forceinline=True)
def settle(pack, rules, touched, row, col, sheltered, state):
    """Let a quantum that has landed roll, slide and lie; returns the height that it reaches.

    Returns ``STRAYED`` instead, with nothing changed, where it comes to a row that is not among those that
    may be ``touched``.
    """
    grid = rules.slabs.grid
    row, col, state = _roll(rules.creep, pack, grid, touched, row, col, sheltered, state)
    if not is_near(row, touched, grid):
        return np.int64(STRAYED)
    return lay_down(pack, rules, touched, row, col, rules.density)


@internal()
def run_polls(pack, rules, work, band, count, peak, tally):
    """Run ``count`` prepared polls of a band, one after the other; returns a height that no cell exceeds now.

    Or, with polls left undone, ``STRAYED`` before one changes a row that it may not touch.
    """
    never_inline()
    pack, rules, work = borrowed((pack, rules, work))
    view = whole_view(pack.surface.ctypes.data, rules.slabs.grid)
    grid, wind, polls, touched = rules.slabs.grid, rules.slabs.wind, work.polls, band.touched
    moved = left = capped = 0
    travel_along, travel_across = np.int64(0), np.int64(0)
    for k in range(count):
        # 1 choose a cell
        row, col, state = polls.rows[np.uint64(k)], polls.cols[np.uint64(k)], polls.states[np.uint64(k)]
        # 2 does it give a quantum?
        gives, along, across, state = may_give(pack, rules, view, row, col, state, peak)
        if not gives:
            continue
        moved += 1
        # 3 take it, and let the slope above feed its cell
        pop(pack, rules.tables.thickness, np.uint64(row * grid.cols + col))
        height = feed(pack, rules, touched, row, col)
        if height < 0:
            return height
        peak = max(peak, height)
        # 4 hop, 5 rest?
        along, across, state = take_off(
            rules.slabs.box, None, along, across, wind.hop_along, wind.hop_across, state, grid
        )
        row, col, state, inside, stays, sheltered, way_along, way_across = carry(
            pack, rules, view, along, across, False, state, peak
        )
        travel_along += way_along
        travel_across += way_across
        if not inside:
            left += 1
            continue
        # 6 roll, slide, and lie there as drift
        capped += not stays
        height = settle(pack, rules, touched, row, col, sheltered, state)
        if height < 0:
            return height
        peak = max(peak, height)
    tally[MOVED] += moved
    tally[LEFT] += left
    tally[CAPPED] += capped
    tally[TRAVEL_ALONG] += travel_along
    tally[TRAVEL_ACROSS] += travel_across
    return peak
