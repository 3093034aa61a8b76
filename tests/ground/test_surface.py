"""The non-erodible ground."""

import numpy as np
import pytest

from barchan.bed import Lattice
from barchan.ground.surface import Bump, FlatGround

LATTICE = Lattice(rows=16, columns=24, cell_size=2.0)


def test_level_ground_has_its_level_everywhere():
    elevation = FlatGround(level=-3.5).elevation(LATTICE)
    assert elevation.shape == (16, 24)
    assert set(elevation.ravel()) == {-3.5}


def test_a_hill_is_as_high_as_stated_at_the_place_stated():
    elevation = Bump(height=10.0, radius=9.0, x=17 / 48, y=5 / 32).elevation(LATTICE)
    assert np.unravel_index(elevation.argmax(), elevation.shape) == (2, 8)
    assert elevation[2, 8] == pytest.approx(10.0)


def test_a_hill_has_half_its_height_half_way_to_its_foot_and_none_beyond():
    elevation = Bump(height=10.0, radius=8.0, x=17 / 48, y=17 / 32).elevation(LATTICE)
    assert elevation[8, 10] == pytest.approx(5.0)
    assert elevation[10, 8] == pytest.approx(5.0)
    assert elevation[8, 12] == 0.0
    assert elevation[12, 8] == 0.0


def test_a_hollow_is_a_hill_upside_down():
    hill = Bump(height=4.0, radius=8.0).elevation(LATTICE)
    np.testing.assert_array_equal(Bump(height=-4.0, radius=8.0).elevation(LATTICE), -hill)
