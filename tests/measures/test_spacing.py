"""Spacing is the distance from one crest to the next along the wind."""

import math

import numpy as np
import pytest

from barchan.measures import dominant_spacing
from tests.measures.waves import COLUMNS, ROWS, WAVES, random_surface, ridges, sine, wavelength, wind_along

BOUNDARIES = pytest.mark.parametrize("periodic", [(True, True), (False, False), (True, False)])


@BOUNDARIES
@pytest.mark.parametrize("wave", WAVES)
def test_spacing_of_a_train_of_waves_is_their_wavelength(wave, periodic):
    spacing = dominant_spacing(sine(*wave), 1.0, wind_along(*wave), periodic)
    assert spacing == pytest.approx(wavelength(*wave), rel=0.001)


@BOUNDARIES
@pytest.mark.parametrize("wave", WAVES)
def test_spacing_of_sharp_crested_ridges_is_their_distance_but_for_a_hundredth(wave, periodic):
    spacing = dominant_spacing(ridges(*wave), 1.0, wind_along(*wave), periodic)
    assert spacing == pytest.approx(wavelength(*wave), rel=0.01)


@pytest.mark.parametrize("turn", [-40, -20, 15, 30, 180, 200])
@pytest.mark.parametrize("wave", [(5, 0), (5, 3), (4, -2)])
def test_spacing_along_an_oblique_wind_is_longer_by_its_obliquity(wave, turn):
    direction = (wind_along(*wave) + turn) % 360
    expected = wavelength(*wave) / abs(math.cos(math.radians(turn)))
    assert dominant_spacing(sine(*wave), 1.0, direction) == pytest.approx(expected, rel=0.001)


@pytest.mark.parametrize(("first", "second"), [(1.0, 1.0), (2.0, 1.0), (1.0, 3.0)])
def test_of_two_trains_of_waves_each_counts_with_the_square_of_its_power(first, second):
    both = first * sine(5, 0) + second * sine(8, 0)
    wavenumber = (first**4 * 5 / COLUMNS + second**4 * 8 / COLUMNS) / (first**4 + second**4)
    assert dominant_spacing(both, 1.0, 270.0, width=0.0) == pytest.approx(1 / wavenumber, rel=1e-6)


def test_spacing_is_in_metres():
    assert dominant_spacing(sine(5, 0), 2.5, 270.0) == pytest.approx(16 * 2.5, rel=0.001)


@pytest.mark.parametrize("rows", range(0, ROWS, 11))
def test_spacing_does_not_depend_on_where_crests_lie(rows):
    surface = random_surface(3)
    moved = np.roll(surface, (rows, 2 * rows), (0, 1))
    expected = dominant_spacing(surface, 1.0, 250.0)
    assert dominant_spacing(moved, 1.0, 250.0) == pytest.approx(expected, abs=1e-6)


def test_spacing_does_not_depend_on_height_or_level():
    surface = random_surface(3)
    expected = dominant_spacing(surface, 1.0, 270.0)
    assert dominant_spacing(1000 + 7 * surface, 1.0, 270.0) == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("turns", [1, 2, 3])
def test_spacing_turns_with_field_and_wind(turns):
    surface = random_surface(5)
    turned = np.rot90(surface, turns, axes=(1, 0))
    expected = dominant_spacing(surface, 1.0, 250.0)
    assert dominant_spacing(turned, 1.0, (250.0 - 90 * turns) % 360) == pytest.approx(expected, abs=1e-6)


@BOUNDARIES
@pytest.mark.parametrize("thickness", [1 / 3, 0.1, 1.0])
@pytest.mark.parametrize("slabs", [0, 1, 3, 4, 5, 10])
def test_a_flat_bed_has_no_spacing(slabs, thickness, periodic):
    level = np.full((ROWS, COLUMNS), slabs) * thickness
    assert math.isnan(dominant_spacing(level, 1.0, 270.0, periodic))


def test_crests_along_the_wind_have_no_spacing_along_it():
    assert math.isnan(dominant_spacing(sine(5, 0), 1.0, 0.0))


@pytest.mark.parametrize(("shape", "direction"), [((1, 64), 270.0), ((64, 1), 180.0)])
def test_a_field_of_one_line_has_a_spacing_along_it(shape, direction):
    wave = sine(4, 0, shape) if shape[0] == 1 else sine(0, 4, shape)
    assert dominant_spacing(wave, 1.0, direction) == pytest.approx(16, rel=0.001)
