"""Polling: which cells are asked for a slab, and in which order.

The polls of a step go band of rows by band of rows, the bands in random order, so that a large field
works in the processor's cache. How many polls a band gets is drawn as if every poll had chosen its row
freely, so each cell's number of polls is distributed as without bands; only the order within a step
differs.
"""

import numpy as np

from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import below, derive, high, low, shuffle
from barchan.kernels.slabs.state import Band, Rows


@internal()
def _rows_about(first, own, margin, rows):
    """Some rows and as many as ``margin`` on either side, at most all."""
    count = min(own + 2 * margin, rows)
    return Rows((first - margin) % rows if count < rows else 0, count)


@internal()
def band_of(number, rows, schedule, near, reach):
    """A band by its number, with ``near`` rows on either side, and ``reach`` rows that it may touch."""
    first = number * schedule.band_rows
    own = min(schedule.band_rows, rows - first)
    return Band(number, first, own, _rows_about(first, own, near, rows), _rows_about(first, own, reach, rows))


@internal()
def shuffle_bands(order, key):
    """Draw the order of the bands."""
    for band in range(order.size):
        order[band] = band
    shuffle(order, order.size, key)


@internal()
def count_polls_by_row(polls, first, count, key):
    """Draw how many of the polls ``first`` to ``first + count`` fall on each row, two from a draw."""
    rows = polls.row_polls.size
    polls.row_polls[:] = 0
    for pair in range((count + 1) // 2):
        draw = derive(key, first + pair)
        polls.row_polls[below(high(draw), rows)] += 1
        if 2 * pair + 1 < count:
            polls.row_polls[below(low(draw), rows)] += 1


@internal()
def polls_in_band(polls, band):
    """Number of polls that fall on the rows of a band."""
    total = 0
    for row in range(band.first_row, band.first_row + band.rows):
        total += polls.row_polls[row]
    return total


@internal()
def draw_cells(polls, first, count, band, cols, key):
    """Prepare ``count`` polls, from poll ``first`` on, of cells drawn at random within a band."""
    for k in range(count):
        draw = derive(key, first + k)
        polls.states[k] = draw
        polls.cols[k] = below(high(draw), cols)
        polls.rows[k] = band.first_row + below(low(draw), band.rows)


@internal()
def shuffle_cells(polls, cells, key):
    """Shuffle the ``cells`` cells of a band."""
    for k in range(cells):
        polls.permutation[k] = k
    shuffle(polls.permutation, cells, key)


@internal()
def take_cells(polls, first, at, count, first_row, cols, key):
    """Prepare ``count`` polls, from poll ``first`` on, of the cells at ``at`` in the shuffled band."""
    for k in range(count):
        cell = np.int64(polls.permutation[at + k])
        polls.states[k] = derive(key, first + k)
        polls.rows[k] = first_row + cell // cols
        polls.cols[k] = cell % cols
