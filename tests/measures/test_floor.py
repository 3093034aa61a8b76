"""The floor under bedforms that stand on a known one."""

import numpy as np
import pytest

from barchan.measures.floor import floor_beneath, floor_share
from tests.measures.waves import hill, sine


def test_the_floor_beneath_a_hill_on_a_tilt_is_the_tilt():
    tilt = 0.05 * np.arange(80) * np.ones((48, 1))
    found = floor_beneath(tilt + 5.0 * hill(24, 40, size=3.0), 14, (False, False), width=0.0)
    assert found[:, 20:60] == pytest.approx(tilt[:, 20:60], abs=0.1)


def test_the_floor_of_waves_is_a_fifth_and_of_single_hills_most():
    # a sine is below a tenth of its relief for arccos(0.8) / pi of its period
    assert floor_share(sine(2, 0), 20, width=0.0) == pytest.approx(np.arccos(0.8) / np.pi, abs=0.03)
    assert floor_share(hill(24, 40), 20, width=0.0) > 0.8
    assert np.isnan(floor_share(np.zeros((16, 16)), 4))


def test_voids_are_no_floor():
    surface = sine(2, 0)
    surface[:10] = np.nan
    assert np.isnan(floor_beneath(surface, 20)[:10]).all()
    assert floor_share(surface, 20, width=0.0) == pytest.approx(np.arccos(0.8) / np.pi, abs=0.03)
