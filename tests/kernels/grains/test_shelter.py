"""The sheltered air against the slow and obvious way, bit for bit."""

import numpy as np
import pytest

from barchan.kernels.grains.shelter import spread_lid

FALL = 0.001


def obvious_lid(height, row_step, weight, wrap_along, wrap_across):
    """Column by column and row by row, in 32 bits where the kernel's are; ``height`` is [row, column]."""
    rows, cols = height.shape
    lid = height.copy()
    for lap in range(1 + wrap_along):
        for col in range(0 if lap else 1, cols):
            for row in range(rows):
                lower, upper = row + row_step, row + row_step + 1
                if wrap_across:
                    lower, upper = lower % rows, upper % rows
                elif lower < 0 or upper >= rows:
                    lower = upper = row
                near, far = float(lid[lower, col - 1]), float(lid[upper, col - 1])
                line = np.float32(near + weight * (far - near) - FALL)
                lid[row, col] = max(lid[row, col], line)
    return lid


@pytest.mark.parametrize("shape", [(1, 1), (1, 7), (2, 3), (5, 9), (16, 8)])
@pytest.mark.parametrize(("row_step", "weight"), [(0, 0.0), (-1, 0.3), (0, 0.7), (-1, 0.0)])
@pytest.mark.parametrize("wrap_along", [False, True])
@pytest.mark.parametrize("wrap_across", [False, True])
def test_lines_fall_downwind_from_all_that_stands_high(shape, row_step, weight, wrap_along, wrap_across):
    height = np.random.default_rng(4).random(shape).astype(np.float32) * np.float32(0.01)
    lid = np.array(height.T, order="C")
    spread_lid(FALL, row_step, weight, wrap_along, wrap_across, lid)
    np.testing.assert_array_equal(lid.T, obvious_lid(height, row_step, weight, wrap_along, wrap_across))
