"""The surface above which the wind blows: the bed, and lines that fall downwind from all that stands high."""

import numpy as np
from numba import njit

from barchan.kernels.core.internal import internal


@internal(error_model="numpy", forceinline=True)
def _line(near, far, weight, fall):
    return np.float32(np.float64(near) + weight * (np.float64(far) - np.float64(near)) - fall)


@internal(error_model="numpy", forceinline=True)
def _rows_before(row, row_step, rows, wrap):
    """The two rows between which a line comes to ``row``; both that row itself beyond an open edge."""
    lower, upper = row + row_step, row + row_step + 1
    if wrap:
        return lower % rows, upper % rows
    if lower < 0 or upper >= rows:
        return row, row
    return lower, upper


@internal(error_model="numpy")
def _spread_on(before, here, fall, row_step, weight, wrap):
    """Carry lines from one column to the next: rows whose line comes from within the field in one loop."""
    rows = here.size
    first = min(max(-row_step, 0), rows)
    last = max(first, min(rows - 1 - row_step, rows))
    if first < last:
        near, part = before[first + row_step : last + row_step + 1], here[first:last]
        for k in range(last - first):
            part[k] = max(part[k], _line(near[k], near[k + 1], weight, fall))
    for side in ((0, first), (last, rows)):
        for row in range(side[0], side[1]):
            lower, upper = _rows_before(row, row_step, rows, wrap)
            here[row] = max(here[row], _line(before[lower], before[upper], weight, fall))


@njit(cache=True, nogil=True, error_model="numpy")
def raise_shelter_surface(fall, row_step, weight, wrap_along, wrap_across, surface):
    """Raise ``surface``, which holds the bed's height (m, float32), to the lines over it.

    Works in the wind's frame: the wind blows towards growing columns. From one column to the next a line
    falls by ``fall`` (m) and comes from ``row_step`` rows further, interpolated with ``weight`` between that
    row and the one after it. Over joined edges lines go round once. ``surface`` lies column by column, as
    ``[column, row]``, so that the rows of a column lie side by side in memory.
    """
    cols = surface.shape[0]
    for lap in range(2 if wrap_along else 1):
        for col in range(0 if lap else 1, cols):
            before = cols - 1 if col == 0 else col - 1
            _spread_on(surface[before], surface[col], fall, row_step, weight, wrap_across)
