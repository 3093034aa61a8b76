"""Right values: the published formulas worked out with a pocket calculator, and published tables."""

import numpy as np
import pytest

from barchan.aeolian.snow.bonding import (
    LI_POMEROY_RATIO,
    bonding_rate,
    coordination_number,
    hourly_threshold_wind,
    threshold_stress,
    weight_threshold,
)

AIR = 1.2
WEIGHT = weight_threshold(1.5e-4, 0.5)


def threshold_wind(density, age, temperature):
    """Threshold wind (m/s at 10 m) in Li & Pomeroy's conversion from friction velocity."""
    stress = threshold_stress(density, age, temperature, air_density=AIR, weight=WEIGHT, exponent=0.27)
    return np.sqrt(stress / AIR) / LI_POMEROY_RATIO


@pytest.mark.parametrize(("temperature", "wind"), [(-1.0, 9.25), (-5.0, 8.61), (-10.0, 7.96), (-20.0, 7.15)])
def test_snow_an_hour_old_has_the_threshold_wind_of_li_and_pomeroy(temperature, wind):
    assert threshold_wind(100.0, 1.0, temperature) == pytest.approx(wind, abs=0.01)


@pytest.mark.parametrize(("age", "median"), [(1.0, 8.06), (6.0, 9.69), (24.0, 10.95), (108.0, 12.32)])
def test_ageing_follows_the_medians_of_li_and_pomeroy_at_minus_ten(age, median):
    assert threshold_wind(100.0, age, -10.0) == pytest.approx(median, abs=0.5)


def test_wet_snow_needs_a_wind_of_9_9_metres_a_second():
    assert hourly_threshold_wind(1.0) == 9.9


def test_grains_of_0_3_mm_withstand_0_04_pascal_by_weight():
    assert pytest.approx(0.0405, abs=1e-4) == WEIGHT


@pytest.mark.parametrize(
    ("temperature", "rate"), [(0.0, 1.99), (-5.0, 1.42), (-10.0, 1.0), (-20.0, 0.48), (-30.0, 0.21)]
)
def test_warm_snow_bonds_faster(temperature, rate):
    assert bonding_rate(temperature, 41_000.0) == pytest.approx(rate, abs=0.005)


def test_denser_snow_has_more_bonds_a_grain():
    density = np.array([50.0, 100.0, 350.0, 800.0])
    np.testing.assert_allclose(coordination_number(density), [0.875, 1.75, 2.973, 10.5], atol=2e-3)
