"""Horns are measured in the wind's frame."""

import numpy as np
import pytest

from barchan.directions import downwind
from barchan.measures.dunes import find_dunes
from barchan.measures.horns import horns


def crescent(direction, left=14.0, right=14.0, size=96):
    """A body with two horns of given lengths (cells) downwind of its bay, for a wind from a direction."""
    x, y = downwind(direction)
    north, east = np.mgrid[:size, :size] - size / 2
    along, leftward = east * x + north * y, north * x - east * y
    body = (np.abs(leftward) < 20) & (np.abs(along) < 5)
    horn = np.where(leftward > 0, left, right)
    body |= (np.abs(leftward) > 10) & (np.abs(leftward) < 20) & (along > 0) & (along < 5 + horn)
    return np.where(body, 3.0, 0.0)


@pytest.mark.parametrize("direction", [0.0, 45.0, 90.0, 180.0, 206.6, 270.0, 300.0])
def test_horns_are_as_long_as_they_were_made_whatever_the_wind(direction):
    (dune,) = find_dunes(crescent(direction, left=20.0, right=10.0), 1.0, width=0.0)
    seen = horns(dune, direction, 2.0)
    assert seen.left == pytest.approx(40.0, abs=5.0)
    assert seen.right == pytest.approx(20.0, abs=5.0)
    assert seen.width == pytest.approx(80.0, abs=6.0)
    assert seen.length == pytest.approx(60.0, abs=6.0)
    assert seen.crescent == pytest.approx(3 / 8, abs=0.06)
    assert seen.slant == pytest.approx(1 / 4, abs=0.06)


def test_a_crescent_that_faces_the_wind_has_a_straight_back():
    (dune,) = find_dunes(crescent(270.0), 1.0, width=0.0)
    assert horns(dune, 90.0, 1.0).crescent == pytest.approx(0.0, abs=0.05)


def test_the_edge_of_a_disc_stays_back_to_both_sides():
    north, east = np.mgrid[:120, :120] - 60
    (dune,) = find_dunes(np.where(np.hypot(north, east) < 30, 3.0, 0.0), 1.0, width=0.0)
    seen = horns(dune, 270.0, 1.0)
    outer, middle = (np.sqrt(1 - np.linspace(*ends, 1001) ** 2).mean() for ends in ((0.5, 1), (0, 0.5)))
    assert seen.left == pytest.approx(30 * (outer - middle), abs=2.0)
    assert seen.right == pytest.approx(seen.left, abs=2.0)


def test_a_mirrored_dune_has_its_horns_exchanged():
    field = crescent(270.0, left=20.0, right=8.0)
    (dune,), (mirrored,) = find_dunes(field, 1.0), find_dunes(field[::-1], 1.0)
    there, back = horns(dune, 270.0, 1.0), horns(mirrored, 270.0, 1.0)
    assert (there.left, there.right) == pytest.approx((back.right, back.left), abs=2.0)
    assert there.slant == pytest.approx(-back.slant, abs=0.05)


@pytest.mark.parametrize(
    "cells", [(slice(5, 6), slice(5, 6)), (slice(5, 6), slice(3, 12)), (slice(3, 12), slice(5, 6))]
)
def test_dunes_of_a_cell_or_a_line_have_no_horns(cells):
    field = np.zeros((16, 16))
    field[cells] = 3.0
    (dune,) = find_dunes(field, 1.0, width=0.0)
    assert horns(dune, 270.0, 1.0).crescent == pytest.approx(0.0, abs=1e-9)
