"""Crest azimuth is clockwise from north; coherence measures how straight and parallel crests are."""

import math

import numpy as np
import pytest

from barchan.measures import crest_orientation
from tests.measures.waves import COLUMNS, ROWS, WAVES, random_surface, ridges, sine, wind_along

DEGREE = 1.0


def apart(one, other):
    """Degrees between two crest directions."""
    return abs((one - other + 90) % 180 - 90)


@pytest.mark.parametrize("surface", [sine, ridges])
@pytest.mark.parametrize("wave", WAVES)
@pytest.mark.parametrize("periodic", [(True, True), (False, False)])
def test_crests_run_across_their_wave(surface, wave, periodic):
    orientation = crest_orientation(surface(*wave), 1.0, periodic)
    assert apart(orientation.azimuth, wind_along(*wave) + 90) < DEGREE
    assert 0 <= orientation.azimuth < 180


@pytest.mark.parametrize(("wave", "azimuth"), [((5, 0), 0), ((0, 4), 90), ((5, 3), 135), ((5, -3), 45)])
def test_crests_of_these_waves_have_these_azimuths(wave, azimuth):
    assert apart(crest_orientation(sine(*wave), 1.0).azimuth, azimuth) < DEGREE


@pytest.mark.parametrize("wave", WAVES)
def test_straight_parallel_crests_are_wholly_coherent(wave):
    assert crest_orientation(sine(*wave), 1.0).coherence == pytest.approx(1.0, abs=1e-9)


def test_two_equal_waves_across_each_other_have_no_coherence():
    assert crest_orientation(sine(5, 0) + sine(0, 3), 1.0).coherence == pytest.approx(0.0, abs=1e-9)


def test_coherence_of_two_waves_across_each_other_is_the_difference_of_their_slopes_over_the_sum():
    steep, gentle = (2 * 2.0) ** 2, 1.0
    expected = (steep - gentle) / (steep + gentle)
    both = 2 * 2.0 * sine(5, 0, (80, 80)) + sine(0, 5, (80, 80))
    assert crest_orientation(both, 1.0).coherence == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("turns", [1, 2, 3])
def test_azimuth_turns_with_the_field(turns):
    surface = random_surface(6)
    before = crest_orientation(surface, 1.0)
    after = crest_orientation(np.rot90(surface, turns, axes=(1, 0)), 1.0)
    assert apart(after.azimuth, before.azimuth - 90 * turns) < 1e-6
    assert after.coherence == pytest.approx(before.coherence, abs=1e-9)


def test_azimuth_is_mirrored_with_the_field():
    surface = random_surface(7)
    before, after = (crest_orientation(s, 1.0) for s in (surface, surface[:, ::-1]))
    assert apart(after.azimuth, -before.azimuth) < 1e-6


def test_cell_size_and_height_make_no_difference():
    surface = random_surface(8)
    small, large = crest_orientation(surface, 1.0), crest_orientation(9 * surface + 5, 7.0)
    assert large.azimuth == pytest.approx(small.azimuth, abs=1e-6)
    assert large.coherence == pytest.approx(small.coherence, abs=1e-9)


@pytest.mark.parametrize("periodic", [(True, True), (False, False)])
def test_a_flat_bed_has_no_crests(periodic):
    orientation = crest_orientation(np.full((ROWS, COLUMNS), 7 / 3), 1.0, periodic)
    assert math.isnan(orientation.azimuth)
    assert orientation.coherence == 0.0


def test_ridges_on_one_row_run_north():
    assert crest_orientation(sine(4, 0, (1, 64)), 1.0).azimuth == 0.0
