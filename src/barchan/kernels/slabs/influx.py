"""Influx: slabs that the wind brings in across open edges, by rules 4 to 6 of ``docs/slabs.md``.

A slab starts its first hop anywhere within a hop's length upwind of the edge, so the first landings are
spread evenly over the hop's length within the field, as they are on a bed that goes on upwind.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.levels import measure_levels
from barchan.kernels.bed.slopes import has_sand
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.random import derive, draw, high, mix
from barchan.kernels.slabs.carry import (
    has_fractions,
    hop_once,
    next_hop,
    sticks_by_chance,
    sticks_in_shadow,
)
from barchan.kernels.slabs.hexagons import MIDDLE, ROW, cell_about, position
from barchan.kernels.slabs.hop import wrapped
from barchan.kernels.slabs.poll import lay_down
from barchan.kernels.slabs.shadow import whole_view
from barchan.kernels.slabs.state import CAPPED, CELL, ENTERED, LEFT, TRAVEL_ACROSS, TRAVEL_ALONG

_ALONG, _ACROSS = range(2)
"""Numbers of the random sequences of the two edges."""


@njit(cache=True)
def _bring_in(stacks, rules, work, along, across, state, peak, tally):
    """Carry a slab from where it first lands until it stays or leaves; returns a height no cell exceeds."""
    view = whole_view(stacks.surface.ctypes.data, rules.grid)
    wind, grid, surface, sand = rules.wind, rules.grid, stacks.surface, stacks.sand
    hop_along, hop_across = wind.hop_along, wind.hop_across
    tally[ENTERED] += 1
    stopped = False
    hops = 1
    while along >= 0 and across >= 0:
        # 5 settle?
        row = across >> 32
        col = along >> 32
        state = mix(state + np.uint64(hops))
        cell = np.uint64(row * grid.cols + col)
        here = surface[cell]
        sandy = has_sand(surface, sand, cell)
        stays = sticks_by_chance(stacks.mobility, sandy, wind, cell, high(state)) | stopped
        stays = sticks_in_shadow(
            rules.axis, rules.ray, rules.box, grid, stays, view, along, across, here, peak
        )
        hop_along, hop_across, stays = next_hop(
            rules.speedup, stacks.levels, wind, here, hop_along, hop_across, stays
        )
        if stays or hops == wind.max_hops:
            # 6 lay it down
            tally[CAPPED] += not stays
            return max(peak, lay_down(work.unstable, stacks, rules, row, col, state))
        # 4 hop
        hops += 1
        along, across, hopped_along, hopped_across, stopped = hop_once(
            rules.obstacles, surface, sand, view, along, across, hop_along, hop_across, grid, rules.repose
        )
        tally[TRAVEL_ALONG] += hopped_along >> 16
        tally[TRAVEL_ACROSS] += hopped_across >> 16
    tally[LEFT] += 1
    return peak


@njit(cache=True)
def _landing_on_hexagons(edge, cell, along, across, place, rules):
    """``first_landing`` for a slab that comes down ``along`` and ``across`` from a place of the edge's cell.

    The edge is taken for straight; what comes down in a gap of the real one comes down on the cell beside it.
    """
    wind, grid = rules.wind, rules.grid
    if edge == _ALONG:
        middle = MIDDLE if place == 0 else (CELL >> 3) + (place * 3 >> 2)
        along += (cell & 1) << 31
        row, col, beside, above = cell_about(along, across + cell * ROW + middle)
        return position(row, max(col, 0), beside, above, grid)
    falls = wind.hop_across < 0
    along += (cell << 32) + (place if place != 0 else MIDDLE) + (MIDDLE if falls else 0)
    across += (CELL >> 3) + (grid.rows * ROW - 1 if falls else 0)
    row, col, beside, above = cell_about(along, across)
    row = min(row, grid.rows - 1) if falls else max(row, 0)
    return position(row, col, beside, above, grid)


@njit(cache=True)
def first_landing(edge, cell, state, rules):
    """Where a slab first lands that enters at a cell of one of the two upwind edges (fixed-point cells)."""
    wind, grid = rules.wind, rules.grid
    inside = draw(state, 1)
    along = np.int64(inside * wind.hop_along)
    across = np.int64(inside * wind.hop_across)
    place = np.int64(0)
    if rules.box is not None or has_fractions(rules.speedup, wind.hop_along, wind.hop_across):
        place = np.int64(draw(state, 2) * CELL)
    if grid.hexagonal:
        return _landing_on_hexagons(edge, cell, along, across, place, rules)
    if edge == _ALONG:
        along = wrapped(along, grid.cols, False)
        return along, wrapped(across + (cell << 32) + place, grid.rows, grid.wrap_across)
    if wind.hop_across < 0:
        across += (grid.rows << 32) - 1
    along = wrapped(along + (cell << 32) + place, grid.cols, grid.wrap_along)
    return along, wrapped(across, grid.rows, False)


@njit(cache=True, nogil=True)
def let_enter(stacks, rules, work, influx, key, tally):
    """Let a step's slabs enter, cell by cell along the upwind edges; counts are added to ``tally``.

    ``influx`` holds the mean number for each cell of the edge across the columns' axis, and of the edge along
    it; a number is rounded up or down at random so that its mean is exact.
    """
    stacks, rules, work, influx = borrowed((stacks, rules, work, influx))
    peak = np.int64(stacks.surface.max())
    measure_levels(stacks.surface, stacks.levels)
    for edge in range(2):
        means = influx.along if edge == _ALONG else influx.across
        for cell in range(means.size):
            start = derive(derive(key, edge), cell)
            count = np.int64(means[cell] + draw(start, 1))
            for number in range(count):
                if rules.interruption[0] != 0:
                    return
                state = derive(start, number + 1)
                along, across = first_landing(edge, cell, state, rules)
                peak = _bring_in(stacks, rules, work, along, across, state, peak, tally)
