"""Flux laws against their published forms and against each other."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.aeolian.flux import LAWS, Sand, mass_flux
from barchan.aeolian.wall import friction_velocity

SAND = Sand()
SPEEDS = np.linspace(0.0, 2.0, 201)


@pytest.mark.parametrize("law", LAWS)
def test_no_law_moves_sand_at_or_below_the_threshold(law):
    flux = mass_flux(law, SPEEDS, 0.25, SAND)
    assert not flux[SPEEDS <= 0.25].any()
    assert (flux[SPEEDS > 0.25] > 0).all()
    assert (np.diff(flux[SPEEDS > 0.25]) > 0).all()


@pytest.mark.parametrize(
    ("law", "expected"),
    [
        ("bagnold", 1.8 * 0.064),
        ("bagnold_threshold", 1.8 * 0.008),
        ("kawamura", 2.78 * 0.2 * 0.36),
        ("lettau", 6.7 * 0.16 * 0.2),
        ("tsoar", 6.7 * 0.16 * 0.2),
        ("owen", 5 * 0.16 * (0.16 - 0.0256)),
    ],
)
def test_laws_give_what_a_pocket_calculator_gives(law, expected):
    assert mass_flux(law, 0.4, 0.2, SAND) == pytest.approx(expected * 1.225 / 9.81)


def test_a_law_in_shields_numbers_agrees_with_its_form_in_velocities():
    density_ratio = SAND.grain_density / SAND.air_density
    coefficient = 7.8 * density_ratio / (density_ratio - 1)
    expected = coefficient / 5.0 * mass_flux("owen", SPEEDS, 0.25, SAND)
    np.testing.assert_allclose(mass_flux("quadratic", SPEEDS, 0.25, SAND), expected, rtol=1e-12)


def test_grains_that_collide_in_the_air_raise_the_exponent_from_two_to_four():
    strong = np.array([10.0, 20.0])
    for law, exponent in (("quadratic", 2), ("pahtz_duran", 4), ("kawamura", 3), ("bagnold", 3)):
        low, high = mass_flux(law, strong, 0.2, SAND)
        assert np.log2(high / low) == pytest.approx(exponent, abs=0.05)


def test_poorly_sorted_sand_moves_more():
    for law in ("bagnold", "tsoar"):
        uniform, dune, poor = (mass_flux(law, 0.5, 0.2, Sand(sorting=s)) for s in ("uniform", "dune", "poor"))
        assert uniform / dune == pytest.approx(1.5 / 1.8)
        assert poor / dune == pytest.approx(2.8 / 1.8)


@given(st.sampled_from(sorted(LAWS)), st.floats(0.1, 0.5), st.floats(0.51, 3.0))
def test_arrays_give_what_numbers_give(law, threshold, u):
    assert mass_flux(law, np.array([u, 0.05]), threshold, SAND).tolist() == [
        float(mass_flux(law, u, threshold, SAND)),
        0.0,
    ]


@pytest.mark.parametrize(("roughness", "expected"), [(1e-3, 0.434), (0.15e-3 / 30, 0.276)])
def test_the_law_of_the_wall_gives_the_shear_of_ten_metres_a_second(roughness, expected):
    assert friction_velocity(10.0, 10.0, roughness) == pytest.approx(expected, abs=0.0005)
