"""Bedforms are measured without the ground under them."""

import math

import numpy as np
import pytest

from barchan.measures import (
    bedform_height,
    bedform_surface,
    crest_orientation,
    dominant_spacing,
    migration,
    streamwise_slopes,
)
from tests.measures.waves import COLUMNS, ROWS, hill, random_surface, sine, wavelength, wind_along

WAVES = 3.0 + 2.0 * sine(5, 3)
WIND = wind_along(5, 3)
ROUGH = 12.0 * random_surface(4) / np.ptp(random_surface(4))


def rocks(height=6.0):
    """Two rocks with vertical walls on level ground."""
    ground = np.zeros((ROWS, COLUMNS))
    ground[8:16, 20:32] = ground[30:40, 55:62] = height
    return ground


def measures(surface):
    slopes = streamwise_slopes(surface, 1.0, WIND)
    azimuth = crest_orientation(surface, 1.0).azimuth
    return [
        dominant_spacing(surface, 1.0, WIND),
        bedform_height(surface),
        slopes.windward,
        slopes.lee,
        azimuth,
    ]


@pytest.mark.parametrize("level", [0.0, 7.5])
def test_on_level_ground_it_is_the_elevation(level):
    np.testing.assert_array_equal(bedform_surface(np.full(WAVES.shape, level), WAVES, 1.0), level + WAVES)


@pytest.mark.parametrize(
    "ground", [20.0 * hill(24, 40, size=9.0), ROUGH, rocks()], ids=["dome", "hills", "rocks"]
)
def test_waves_that_drape_the_ground_have_the_measures_that_they_have_on_a_level(ground):
    assert measures(bedform_surface(ground, WAVES, 1.0)) == pytest.approx(measures(WAVES))
    assert dominant_spacing(WAVES, 1.0, WIND) == pytest.approx(wavelength(5, 3), rel=0.001)


def test_waves_on_sand_that_fills_the_hollows_are_those_of_the_elevation():
    depth = 20.0 + WAVES - ROUGH
    assert measures(bedform_surface(ROUGH, depth, 1.0)) == pytest.approx(measures(WAVES))


@pytest.mark.parametrize("cell", [0.5, 1.0, 4.0])
def test_rock_that_stands_in_sand_is_left_out(cell):
    ground = cell * rocks()
    depth = np.where(ground > 0, 0.0, cell * WAVES)
    surface = bedform_surface(ground, depth, cell)
    np.testing.assert_array_equal(np.isnan(surface), ground > 0)
    np.testing.assert_allclose(surface[ground == 0], depth[ground == 0])


@pytest.mark.parametrize("place", [0, 30])
def test_sand_beyond_joined_edges_counts_as_near(place):
    """Only columns 0 to 4 have sand; ground that rises eastwards by 45 degrees from there is rock."""
    ground = np.tile(np.concatenate([np.zeros(40), np.arange(20), np.zeros(20)]), (ROWS, 1))
    depth = np.zeros(ground.shape)
    depth[:, 35:40] = 1.0
    surface = bedform_surface(np.roll(ground, place, 1), np.roll(depth, place, 1), 1.0)
    rock = np.isnan(np.roll(surface, -place, 1))
    assert rock[:, 42:60].all()
    assert not rock[:, :40].any()


def test_bare_floors_of_gentle_ground_are_the_foot_of_dunes_on_it():
    ground = 4.0 * hill(24, 40, size=15.0)
    depth = np.maximum(2.0 * sine(5, 0), 0.0)
    np.testing.assert_allclose(bedform_surface(ground, depth, 1.0), depth)


def test_bare_ground_has_no_bedforms():
    surface = bedform_surface(ROUGH, np.zeros(ROUGH.shape), 1.0)
    assert bedform_height(surface) == 0.0
    assert math.isnan(dominant_spacing(surface, 1.0, 270.0))


def moved(ground, depths):
    return migration([0, 4, 8, 12], [bedform_surface(ground, depth, 1.0) for depth in depths])


@pytest.mark.parametrize(
    "ground",
    [np.zeros((ROWS, COLUMNS)), rocks(), ROUGH, 20.0 * hill(24, 40)],
    ids=["level", "rocks", "hills", "dome"],
)
def test_ground_that_stands_still_does_not_hold_waves_back(ground):
    """The waves go east by one cell in four steps."""
    depths = [np.roll(3.5 + sine(4, 0) + sine(6, 2), k, axis=1) for k in range(4)]
    result = moved(ground, depths)
    assert (result.x, result.y) == pytest.approx((0.25, 0.0), abs=1e-9)


def test_rock_that_stands_out_of_the_waves_does_not_hold_them_back():
    """The waves go past the rocks, on which no sand lies."""
    ground = rocks()
    waves = [np.roll(3.5 + sine(4, 0) + sine(6, 2), k, axis=1) for k in range(4)]
    result = moved(ground, [np.where(ground > 0, 0.0, depth) for depth in waves])
    assert (result.x, result.y) == pytest.approx((0.25, 0.0), abs=0.01)
