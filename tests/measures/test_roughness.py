"""Roughness of surfaces whose heights are known."""

import numpy as np
import pytest

from barchan.measures.roughness import frontal_area_index, roughness
from tests.measures.waves import ridges, sine


def test_roughness_of_noise_is_what_the_filter_takes_from_it():
    noise = np.random.default_rng(1).normal(0.0, 0.1, (200, 200))
    # a Gaussian of width w leaves 1 / (4 pi w^2) of white noise's variance, and is 1 / (2 pi w^2) at its
    # centre
    left = 1 - 2 / (2 * np.pi * 4) + 1 / (4 * np.pi * 4)
    assert roughness(noise) == pytest.approx(0.1 * np.sqrt(left), rel=0.02)


def test_a_long_wave_is_not_rough():
    assert roughness(sine(1, 0)) < 0.02
    assert np.isnan(roughness(np.full((4, 4), np.nan)))


def test_ridges_turn_their_height_over_their_spacing_to_the_wind():
    surface = 3.0 * ridges(5, 0)
    assert frontal_area_index(surface, 2.0, 270.0, width=0.0) == pytest.approx(
        np.ptp(surface) / 32.0, rel=0.01
    )
    assert frontal_area_index(surface, 2.0, 90.0, (True, False), 0.0) == pytest.approx(
        np.ptp(surface) / 32.0, rel=0.02
    )
    assert frontal_area_index(surface, 2.0, 0.0, width=0.0) == pytest.approx(0.0, abs=1e-9)
