"""Height of bedforms, and their spacing over it."""

import math

import numpy as np
import pytest

from barchan.measures import bedform_height, bedform_index, dominant_spacing
from tests.measures.waves import COLUMNS, ROWS, random_surface, ridges, sine, wavelength, wind_along

HEIGHT = 3.0


@pytest.mark.parametrize("wave", [(4, 0), (0, 3), (5, 2)])
def test_a_sine_is_as_high_as_from_trough_to_crest(wave):
    assert bedform_height(HEIGHT * sine(*wave), width=0.0) == pytest.approx(2 * HEIGHT)


def test_straight_flanks_are_lower_than_a_sine_of_their_height():
    """A sawtooth's standard deviation is its height over the root of twelve."""
    field = HEIGHT * ridges(2, 0, 0.75, (ROWS, 4 * COLUMNS))
    assert bedform_height(field, width=0.0) == pytest.approx(np.ptp(field) * math.sqrt(8 / 12), rel=0.02)


@pytest.mark.parametrize("cell", [0.005, 1.0, 4.0])
@pytest.mark.parametrize("wave", [(4, 0), (3, -2)])
def test_the_index_of_a_sine_is_its_wavelength_over_its_height(cell, wave):
    index = bedform_index(HEIGHT * sine(*wave), cell, wind_along(*wave), width=0.0)
    assert index == pytest.approx(wavelength(*wave) * cell / (2 * HEIGHT), rel=1e-6)


def test_the_index_is_spacing_over_height_of_any_surface():
    surface = random_surface(3)
    expected = dominant_spacing(surface, 2.0, 250.0) / bedform_height(surface)
    assert bedform_index(surface, 2.0, 250.0) == pytest.approx(expected)


def test_height_neither_knows_the_level_nor_which_way_is_up():
    surface = random_surface(4)
    assert bedform_height(100.0 - surface) == pytest.approx(bedform_height(surface))


def test_smoothing_takes_short_waves_away():
    assert bedform_height(sine(16, 0), width=3.0) < 0.2 * bedform_height(sine(16, 0), width=0.0)


@pytest.mark.parametrize("periodic", [(True, True), (False, False)])
def test_a_flat_bed_has_no_height_and_no_index(periodic):
    flat = np.full((ROWS, COLUMNS), 1.5)
    assert bedform_height(flat, periodic) == pytest.approx(0.0, abs=1e-12)
    assert math.isnan(bedform_index(flat, 1.0, 270.0, periodic))
