"""Steps of snow: the polls of a step band by band, and snow that enters across open edges."""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.random import derive, draw
from barchan.kernels.slabs.influx import first_landing
from barchan.kernels.slabs.polling import (
    band_of,
    count_polls_by_row,
    draw_cells,
    polls_in_band,
    shuffle_bands,
)
from barchan.kernels.slabs.shadow import whole_view
from barchan.kernels.slabs.state import BLOCK, CAPPED, ENTERED, LEFT, TRAVEL_ACROSS, TRAVEL_ALONG
from barchan.kernels.snow.poll import carry, run_polls, settle


@njit(cache=True, nogil=True)
def run_steps(pack, rules, work, schedule, key, step, steps, first, count, tally):
    """Run the polls ``first`` to ``first + count`` of each of ``steps`` steps from ``step`` on.

    The pack is changed in place; its surface has room for ``SIMD_WIDTH`` numbers before it. Polls and their
    random numbers are those of slabs of sand. Moved quanta, travel and the rest are added to ``tally``.
    Work that is broken off leaves pack and tally as they happen to be.
    """
    grid, polls = rules.slabs.grid, work.polls
    for now in range(step, step + steps):
        step_key = derive(key, now)
        poll_key = derive(step_key, 0)
        count_polls_by_row(polls, first, count, derive(step_key, 1))
        shuffle_bands(polls.band_order, derive(step_key, 2))
        peak = np.int64(pack.surface.max())
        poll = first
        for number in polls.band_order:
            band = band_of(number, grid.rows, schedule, grid.rows, grid.rows)
            at, end = 0, polls_in_band(polls, band)
            while at < end:
                if rules.slabs.interruption[0] != 0:
                    return
                n = min(BLOCK, end - at)
                draw_cells(polls, poll, n, band, grid.cols, poll_key)
                peak = run_polls(pack, rules, work, n, peak, tally)
                poll += n
                at += n


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
                state, height = settle(pack, rules, row, col, sheltered, state)
                peak = max(peak, height)
