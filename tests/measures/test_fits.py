"""Laws are found again in values made from them, and intervals hold them as often as they say."""

import numpy as np
import pytest

from barchan.measures.fits import power_law, speed_size
from barchan.measures.trends import coarsening, steadiness


def test_an_exact_power_law_is_found():
    x = np.geomspace(1, 100, 12)
    found = power_law(x, 3.0 * x**0.4)
    assert found.factor == pytest.approx(3.0)
    assert (found.exponent.low, found.exponent.value, found.exponent.high) == pytest.approx((0.4, 0.4, 0.4))


def test_the_interval_of_an_exponent_holds_it_in_95_of_100_cases():
    rng, x = np.random.default_rng(3), np.geomspace(1, 100, 10)
    held = 0
    for _ in range(400):
        exponent = power_law(x, x**0.5 * np.exp(rng.normal(0, 0.1, 10))).exponent
        held += exponent.low < 0.5 < exponent.high
    assert held / 400 == pytest.approx(0.95, abs=0.033)  # three standard errors of a share of 400


def test_values_that_follow_each_other_closely_count_as_fewer():
    rng = np.random.default_rng(5)
    rest = np.zeros(400)
    for at in range(1, 400):
        rest[at] = 0.8 * rest[at - 1] + rng.normal(0, 0.02)
    t = np.geomspace(10, 1000, 400)
    found = coarsening(t, t**0.33 * np.exp(rest))
    assert found.count == pytest.approx(400 * 0.2 / 1.8, rel=0.4)
    assert found.exponent.low < 0.33 < found.exponent.high


def test_coarsening_looks_at_its_window_alone():
    t = np.arange(1.0, 101.0)
    sizes = np.where(t < 20, 5.0, 5.0 * (t / 20) ** 0.5)
    assert coarsening(t, sizes, first=20).exponent.value == pytest.approx(0.5)
    assert coarsening(t, sizes, last=15).exponent.value == pytest.approx(0.0, abs=1e-12)
    assert np.isnan(coarsening(t, sizes, first=99).exponent.value)


def test_speed_falls_with_height_as_the_law_says():
    heights = np.array([1.0, 2.0, 3.0, 5.0, 8.0])
    found = speed_size(heights, 85.0 / (heights + 0.4))
    assert found.flux.value == pytest.approx(85.0)
    assert found.offset.value == pytest.approx(0.4)


def test_the_intervals_of_the_law_hold_it_in_95_of_100_cases():
    rng = np.random.default_rng(1)
    held = np.zeros(2)
    for _ in range(200):
        heights = rng.uniform(1.0, 8.0, 40)
        found = speed_size(heights, 85.0 / (heights + 0.4) * np.exp(rng.normal(0.0, 0.05, 40)))
        held += [
            found.flux.low < 85.0 < found.flux.high,
            found.offset.low < 0.4 < found.offset.high,
        ]
    assert held / 200 == pytest.approx([0.95, 0.95], abs=0.046)  # three standard errors of a share of 200


@pytest.mark.parametrize("speeds", [[1.0, 2.0, 3.0, 4.0], [1.0, np.nan, np.nan, 1.0]])
def test_dunes_that_are_not_slower_for_their_height_have_no_law(speeds):
    assert np.isnan(speed_size(np.arange(1.0, 5.0), np.array(speeds)).flux.value)


def test_a_straight_rise_drifts_by_what_it_rises():
    t = np.arange(101.0)
    found = steadiness(t, 1.0 + t / 100.0, 50.0)
    assert found.mean == pytest.approx(1.75)
    assert found.spread == pytest.approx(0.5 / 1.75)
    assert found.drift == pytest.approx(0.5 / 1.75)
    still = steadiness(t, np.full(101, 3.0), 50.0)
    assert (still.spread, still.drift) == pytest.approx((0.0, 0.0))
    assert np.isnan(steadiness(t, np.where(t > 90, np.nan, 1.0), 50.0).spread)
    assert np.isnan(steadiness(np.zeros(0), np.zeros(0), 1.0).mean)
