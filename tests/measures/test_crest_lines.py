"""Crest lines of surfaces whose crests are known by construction."""

import numpy as np
import pytest

from barchan.measures.crest_lines import CrestLine, crest_length, crest_lines, defect_density, mean_direction
from tests.measures.waves import COLUMNS, ROWS, WAVES, sine, wavelength


@pytest.mark.parametrize(("m", "n"), WAVES)
def test_straight_crests_are_as_long_as_the_field_over_their_spacing_and_have_no_end(m, n):
    lines = crest_lines(sine(m, n), width=1.0, reach=wavelength(m, n) / 2)
    assert crest_length(lines) == pytest.approx(ROWS * COLUMNS / wavelength(m, n), rel=0.02)
    assert sum(line.ends for line in lines) == 0
    azimuth, spread = mean_direction(lines)
    expected = np.degrees(np.arctan2(-n / ROWS, m / COLUMNS)) % 180.0  # along the wave's crests
    assert abs((azimuth - expected + 90.0) % 180.0 - 90.0) < 1.0
    assert spread < 5.0


def test_crests_meet_the_highest_places_of_waves_that_no_cell_centre_lies_on():
    lines = crest_lines(sine(5, 0), width=1.0, reach=8)
    places = np.concatenate([line.columns for line in lines]) % COLUMNS
    crests = (np.arange(5) - 0.05) * COLUMNS / 5 % COLUMNS
    assert np.abs(places[:, None] - crests).min(axis=1).max() < 0.1


def ridge(length, size=96):
    """A ridge of a length (cells) from south to north with round ends, on a floor."""
    north, east = np.mgrid[:size, :size] - (size - 1) / 2
    beyond = np.maximum(np.abs(north) - length / 2, 0.0)
    return 3.0 * np.exp(-(east**2 + beyond**2) / 32)


def test_a_single_ridge_has_two_ends():
    (line,) = crest_lines(ridge(40), width=1.0, reach=12)
    assert line.ends == 2
    assert line.length == pytest.approx(40.0, abs=10.0)  # the round ends belong to the crest in part
    assert min(line.azimuth, 180.0 - line.azimuth) < 1.0
    assert defect_density([line], 2.0) == pytest.approx(1 / line.length)


def test_a_ridge_that_an_open_edge_cuts_ends_once():
    (line,) = crest_lines(ridge(40)[48:], (False, False), width=1.0, reach=12)
    assert line.ends == 1


def test_a_ridge_that_runs_into_a_void_ends_once():
    surface = ridge(40)
    surface[:48] = np.nan
    (line,) = crest_lines(surface, width=1.0, reach=12)
    assert line.ends == 1


def test_crests_cross_joined_edges_in_one_piece():
    (line,) = crest_lines(np.roll(ridge(40), 48, axis=0), width=1.0, reach=12)
    assert line.ends == 2


def test_a_spread_of_straight_crests_follows_from_their_angles():
    at = np.arange(50.0)
    angles = np.radians([80.0, 100.0])
    lines = [CrestLine(at * np.cos(angle), at * np.sin(angle), 2) for angle in angles]
    azimuth, spread = mean_direction(lines)
    assert azimuth == pytest.approx(90.0)
    # doubled angles lie 20 degrees to either side of their mean: R = cos 20 degrees
    assert spread == pytest.approx(np.degrees(np.sqrt(-2 * np.log(np.cos(np.radians(20.0))))) / 2)


@pytest.mark.parametrize("surface", [np.zeros((32, 32)), np.full((32, 32), np.nan), np.zeros((2, 1))])
def test_nothing_to_see_has_no_crest(surface):
    assert crest_lines(surface) == []
    assert np.isnan(defect_density([], 1.0))
    assert np.isnan(mean_direction([])[0])
