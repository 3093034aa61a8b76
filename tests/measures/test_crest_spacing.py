"""Spacings of crests that were put at known places."""

import numpy as np
import pytest

from barchan.measures.crest_spacing import crest_spacing
from tests.measures.waves import WAVES, hill, ridges, sine, wavelength, wind_along


@pytest.mark.parametrize(("m", "n"), WAVES[:4])
def test_crests_of_a_wave_are_a_wavelength_apart(m, n):
    found = crest_spacing(sine(m, n), 2.0, wind_along(m, n))
    assert found.mean == pytest.approx(2.0 * wavelength(m, n), rel=0.01)
    assert found.spread < 0.05 * found.mean


def test_the_mean_gap_is_that_between_crests_not_the_wavelength_of_most_power():
    centres = np.array([10, 22, 46, 56])
    surface = sum(hill(24, at, size=2.5)[24] for at in centres) * np.ones((48, 1))
    found = crest_spacing(surface, 1.0, 270.0)
    gaps = [12, 24, 10, 34]  # the last over the joined edge of 80 cells
    assert found.count >= 48 * 4
    assert found.mean == pytest.approx(np.mean(gaps), rel=0.1)
    open_edges = crest_spacing(surface, 1.0, 270.0, (True, False))
    assert open_edges.mean == pytest.approx(np.mean(gaps[:3]), rel=0.01)
    assert open_edges.spread == pytest.approx(np.std(gaps[:3]), rel=0.01)


def test_small_ripples_on_dunes_are_not_counted():
    surface = 3.0 * ridges(4, 0) + 0.1 * sine(20, 0)
    assert crest_spacing(surface, 1.0, 270.0).mean == pytest.approx(20.0, rel=0.02)


def test_gaps_over_voids_are_left_out():
    surface = sine(8, 0)
    surface[:, 30:45] = np.nan
    assert crest_spacing(surface, 1.0, 270.0, (True, False)).mean == pytest.approx(10.0, rel=0.02)


@pytest.mark.parametrize("surface", [np.zeros((16, 16)), np.full((16, 16), np.nan), np.eye(1)])
def test_without_two_crests_there_is_no_spacing(surface):
    found = crest_spacing(surface, 1.0, 270.0, (False, False))
    assert np.isnan(found.mean)
    assert found.count == 0
