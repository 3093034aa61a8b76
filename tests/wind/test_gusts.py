"""Gusts: a speed that varies about its mean, with a memory."""

import numpy as np
import pytest

from barchan.streams import Stream
from barchan.wind.gusts import MOST_SAMPLES, Gusts

STREAM = Stream(5, "gusts")
KINDS = ["normal", "lognormal", "weibull"]


def series(gusts, interval, count=8000):
    """Factors at the middle of short intervals."""
    return np.concatenate([gusts.factors(k * interval, interval, STREAM) for k in range(count)])


@pytest.mark.parametrize("kind", KINDS)
def test_gusts_have_a_mean_of_one_and_the_stated_intensity(kind):
    factors = series(Gusts(intensity=0.25, distribution=kind, correlation_time=10.0), 5.0)
    assert factors.mean() == pytest.approx(1.0, abs=0.02)
    assert factors.std() == pytest.approx(0.25, rel=0.04)
    assert factors.min() >= 0.0


def test_gusts_are_alike_within_the_correlation_time_and_forgotten_after_two():
    factors = series(Gusts(correlation_time=10.0), 1.0)
    at = [np.corrcoef(factors[lag:], factors[:-lag])[0, 1] for lag in (1, 10, 25)]
    assert at[0] > 0.95
    assert 0.1 < at[1] < 0.5
    assert abs(at[2]) < 0.08


def test_a_long_time_is_sampled_at_a_bounded_number_of_moments():
    assert len(Gusts(correlation_time=1.0).factors(0.0, 1e6, STREAM)) == MOST_SAMPLES


def test_gusts_do_not_depend_on_how_time_is_cut():
    gusts = Gusts(correlation_time=7.0)
    whole = gusts.factors(100.0, 14.0, STREAM)
    parts = [*gusts.factors(100.0, 7.0, STREAM), *gusts.factors(107.0, 7.0, STREAM)]
    assert whole.tolist() == parts


@pytest.mark.parametrize("kind", KINDS)
def test_no_intensity_is_no_gust(kind):
    assert Gusts(intensity=0.0, distribution=kind).factors(0.0, 3.0, STREAM).tolist() == [1.0]
