"""Arms are measured on bodies that are drawn with arms of known length."""

import numpy as np
import pytest

from barchan.directions import downwind
from barchan.measures.arms import arms
from barchan.measures.dunes import find_dunes


def hairpin(direction, left=30.0, right=30.0, size=128):
    """A nose 40 cells wide with two limbs, 8 cells wide, that trail upwind, for a wind from a direction."""
    x, y = downwind(direction)
    north, east = np.mgrid[:size, :size] - size / 2
    along, leftward = east * x + north * y, north * x - east * y
    nose = (np.abs(leftward) < 20) & (np.abs(along - 15) < 5)
    limb = np.where(leftward > 0, left, right)
    nose |= (np.abs(leftward) > 12) & (np.abs(leftward) < 20) & (along < 15) & (along > 10 - limb)
    return np.where(nose, 3.0, 0.0)


def only(field):
    (dune,) = find_dunes(field, 1.0, width=0.0)
    return dune


@pytest.mark.parametrize("direction", [0.0, 45.0, 90.0, 206.6, 270.0, 300.0])
def test_arms_are_as_long_as_they_were_drawn_whatever_the_wind(direction):
    seen = arms(only(hairpin(direction, left=40.0, right=25.0)), direction, 2.0)
    assert seen.left == pytest.approx(80.0, abs=5.0)
    assert seen.right == pytest.approx(50.0, abs=5.0)
    assert seen.width == pytest.approx(80.0, abs=6.0)
    assert seen.ratio == pytest.approx(50 / 80, abs=0.08)


def test_horns_that_point_downwind_are_no_arms():
    assert arms(only(hairpin(270.0)), 90.0, 1.0).ratio == pytest.approx(0.0, abs=0.03)


def test_a_disc_and_a_ridge_across_the_wind_have_no_arms():
    north, east = np.mgrid[:128, :128] - 64
    assert arms(only(np.where(np.hypot(north, east) < 30, 3.0, 0.0)), 270.0, 1.0).ratio < 0.0
    ridge = np.where((np.abs(north) < 40) & (np.abs(east) < 5), 3.0, 0.0)
    assert arms(only(ridge), 270.0, 1.0).ratio == 0.0


def test_one_limb_alone_makes_no_hairpin():
    assert arms(only(hairpin(270.0, left=40.0, right=0.0)), 270.0, 1.0).ratio == pytest.approx(0.0, abs=0.06)
