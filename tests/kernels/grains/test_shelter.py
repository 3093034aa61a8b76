"""The sheltered air against the slow and obvious way, bit for bit."""

import numpy as np
import pytest

from barchan.kernels.grains.shelter import raise_shelter_surface

FALL = 0.001


def obvious_surface(height, row_step, weight, wrap_along, wrap_across):
    """Column by column and row by row, in 32 bits where the kernel's are; ``height`` is [row, column]."""
    rows, cols = height.shape
    surface = height.copy()
    for lap in range(1 + wrap_along):
        for col in range(0 if lap else 1, cols):
            for row in range(rows):
                lower, upper = row + row_step, row + row_step + 1
                if wrap_across:
                    lower, upper = lower % rows, upper % rows
                elif lower < 0 or upper >= rows:
                    lower = upper = row
                near, far = float(surface[lower, col - 1]), float(surface[upper, col - 1])
                line = np.float32(near + weight * (far - near) - FALL)
                surface[row, col] = max(surface[row, col], line)
    return surface


@pytest.mark.parametrize("shape", [(1, 1), (1, 7), (2, 3), (5, 9), (16, 8)])
@pytest.mark.parametrize(("row_step", "weight"), [(0, 0.0), (-1, 0.3), (0, 0.7), (-1, 0.0)])
@pytest.mark.parametrize("wrap_along", [False, True])
@pytest.mark.parametrize("wrap_across", [False, True])
def test_lines_fall_downwind_from_all_that_stands_high(shape, row_step, weight, wrap_along, wrap_across):
    height = np.random.default_rng(4).random(shape).astype(np.float32) * np.float32(0.01)
    surface = np.array(height.T, order="C")
    raise_shelter_surface(FALL, row_step, weight, wrap_along, wrap_across, surface)
    np.testing.assert_array_equal(
        surface.T, obvious_surface(height, row_step, weight, wrap_along, wrap_across)
    )
