"""Thresholds by time and temperature, and by density, against published numbers."""

import pytest

from barchan.aeolian.snow.bonding import hourly_threshold_wind
from barchan.aeolian.snow.thresholds import li_pomeroy_median, li_pomeroy_spread, mar, normal_share, snowtran


@pytest.mark.parametrize(("hours", "wind"), [(1.0, 8.06), (6.0, 9.69), (24.0, 10.95), (108.0, 12.32)])
def test_medians_of_li_and_pomeroy_at_minus_ten(hours, wind):
    """11 - 3.65 + 0.706 = 8.056 m/s after an hour, and 0.91 ln t more after t hours."""
    assert float(li_pomeroy_median(-10.0, hours)) == pytest.approx(wind, abs=0.01)


def test_snow_drifts_in_half_the_cases_near_the_mean_threshold_of_the_same_authors():
    """9.43 + 0.18 T + 0.0033 T² of their other paper: 7.96 m/s at -10 °C."""
    assert float(li_pomeroy_median(-10.0, 1.0)) == pytest.approx(hourly_threshold_wind(-10.0), abs=0.2)


def test_spread_of_threshold_winds():
    """4.23 - 1.45 + 0.196 at -10 °C; a deviation of one leaves 15.9 % of winds below."""
    assert li_pomeroy_spread(-10.0) == pytest.approx(2.976)
    assert li_pomeroy_spread(5.0) == pytest.approx(4.23)
    assert normal_share(-1.0) == pytest.approx(0.158655, abs=1e-6)


@pytest.mark.parametrize(
    ("density", "ustar"), [(100.0, 0.135), (200.0, 0.182), (300.0, 0.246), (350.0, 0.473), (400.0, 0.906)]
)
def test_threshold_of_snowtran(density, ustar):
    assert float(snowtran(density)) == pytest.approx(ustar, abs=0.001)


@pytest.mark.parametrize(("density", "ustar"), [(300.0, 0.211), (350.0, 0.33), (400.0, 0.45), (450.0, 0.59)])
def test_threshold_of_mar(density, ustar):
    assert float(mar(density)) == pytest.approx(ustar, abs=0.005)
