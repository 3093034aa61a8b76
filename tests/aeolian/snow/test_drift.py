"""Right values: the published formulas worked out by hand."""

import numpy as np
import pytest

from barchan.aeolian.snow.drift import log_law, pomeroy_gray, saltating, sorensen


def test_no_flux_at_or_below_the_threshold():
    for law in (sorensen, pomeroy_gray):
        assert not law(np.array([0.1, 0.23]), 0.23, 1.2).any()


def test_sorensen_by_hand():
    # V = 2: (1.2 / 9.81) 0.4³ (1 - 1/4) (2.6 + 2.5/4 + 2/2) = 0.0078287 · 0.75 · 4.225
    assert sorensen(np.array(0.4), 0.2, 1.2) == pytest.approx(0.024807, rel=1e-4)


def test_pomeroy_and_gray_by_hand():
    # 0.68 · 1.2 / 9.81 · 0.2 / 0.4 · (0.16 - 0.04)
    assert pomeroy_gray(np.array(0.4), 0.2, 1.2) == pytest.approx(0.0049908, rel=1e-4)


def test_saltation_makes_the_bed_rougher():
    assert log_law(10.0, 2.4e-4) == pytest.approx(0.3761, abs=1e-4)
    assert saltating(10.0, 2.4e-4) == pytest.approx(0.02264 * 10**1.295)
    assert 1.15 < saltating(10.0, 2.4e-4) / log_law(10.0, 2.4e-4) < 1.4
