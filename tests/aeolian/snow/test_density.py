"""Right values: the published formulas worked out by hand."""

import math

import numpy as np
import pytest

from barchan.aeolian.snow.density import (
    PACKING,
    clm5,
    drift_density,
    hedstrom_pomeroy,
    pahaut,
)


@pytest.mark.parametrize(("temperature", "density"), [(0, 119.2), (-5, 75.4), (-10, 69.0), (-20, 67.9)])
def test_fresh_snow_by_hedstrom_and_pomeroy(temperature, density):
    assert hedstrom_pomeroy(temperature, 5.0) == pytest.approx(density, abs=0.05)


@pytest.mark.parametrize(("temperature", "density"), [(-15, 50.0), (-20, 63.3), (-30, 85.0)])
def test_fresh_snow_in_cold_still_air_by_clm5(temperature, density):
    assert clm5(temperature, 0.0) - 266.861 * 0.5**8.8 == pytest.approx(density, abs=0.05)


@pytest.mark.parametrize(("wind", "more"), [(5.0, 87.0), (10.0, 228.0)])
def test_wind_packs_fresh_snow_in_clm5(wind, more):
    assert clm5(-20.0, wind) - 63.3 == pytest.approx(more, abs=2.0)


def test_pahaut_has_a_least_density():
    assert pahaut(-20.0, 0.0) == 50.0
    assert pahaut(0.0, 4.0) == pytest.approx(161.0)


@pytest.mark.parametrize(("wind", "density"), [(4.0, 250.3), (7.0, 338.1), (10.0, 394.0)])
def test_drift_is_denser_in_stronger_wind(wind, density):
    assert drift_density(wind, 150.0, 400.0) == pytest.approx(density, abs=0.1)


def test_drift_keeps_within_its_bounds():
    assert drift_density(0.5, 150.0, 400.0) == 150.0
    assert drift_density(30.0, 150.0, 400.0) == 400.0


def test_viscosities_by_hand():
    density = np.array([100.0, 300.0])
    vionnet, anderson = PACKING["vionnet"][0], PACKING["anderson"][0]
    by_hand = [7.62237e6 * 4 * r / 450 * math.exp(1.0 + 0.023 * r) for r in density]
    np.testing.assert_allclose(vionnet(density, -10.0), by_hand, rtol=1e-12)
    np.testing.assert_allclose(anderson(density, -10.0), 9e5 * np.exp([3.1, 7.7]), rtol=1e-12)


def test_only_anderson_settles_without_load_and_less_above_100():
    density = np.array([80.0, 200.0])
    settling = PACKING["anderson"][1](density, -10.0)
    np.testing.assert_allclose(settling, 2.778e-6 * np.exp([-0.4, -0.4 - 4.6]), rtol=1e-12)
    assert not PACKING["vionnet"][1](density, -10.0).any()
