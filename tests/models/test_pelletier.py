"""The shear stress over a surface, by linear theory."""

import numpy as np
import pytest

from barchan.aeolian.flow_over_relief import stress_coefficients
from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.models.pelletier import Pelletier


def wave(lattice, length, height, angle=0.0):
    """A sine wave that runs at an angle (degrees) to east."""
    x, y = np.meshgrid(lattice.x, lattice.y)
    towards = np.radians(angle)
    return height * np.cos(2 * np.pi / length * (x * np.cos(towards) + y * np.sin(towards)))


def stress_over(surface, lattice, direction=270.0, **parameters):
    model = Pelletier(Pelletier.Parameters(smoothing=0.0, **parameters), lattice)
    return model.stress(Bed(lattice, surface, np.zeros(lattice.shape)), direction)


@pytest.mark.parametrize(
    ("ratio", "a", "b"), [(1e3, 4.79, 3.10), (1e4, 4.51, 2.52), (1e5, 4.16, 1.88), (1e6, 3.86, 1.40)]
)
def test_coefficients_are_those_of_the_reference(ratio, a, b):
    assert stress_coefficients(ratio) == pytest.approx((a, b), abs=0.006)


def test_stress_over_a_sine_is_that_of_linear_theory():
    lattice = Lattice(rows=16, columns=256)
    length, height = 64.0, 0.1
    stress = stress_over(wave(lattice, length, height), lattice, roughness=0.01)
    a, b = stress_coefficients(length / 0.01)
    k = 2 * np.pi / length
    expected = 1 + k * height * (a * np.cos(k * lattice.x) - b * np.sin(k * lattice.x))
    np.testing.assert_allclose(stress, np.tile(expected, (16, 1)), atol=1e-9)


def test_stress_is_greatest_upwind_of_the_crest_from_wherever_the_wind_blows():
    lattice = Lattice(rows=64, columns=64)
    for direction, shift in ((270.0, -1), (90.0, 1)):
        stress = stress_over(wave(lattice, 64.0, 0.1), lattice, direction)[0]
        crest = 0 if wave(lattice, 64.0, 0.1)[0, 0] > 0 else 32
        lead = (stress.argmax() - crest + 32) % 64 - 32
        assert lead * shift > 0


def test_ridges_along_the_wind_leave_the_stress_alone():
    lattice = Lattice(rows=64, columns=64)
    np.testing.assert_allclose(stress_over(wave(lattice, 32.0, 0.3, 90.0), lattice), 1.0, atol=1e-9)


def test_a_turned_field_under_a_turned_wind_has_the_turned_stress():
    lattice = Lattice(rows=64, columns=64)
    surface = np.random.default_rng(1).normal(size=(64, 64)) * 0.01
    west = stress_over(surface, lattice, 270.0)
    south = stress_over(np.rot90(surface, axes=(1, 0)), lattice, 180.0)
    np.testing.assert_allclose(south, np.rot90(west, axes=(1, 0)), atol=1e-9)


def test_steep_windward_slopes_gain_no_more():
    lattice = Lattice(rows=8, columns=128)
    surface = wave(lattice, 64.0, 8.0)
    free = stress_over(surface, lattice, saturation_angle=89.0)
    held = stress_over(surface, lattice, saturation_angle=20.0)
    assert held.max() < free.max()


def test_open_edges_see_no_hill_from_the_other_side():
    surface = np.zeros((32, 128))
    surface[:, 118:126] = 3.0
    periodic = stress_over(surface, Lattice(rows=32, columns=128))
    opened = stress_over(surface, Lattice(rows=32, columns=128, boundary_x="open"))
    assert np.abs(opened[:, :4] - 1).max() < np.abs(periodic[:, :4] - 1).max()
