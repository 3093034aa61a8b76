"""Slabs that hopped far land when all polls of their round are done, in the order of their polls."""

import numpy as np

from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.slabs.carry import IS_CAPPED, LEAVES, carry
from barchan.kernels.slabs.poll import lay_down
from barchan.kernels.slabs.shadow import whole_view
from barchan.kernels.slabs.state import CAPPED, LEFT, NO_SLAB, TRAVEL_ACROSS, TRAVEL_ALONG


@internal()
def _land(stacks, rules, work, slab, peak, tally):
    """Carry one slab on to its end; returns a height that no cell exceeds now."""
    never_inline()
    view = whole_view(stacks.surface.ctypes.data, rules.grid)
    along, across, _, _, state, _, fate, way_along, way_across = carry(
        stacks, rules, view, slab[1], slab[2], slab[3], slab[4], np.uint64(slab[5]), slab[6], peak
    )
    tally[TRAVEL_ALONG] += way_along
    tally[TRAVEL_ACROSS] += way_across
    if fate == LEAVES:
        tally[LEFT] += 1
        return peak
    tally[CAPPED] += fate == IS_CAPPED
    return max(peak, lay_down(work.unstable, stacks, rules, across >> 32, along >> 32, state))


@internal()
def land_flights(flights, stacks, rules, work, order, peak, tally):
    """Land the slabs of all bands, in their order; returns a height that no cell exceeds now."""
    if flights is not None:
        for band in order:
            at = flights.first[band]
            while at != NO_SLAB:
                peak = _land(stacks, rules, work, flights.slabs[at], peak, tally)
                at = flights.slabs[at, 0]
    return np.int64(peak)
