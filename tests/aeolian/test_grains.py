"""The fall of grains, and the thresholds at which the wind moves them."""

import numpy as np
import pytest
from scipy.optimize import brentq

from barchan.aeolian.grains import GRAVITY, VISCOSITY, bagnold_threshold, settling_speed, shao_lu

QUARTZ, AIR = 2650.0, 1.225


@pytest.mark.parametrize(
    ("diameter", "air", "cohesive", "loose"), [(0.15e-3, 1.16, 0.250, 0.183), (0.25e-3, 1.225, 0.278, 0.230)]
)
def test_thresholds_of_sand_are_those_worked_out_by_hand(diameter, air, cohesive, loose):
    assert shao_lu(diameter, QUARTZ, air) == pytest.approx(cohesive, abs=0.0005)
    assert bagnold_threshold(diameter, QUARTZ, air) == pytest.approx(loose, abs=0.0005)


def test_cohesion_makes_dust_harder_to_lift_than_fine_sand():
    diameters = np.geomspace(0.02e-3, 1e-3, 400)
    thresholds = shao_lu(diameters, QUARTZ, AIR)
    easiest = diameters[np.argmin(thresholds)]
    assert easiest == pytest.approx(np.sqrt(3e-4 / (QUARTZ * GRAVITY)), rel=0.02)
    assert 0.07e-3 < easiest < 0.12e-3
    assert thresholds[0] > 1.5 * thresholds.min()


@pytest.mark.parametrize("diameter", [0.02e-3, 0.15e-3, 0.25e-3, 1e-3])
def test_a_falling_grains_weight_is_its_drag(diameter):
    def surplus(speed):
        reynolds = speed * diameter * AIR / VISCOSITY
        drag = ((32 / reynolds) ** (2 / 3) + 1) ** 1.5
        return 4 / 3 * (QUARTZ / AIR - 1) * GRAVITY * diameter - drag * speed**2

    assert settling_speed(diameter, QUARTZ, AIR) == pytest.approx(brentq(surplus, 1e-6, 100.0), rel=0.03)


def test_dust_settles_as_stokes_says():
    stokes = (QUARTZ - AIR) * GRAVITY * 4e-6**2 / (18 * VISCOSITY)
    assert settling_speed(4e-6, QUARTZ, AIR) == pytest.approx(stokes * 24 / 32, rel=0.05)
