"""Rocks and uneven ground."""

import numpy as np
import pytest
from pydantic import ValidationError
from scipy.ndimage import label

from barchan.ground.noise import hills
from barchan.ground.rocks import Rock, ThreeRocks, UnevenGround
from barchan.lattice import Lattice
from barchan.streams import Stream

LATTICE = Lattice(rows=128, columns=192, cell_size=2.0)


def stream(seed=4):
    return Stream(seed, "ground")


def test_there_are_three_rocks_as_high_as_stated_and_bare():
    ground = ThreeRocks(height=7.0)
    elevation, bare = ground.elevation(LATTICE, stream()), ground.bare(LATTICE)
    assert label(bare)[1] == 3
    assert set(elevation[bare]) == {7.0}
    assert set(elevation[~bare]) == {0.0}


def test_a_rock_stands_where_it_is_stated():
    rock = Rock(west=0.25, east=0.5, south=0.75, north=1.0)
    bare = ThreeRocks(rocks=[rock]).bare(Lattice(rows=8, columns=16))
    expected = np.zeros((8, 16), bool)
    expected[6:8, 4:8] = True
    np.testing.assert_array_equal(bare, expected)


def test_a_rock_has_an_area():
    with pytest.raises(ValidationError, match="a rock must have an area"):
        Rock(west=0.5, east=0.5)


def test_uneven_ground_reaches_from_zero_to_its_height_and_differs_from_seed_to_seed():
    elevation = UnevenGround(height=6.0).elevation(LATTICE, stream())
    assert elevation.min() == 0.0
    assert elevation.max() == pytest.approx(6.0)
    assert (elevation != UnevenGround(height=6.0).elevation(LATTICE, stream(5))).any()


def test_hills_are_as_smooth_as_the_gaussian_that_made_them():
    size = 12.0
    shape = hills(LATTICE, stream(), size)
    shape -= shape.mean()
    lag = 6
    measured = (shape * np.roll(shape, lag, axis=1)).mean() / (shape**2).mean()
    expected = np.exp(-((lag * LATTICE.cell_size) ** 2) / (4 * size**2))
    assert measured == pytest.approx(expected, abs=0.08)


def test_hills_continue_over_the_edges():
    shape = hills(LATTICE, stream(), 20.0)
    steps = np.abs(np.diff(shape, axis=1)).max()
    assert np.abs(shape[:, 0] - shape[:, -1]).max() <= 1.2 * steps


def test_hills_too_wide_for_the_field_leave_it_level():
    assert set(hills(LATTICE, stream(), 1e6).ravel()) == {0.0}
