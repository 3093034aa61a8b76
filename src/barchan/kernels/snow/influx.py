"""Snow that enters across open edges."""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.random import derive, draw
from barchan.kernels.slabs.influx import first_landing
from barchan.kernels.slabs.shadow import whole_view
from barchan.kernels.slabs.state import CAPPED, ENTERED, LEFT, TRAVEL_ACROSS, TRAVEL_ALONG
from barchan.kernels.snow.poll import carry, settle


@njit(cache=True, nogil=True)
def let_enter(pack, rules, influx, key, tally):
    """Let a step's quanta enter across the upwind edges, as ``kernels.slabs.influx.let_enter`` does."""
    pack, rules, influx = borrowed((pack, rules, influx))
    view = whole_view(pack.surface.ctypes.data, rules.slabs.grid)
    peak = np.int64(pack.surface.max())
    for edge in range(2):
        means = influx.along if edge == 0 else influx.across
        for cell in range(means.size):
            start = derive(derive(key, edge), cell)
            if rules.slabs.interruption[0] != 0:
                return
            for number in range(np.int64(means[cell] + draw(start, 1))):
                state = derive(start, number + 1)
                along, across = first_landing(edge, cell, state, rules.slabs)
                tally[ENTERED] += 1
                row, col, state, inside, stays, sheltered, way_along, way_across = carry(
                    pack, rules, view, along, across, True, state, peak
                )
                tally[TRAVEL_ALONG] += way_along
                tally[TRAVEL_ACROSS] += way_across
                if not inside:
                    tally[LEFT] += 1
                    continue
                tally[CAPPED] += not stays
                peak = max(peak, settle(pack, rules, view.near, row, col, sheltered, state))
