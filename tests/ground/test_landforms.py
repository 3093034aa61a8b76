"""The non-erodible ground."""

import numpy as np
import pytest

from barchan.ground.landforms import Bump, Cliff, DuneForm, Escarpment, FlatGround, Hump, Ramp, Valley
from barchan.lattice import Lattice
from barchan.streams import Stream

LATTICE = Lattice(rows=16, columns=24, cell_size=2.0)
STREAM = Stream(3, "ground")


def test_level_ground_has_its_level_everywhere():
    elevation = FlatGround(level=-3.5).elevation(LATTICE, STREAM)
    assert elevation.shape == (16, 24)
    assert set(elevation.ravel()) == {-3.5}


def test_a_hill_is_as_high_as_stated_at_the_place_stated():
    elevation = Bump(height=10.0, radius=9.0, x=17 / 48, y=5 / 32).elevation(LATTICE, STREAM)
    assert np.unravel_index(elevation.argmax(), elevation.shape) == (2, 8)
    assert elevation[2, 8] == pytest.approx(10.0)


def test_a_hill_has_half_its_height_half_way_to_its_foot_and_none_beyond():
    elevation = Bump(height=10.0, radius=8.0, x=17 / 48, y=17 / 32).elevation(LATTICE, STREAM)
    assert elevation[8, 10] == pytest.approx(5.0)
    assert elevation[10, 8] == pytest.approx(5.0)
    assert elevation[8, 12] == 0.0
    assert elevation[12, 8] == 0.0


def test_a_hollow_is_a_hill_upside_down():
    hill = Bump(height=4.0, radius=8.0).elevation(LATTICE, STREAM)
    np.testing.assert_array_equal(Bump(height=-4.0, radius=8.0).elevation(LATTICE, STREAM), -hill)


def test_a_hill_continues_over_joined_edges_only():
    joined = Bump(height=4.0, radius=8.0, x=0.0).elevation(LATTICE, STREAM)
    np.testing.assert_allclose(joined, joined[:, ::-1])
    alone = LATTICE.model_copy(update={"boundary_x": "open"})
    assert Bump(height=4.0, radius=8.0, x=0.0).elevation(alone, STREAM)[:, -1].max() == 0.0


def test_a_hump_falls_off_as_a_gaussian():
    elevation = Hump(height=10.0, width=4.0, x=17 / 48, y=17 / 32).elevation(LATTICE, STREAM)
    assert elevation[8, 8] == pytest.approx(10.0)
    assert elevation[8, 10] == pytest.approx(10.0 * np.exp(-0.5))
    assert elevation[12, 8] == pytest.approx(10.0 * np.exp(-2.0))


@pytest.mark.parametrize(("crest", "longer"), [(0.0, 0), (90.0, 1)])
def test_a_dune_form_is_longer_along_its_crest(crest, longer):
    ground = DuneForm(length=6.0, width=2.0, crest=crest, x=0.5, y=0.5)
    rows, cols = np.nonzero(ground.elevation(LATTICE, STREAM) > 3.0)
    extents = np.ptp(rows), np.ptp(cols)
    assert extents[longer] > 2 * extents[1 - longer]


def test_the_azimuth_of_a_crest_is_clockwise_from_north():
    ground = DuneForm(length=8.0, width=2.0, crest=45.0, x=0.5, y=0.5)
    elevation = ground.elevation(Lattice(rows=20, columns=20), STREAM)
    assert elevation[14, 14] > elevation[14, 5]


def test_a_valley_is_lowest_in_the_middle_and_meets_itself_at_the_edges():
    elevation = Valley(depth=6.0, runs="north-south").elevation(LATTICE, STREAM)
    assert elevation[:, 11:13].max() == pytest.approx(-6.0, abs=0.2)
    np.testing.assert_allclose(elevation, elevation[:, ::-1])
    assert (np.ptp(elevation, axis=0) == 0).all()
    across = Valley(depth=6.0, runs="east-west").elevation(LATTICE, STREAM)
    assert (np.ptp(across, axis=1) == 0).all()


def test_a_cliff_is_a_plateau_from_its_foot():
    elevation = Cliff(height=5.0, foot=0.25, length=0.5).elevation(LATTICE, STREAM)
    expected = np.zeros(LATTICE.shape)
    expected[:, 6:18] = 5.0
    np.testing.assert_array_equal(elevation, expected)


@pytest.mark.parametrize("kind", [Cliff, Escarpment, Ramp])
def test_what_faces_east_is_the_mirror_image_of_what_faces_west(kind):
    west = kind(faces="west").elevation(LATTICE, STREAM)
    np.testing.assert_array_equal(kind(faces="east").elevation(LATTICE, STREAM), west[:, ::-1])
    south = kind(faces="south").elevation(LATTICE, STREAM)
    np.testing.assert_array_equal(kind(faces="north").elevation(LATTICE, STREAM), south[::-1])


def test_the_face_of_an_escarpment_is_as_steep_as_stated_and_its_back_gentle():
    lattice = Lattice(rows=4, columns=400, cell_size=0.5)
    elevation = Escarpment(height=20.0, face_angle=60.0, foot=0.25).elevation(lattice, STREAM)
    steps = np.diff(elevation[0]) / lattice.cell_size
    assert steps.max() == pytest.approx(np.tan(np.radians(60.0)))
    assert steps.min() == pytest.approx(-20.0 / 150.0, rel=0.01)
    assert elevation.max() == pytest.approx(20.0, abs=2.0)
    assert elevation[0, -1] == pytest.approx(0.0, abs=0.1)


def test_a_ramp_rises_evenly_away_from_the_side_it_faces():
    elevation = Ramp(height=24.0, faces="west").elevation(LATTICE, STREAM)
    np.testing.assert_allclose(np.diff(elevation, axis=1), 1.0)
