"""Rules 4 and 5 of a poll (``docs/slabs.md``): a slab hops on until it is deposited or leaves the field.

Rules that a model does without are None, and the compiler leaves them out: it can tell only where the rule is
an argument of its own, so functions take an optional rule first.
"""

import numpy as np

from barchan.kernels.bed.slopes import has_sand
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import GOLDEN, high, low, mix
from barchan.kernels.slabs.hexagons import MIDDLE, cell_after, place_within
from barchan.kernels.slabs.hop import after_hop, fixed_hop, hop_cells
from barchan.kernels.slabs.obstacles import hop_until_blocked, way_is_clear
from barchan.kernels.slabs.shadow import in_shadow
from barchan.kernels.slabs.state import CELL, MOBILE

HOPS, STAYS, IS_CAPPED, LEAVES, HOPS_FAR = range(5)
"""Fates of a slab in flight: it hops on, stays by itself, stays because of ``max_hops``, leaves the field, or
its next hop leads beyond the near rows."""

_ALL = 1 << 32
"""A chance of one."""

_LOOK = (1 << 12) - 1
"""Hops of a slab after which it is asked whether the work is to be broken off, less one."""


@internal(forceinline=True)
def first_hop(speedup, levels, wind, height):
    """The hop from a cell of this height, along and across, in 1/``CELL`` cells."""
    if speedup is None:
        return wind.hop_along, wind.hop_across
    hop = hop_cells(height, levels, speedup)
    return fixed_hop(hop, wind.unit_along), fixed_hop(hop, wind.unit_across)


@internal(forceinline=True)
def next_hop(speedup, levels, wind, height, hop_along, hop_across, stays):
    """The hop from where a slab landed, and whether it stays there because that hop is zero."""
    if speedup is not None:
        if speedup.every_hop and not stays:
            hop = hop_cells(height, levels, speedup)
            hop_along = fixed_hop(hop, wind.unit_along)
            hop_across = fixed_hop(hop, wind.unit_across)
            stays = hop == 0.0
    return hop_along, hop_across, stays


@internal(forceinline=True)
def has_fractions(speedup, hop_along, hop_across):
    """Whether hops may end between cells, so that slabs start anywhere within theirs."""
    fractions = (hop_along | hop_across) & (CELL - 1) != 0
    if speedup is not None:
        fractions |= not speedup.whole
    return fractions


@internal(forceinline=True)
def hop_once(obstacles, surface, sand, view, along, across, hop_along, hop_across, grid, repose):
    """One hop: the new position (negative: left the field), the distance, and whether a wall stopped it."""
    if obstacles is not None:
        if not way_is_clear(view.now, along, across, hop_along, hop_across, grid, obstacles):
            return hop_until_blocked(
                surface, sand, along, across, hop_along, hop_across, grid, repose, obstacles
            )
    along, across = after_hop(along, across, hop_along, hop_across, grid)
    return along, across, hop_along, hop_across, False


@internal(forceinline=True)
def sticks_by_chance(mobility, sandy, wind, cell, chance):
    """Whether the chance of deposition holds a slab where it landed."""
    deposit = wind.deposit_on_sand if sandy else wind.deposit_on_ground
    if mobility is None:
        return chance < deposit
    hops_on = (_ALL - np.int64(deposit)) * np.int64(mobility[cell]) // MOBILE
    return np.int64(chance) < _ALL - hops_on


@internal(forceinline=True)
def sticks_in_shadow(axis, ray, box, grid, sticks, view, along, across, here, peak):
    """Whether a slab stays where it landed, by chance or because it landed in shadow."""
    return sticks or in_shadow(view, along, across, here, peak, grid, axis, ray, box)


@internal(forceinline=True)
def take_off(box, speedup, along, across, hop_along, hop_across, state, grid):
    """Where a slab starts, in 1/``CELL`` cells, and the random state; without a place yet it draws one."""
    if box is None:
        beside = above = MIDDLE if grid.hexagonal else 0
        if has_fractions(speedup, hop_along, hop_across):
            state += GOLDEN
            draw = mix(state)
            beside = np.int64(high(draw))
            above = np.int64(low(draw))
            if grid.hexagonal:
                beside, above = place_within(beside, above)
        along |= beside
        across |= above
    return along, across, state


@internal(forceinline=True)
def _goes_far(ray, view, along, across, hop_along, hop_across, grid):
    """Whether a hop leads beyond the near rows; along an axis it never does."""
    if ray is None:
        return False
    near = view.near
    if grid.hexagonal:
        row, _, _, _ = cell_after(along, across, hop_along, hop_across)
        row -= near.first
        row += grid.rows if across >> 32 < near.first else 0
        return (row < 0 or row >= near.number) and near.number < grid.rows
    there = across - (near.first << 32)
    there += grid.rows << 32 if there < 0 else 0
    there += hop_across
    return (there < 0 or there >= near.number << 32) and near.number < grid.rows


@internal(forceinline=True)
def carry(stacks, rules, view, along, across, hop_along, hop_across, state, hops, peak):
    """Carry a slab on from a position, hop by hop, until it stays, leaves the field or would hop far.

    Returns its position, the next hop, the random state, the number of hops, the slab's fate (``STAYS``,
    ``IS_CAPPED``, ``LEAVES`` or ``HOPS_FAR``) and the distances travelled in 1/``TRAVEL_UNIT`` cells.
    """
    wind, grid = rules.wind, rules.grid
    surface, sand = stacks.surface, stacks.sand
    travel_along = np.int64(0)
    travel_across = np.int64(0)
    fate = HOPS
    while fate == HOPS:
        if _goes_far(rules.ray, view, along, across, hop_along, hop_across, grid):
            fate = HOPS_FAR
            break
        # 4 hop
        hops += 1
        along, across, hopped_along, hopped_across, stopped = hop_once(
            rules.obstacles, surface, sand, view, along, across, hop_along, hop_across, grid, rules.repose
        )
        travel_along += hopped_along >> 16
        travel_across += hopped_across >> 16
        if along < 0 or across < 0:
            fate = LEAVES
            break
        row = across >> 32
        col = along >> 32
        # 5 settle?
        state += GOLDEN
        cell = np.uint64(row * grid.cols + col)
        here = surface[cell]
        sandy = has_sand(surface, sand, cell)
        stays = sticks_by_chance(stacks.mobility, sandy, wind, cell, high(mix(state))) | stopped
        stays = sticks_in_shadow(
            rules.axis, rules.ray, rules.box, grid, stays, view, along, across, here, peak
        )
        hop_along, hop_across, stays = next_hop(
            rules.speedup, stacks.levels, wind, here, hop_along, hop_across, stays
        )
        ends = stays | (hops == wind.max_hops)
        if hops & _LOOK == 0:
            ends |= rules.interruption[0] != 0
        if ends:
            fate = STAYS if stays else IS_CAPPED
    return along, across, hop_along, hop_across, state, hops, fate, travel_along, travel_across
