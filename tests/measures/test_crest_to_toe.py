"""Dunes are as high as their crests stand above the toes of their lee sides."""

import math

import numpy as np
import pytest

from barchan.measures import crest_to_toe_height
from tests.measures.waves import COLUMNS, ROWS, ridges, sine, wavelength, wind_along

BOUNDARIES = pytest.mark.parametrize("periodic", [(True, True), (False, False), (True, False)])


@BOUNDARIES
@pytest.mark.parametrize("wave", [(4, 0), (0, 3), (5, 3), (-4, 2)])
def test_waves_are_twice_as_high_as_their_amplitude(wave, periodic):
    """Looks a cell apart and linear values between cells miss (2 pi / wavelength)² / 8 each at most."""
    height = crest_to_toe_height(3.0 * sine(*wave), wind_along(*wave), periodic, width=0.0)
    assert 6.0 * (1 - (2 * math.pi / wavelength(*wave)) ** 2 / 4) - 1e-9 <= height <= 6.0 + 1e-9


@pytest.mark.parametrize("wave", [(2, 0), (0, 2)])
def test_ridges_of_straight_flanks_have_the_height_they_are_built_with(wave):
    field = 3.0 * ridges(*wave)
    assert crest_to_toe_height(field, wind_along(*wave), width=0.0) == pytest.approx(np.ptp(field), rel=1e-9)


def test_dunes_far_apart_are_as_high_as_over_the_floor_between_them():
    """Three ridges of height 5 in 160 cells, where waves with their deviation would be far lower."""
    profile = np.zeros(160)
    for start in (10, 60, 110):
        profile[start : start + 12] = np.concatenate([np.arange(1, 9) / 8, np.arange(3, -1, -1) / 4]) * 5.0
    assert crest_to_toe_height(np.tile(profile, (8, 1)), 270.0, width=0.0) == pytest.approx(5.0)


def test_dunes_of_two_heights_count_by_their_height():
    """Heights of 2 and 6, as many of each: (4 + 36) / (2 + 6)."""
    profile = np.concatenate([a * np.sin(np.pi * np.arange(16) / 8) for a in (1.0, 3.0)])
    assert crest_to_toe_height(np.tile(profile, (6, 3)), 270.0, width=0.0) == pytest.approx(5.0)


def test_roughness_of_a_floor_hardly_counts_beside_dunes():
    field = 4.0 * sine(4, 0) + np.random.default_rng(1).normal(0.0, 0.05, (ROWS, COLUMNS))
    assert crest_to_toe_height(field, 270.0) == pytest.approx(8.0, rel=0.05)


@BOUNDARIES
def test_waves_on_a_tilted_plane_are_as_high_as_on_a_level(periodic):
    east = np.arange(COLUMNS)[None, :] * (0.0 if periodic[1] else 0.2)
    north = np.arange(ROWS)[:, None] * (0.0 if periodic[0] else -0.1)
    height = crest_to_toe_height(sine(5, 0) + east + north, 270.0, periodic, width=0.0)
    assert height == pytest.approx(2.0, rel=0.03)


def test_unknown_cells_are_left_out():
    field = sine(5, 0)
    field[10:20, 30:50] = np.nan
    assert crest_to_toe_height(field, 270.0, width=0.0) == pytest.approx(2.0, rel=0.03)


@BOUNDARIES
@pytest.mark.parametrize("direction", [0.0, 33.0, 270.0])
def test_a_flat_bed_has_no_dunes(direction, periodic):
    assert math.isnan(crest_to_toe_height(np.full((ROWS, COLUMNS), 1 / 3), direction, periodic))


@pytest.mark.parametrize("shape", [(1, 64), (2, 64), (3, 64)])
@pytest.mark.parametrize("direction", [270.0, 250.0, 180.0])
def test_fields_of_few_rows_can_be_measured(shape, direction):
    height = crest_to_toe_height(sine(4, 0, shape), direction, width=0.0)
    assert math.isnan(height) or height <= 2.0 + 1e-9


def test_a_single_ridge_on_a_field_with_joined_edges_is_followed_by_itself():
    ridge = np.zeros((8, 64))
    ridge[:, 20:36] = 4.0 * np.sin(np.pi * np.arange(1, 17) / 17)
    assert crest_to_toe_height(ridge, 270.0, width=0.0) == pytest.approx(np.ptp(ridge))
