"""Rules 1 and 2 of a poll (``docs/slabs.md``): whether a cell may erode, and the search for one that may.

Rules that a model does without are None, and the compiler leaves them out: it can tell only where the rule is
an argument of its own, so functions take an optional rule first.
"""

import numpy as np

from barchan.kernels.bed.slopes import has_sand
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import GOLDEN, below, high, low, mix
from barchan.kernels.slabs.hexagons import place_within
from barchan.kernels.slabs.hop import hop_cells
from barchan.kernels.slabs.shadow import in_shadow
from barchan.kernels.slabs.state import MOBILE

FORCED_TRIES = 1000
"""Cells that a forced poll draws before it walks on through the lattice in order."""


@internal(forceinline=True)
def _chance_allows(mobility, cell, wind, state):
    """Whether the chance of erosion lets a slab go, and the random state after it was drawn."""
    if mobility is None:
        return True, state
    state += GOLDEN
    chance = np.int64(mobility[cell]) * wind.erosion_factor // MOBILE + wind.erosion_offset
    return np.int64(high(mix(state))) < chance, state


@internal(forceinline=True)
def _hop_is_not_zero(speedup, levels, height):
    """Whether the wind carries a slab from this height at all."""
    if speedup is None:
        return True
    return hop_cells(height, levels, speedup) != 0.0


@internal(forceinline=True)
def _erodes_outside_shadow(ray, axis, box, grid, wind, erodes, view, along, across, here, peak):
    """Whether a cell that would erode lies outside the shadow zone, where that matters."""
    if wind.lee_erosion:
        return erodes
    if ray is not None:
        if not erodes:
            return False
    return not in_shadow(view, along, across, here, peak, grid, axis, ray, box) and erodes


@internal(forceinline=True)
def _spread(hexagons, beside, above):
    """A place within a cell, all equally likely, from two random numbers of 32 bits."""
    if hexagons is not None:
        return place_within(beside, above)
    return beside, above


@internal(forceinline=True)
def place_in_cell(box, row, col, state):
    """Where in a cell its topmost slab lies (fixed-point cells), and the random state.

    It is drawn where shadow lines ask for it; otherwise it is the cell's corner, which stands for the cell.
    """
    along = col << 32
    across = row << 32
    if box is not None:
        state += GOLDEN
        draw = mix(state)
        beside, above = _spread(box.hexagons, np.int64(high(draw)), np.int64(low(draw)))
        along |= beside
        across |= above
    return along, across, state


@internal(forceinline=True)
def may_erode(stacks, rules, view, row, col, state, peak):
    """Whether a polled cell gives a slab, where in the cell that lies, and the random state afterwards."""
    along, across, state = place_in_cell(rules.box, row, col, state)
    cell = np.uint64(row * rules.grid.cols + col)
    here = stacks.surface[cell]
    erodes = has_sand(stacks.surface, stacks.sand, cell)
    allowed, state = _chance_allows(stacks.mobility, cell, rules.wind, state)
    erodes &= allowed
    erodes &= _hop_is_not_zero(rules.speedup, stacks.levels, here)
    erodes = _erodes_outside_shadow(
        *(rules.ray, rules.axis, rules.box, rules.grid, rules.wind, erodes),
        *(view, along, across, here, peak),
    )
    return erodes, along, across, state


@internal()
def find_eroding_cell(stacks, rules, view, band, row, col, state, peak):
    """Look for a cell that may erode: at random within the band, then onwards through the lattice.

    Returns the place of its slab (negative where none is left) and the advanced random state.
    """
    stacks, rules = borrowed((stacks, rules))
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
                if rules.interruption[0] != 0:
                    break
        erodes, along, across, state = may_erode(stacks, rules, view, row, col, state, peak)
        if erodes:
            return along, across, state
    return np.int64(-1), np.int64(-1), state
