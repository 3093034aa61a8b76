"""The flux that moving dunes carry."""

import numpy as np
import pytest

from barchan.measures.flux_profile import flux_profile
from tests.measures.waves import ridges


@pytest.mark.parametrize(
    ("wind", "axis", "sign"), [(270.0, 1, 1), (90.0, 1, -1), (180.0, 0, 1), (0.0, 0, -1)]
)
def test_the_flux_of_a_dune_that_moves_unchanged_is_its_speed_times_its_height(wind, axis, sign):
    before = 3.0 * (ridges(2, 0) if axis else ridges(0, 2))
    moved = np.roll(before, sign, axis)
    found = flux_profile(before, moved, 0.5, 2.0, wind)
    height = np.take(before, 0, 1 - axis)[::sign]  # along the wind
    # a cell of 2 m in half a unit of time is a speed of 4
    assert found.flux == pytest.approx(4.0 * (height - height.min()))
    assert found.distance[[0, -1]] == pytest.approx([2.0, 2.0 * len(height)])


def test_what_cannot_be_compared_is_refused():
    with pytest.raises(ValueError, match="allowed: above 0"):
        flux_profile(np.zeros((4, 4)), np.zeros((4, 4)), 0.0, 1.0, 270.0)
    with pytest.raises(ValueError, match="allowed: the same"):
        flux_profile(np.zeros((4, 4)), np.zeros((4, 5)), 1.0, 1.0, 270.0)
