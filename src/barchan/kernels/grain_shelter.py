"""The surface above which the wind blows: the bed, and lines that fall downwind from all that stands high."""

import numpy as np
from numba import njit


@njit(cache=True)
def spread_lid(height, fall, row_step, weight, wrap_along, wrap_across, lid):
    """Put into ``lid`` the bed's ``height`` or the line over it, whichever is higher (m, float32).

    Works in the wind's frame: the wind blows towards growing columns. From one column to the next a line
    falls by ``fall`` (m) and comes from ``row_step`` rows further, interpolated with ``weight`` between that
    row and the one after it. Over joined edges lines go round once.
    """
    rows, cols = height.shape
    for row in range(rows):
        for col in range(cols):
            lid[row, col] = height[row, col]
    for lap in range(2 if wrap_along else 1):
        for col in range(0 if lap else 1, cols):
            before = cols - 1 if col == 0 else col - 1
            for row in range(rows):
                lower, upper = row + row_step, row + row_step + 1
                if wrap_across:
                    lower, upper = lower % rows, upper % rows
                elif lower < 0 or upper >= rows:
                    lower = upper = min(max(row, 0), rows - 1)
                near, far = np.float64(lid[lower, before]), np.float64(lid[upper, before])
                line = np.float32(near + weight * (far - near) - fall)
                lid[row, col] = max(lid[row, col], line)
