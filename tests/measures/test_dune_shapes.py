"""Sizes and shapes of bodies whose geometry is known."""

import numpy as np
import pytest

from barchan.measures.dune_shapes import bay_of, dune_shape, long_axis, outline
from barchan.measures.dunes import find_dunes
from tests.measures.test_horns import crescent


def cone(height=6.0, radius=24.0, size=96, where=(40.0, 50.0)):
    north, east = np.mgrid[:size, :size]
    return np.clip(height * (1 - np.hypot(north - where[0], east - where[1]) / radius), 0.0, None)


def test_a_cone_has_the_volume_of_a_cone():
    (dune,) = find_dunes(cone(), 1.0, level=1e-6, width=0.0)
    shape = dune_shape(dune, 270.0, 2.0)
    assert shape.volume == pytest.approx(np.pi * (2 * 24.0) ** 2 * 6.0 / 3, rel=0.01)
    assert shape.area == pytest.approx(np.pi * 48.0**2, rel=0.02)
    assert shape.height == pytest.approx(6.0)
    assert (shape.row, shape.column) == pytest.approx((40.0, 50.0), abs=0.01)
    assert shape.width == pytest.approx(shape.length) == pytest.approx(96.0, abs=4.0)
    assert shape.elongation == pytest.approx(1.0, abs=0.01)
    assert shape.asymmetry == pytest.approx(0.0, abs=0.01)
    assert shape.bay < 0.05
    assert np.isnan(shape.horn_direction)


def test_the_volume_does_not_depend_on_the_level_but_for_what_lies_outside():
    (dune,) = find_dunes(cone(), 1.0, level=1.5, width=0.0)
    frustum = np.pi / 3 * (24.0**2 * 6.0 - 18.0**2 * 4.5)  # what lies below the level, over the wider base
    skirt = frustum - np.pi * 18.0**2 * 1.5
    assert dune_shape(dune, 0.0, 1.0).volume == pytest.approx(np.pi * 24.0**2 * 2.0 - skirt, rel=0.02)


@pytest.mark.parametrize("wind", [0.0, 90.0, 206.6, 300.0])
def test_horns_point_downwind_of_a_crescent_whatever_wind_is_stated(wind):
    (dune,) = find_dunes(crescent(wind), 1.0, width=0.0)
    away = (dune_shape(dune, 45.0, 1.0).horn_direction - wind - 180.0 + 180.0) % 360.0 - 180.0
    assert abs(away) < 2.0


@pytest.mark.parametrize("radius", [6.0, 9.0, 14.0])
def test_a_round_mound_with_a_ragged_outline_has_no_horns(radius):
    """Its outline is displaced by up to half a cell everywhere; no side has more of that than another."""
    rng = np.random.default_rng(7)
    for _ in range(20):
        north, east = np.mgrid[-20:21, -20:21] + rng.random((2, 1, 1))
        inside = np.hypot(north, east) + rng.uniform(-0.5, 0.5, north.shape) < radius
        assert np.isnan(bay_of(*np.nonzero(inside))[1])


@pytest.mark.parametrize("azimuth", [0.0, 30.0, 200.0])
def test_a_crescent_points_to_where_a_disc_is_taken_out(azimuth):
    north, east = np.mgrid[-20:21, -20:21].astype(float)
    away = 14.0 * np.cos(np.radians(azimuth)), 14.0 * np.sin(np.radians(azimuth))
    inside = (np.hypot(north, east) < 12) & (np.hypot(north - away[0], east - away[1]) > 12)
    assert bay_of(*np.nonzero(inside))[1] == pytest.approx(azimuth, abs=4.0)


def test_the_bay_of_a_right_angle_is_a_quarter_of_its_hull():
    rows, columns = np.nonzero(np.pad(np.ones((20, 20)), 0))
    angle = (rows < 10) | (columns < 10)
    share, pointing = bay_of(rows[angle], columns[angle])
    # three quarters of a square; the hull cuts half of the missing quarter off: 300 of 350 cells
    assert share == pytest.approx(1 - 300 / 350, abs=0.01)
    assert pointing == pytest.approx(45.0, abs=0.5)


@pytest.mark.parametrize("azimuth", [0.0, 30.0, 90.0, 150.0])
def test_the_long_axis_of_an_ellipse_is_where_it_was_laid(azimuth):
    north, east = np.mgrid[-50:51, -50:51]
    along = east * np.sin(np.radians(azimuth)) + north * np.cos(np.radians(azimuth))
    across = east * np.cos(np.radians(azimuth)) - north * np.sin(np.radians(azimuth))
    rows, columns = np.nonzero((along / 45) ** 2 + (across / 15) ** 2 < 1)
    orientation, elongation = long_axis(rows, columns)
    assert abs((orientation - azimuth + 90.0) % 180.0 - 90.0) < 0.5
    assert elongation == pytest.approx(3.0, rel=0.02)


def test_an_outline_encloses_the_area_of_its_cells_and_its_holes():
    field = np.zeros((40, 40))
    field[10:30, 8:32] = 3.0
    field[18:22, 18:24] = 0.0
    (dune,) = find_dunes(field, 1.0, level=1.0, width=0.0)
    outer, hole = outline(dune)
    areas = []
    for ring in (outer, hole):
        assert ring[0] == pytest.approx(ring[-1])
        y, x = ring.T
        areas.append(abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2)
    assert areas == pytest.approx([20 * 24 - 0.5, 4 * 6 - 0.5], abs=0.01)  # corners are cut


def test_a_dune_over_a_joined_edge_is_in_one_piece():
    (dune,) = find_dunes(np.roll(cone(), 50, axis=1), 1.0, level=1e-6, width=0.0)
    assert dune_shape(dune, 270.0, 1.0).column % 96 == pytest.approx(100.0 % 96, abs=0.01)
    assert len(outline(dune)) == 1


def test_voids_belong_to_no_dune():
    field = cone()
    field[:, :10] = np.nan
    (dune,) = find_dunes(field, 1.0, (False, False), width=1.0)
    assert dune_shape(dune, 270.0, 1.0).height == pytest.approx(6.0, rel=0.2)
