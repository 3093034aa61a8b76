"""Drift of winds whose answer is known."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import i0, i1

from barchan.aeolian import Saltation
from barchan.theory.drift import KNOT, YEAR, drift_of, drift_potential, energy, in_metres, sand_flux
from tests.theory.winds import record


@pytest.mark.parametrize(
    ("winds", "steadiness", "toward"),
    [
        ([(270.0, 2.0)], 1.0, 90.0),
        ([(350.0, 1.0), (350.0, 5.0)], 1.0, 170.0),
        ([(0.0, 1.0), (180.0, 1.0)], 0.0, np.nan),
        ([(0.0, 1.0), (90.0, 1.0)], 2**-0.5, 225.0),
        ([(0.0, 1.0), (120.0, 1.0), (240.0, 1.0)], 0.0, np.nan),
        ([(0.0, 3.0), (180.0, 1.0)], 0.5, 180.0),
        ([(210.0, 1.0), (330.0, 1.0)], 0.5, 90.0),
    ],
)
def test_winds_add_as_vectors(winds, steadiness, toward):
    drift = drift_of(winds)
    assert drift.steadiness == pytest.approx(steadiness, abs=1e-12)
    assert drift.toward == pytest.approx(toward, nan_ok=True)
    assert drift.total == sum(amount for _, amount in winds)


@pytest.mark.parametrize("kappa", [0.1, 1.0, 4.0, 20.0])
def test_winds_spread_as_von_mises_are_as_steady_as_his_first_moment(kappa):
    degrees = np.arange(0.0, 360.0, 0.5)
    density = np.exp(kappa * np.cos(np.radians(degrees - 200.0)))
    drift = drift_of([*zip(degrees, density, strict=True)])
    assert drift.steadiness == pytest.approx(i1(kappa) / i0(kappa), rel=1e-9)
    assert drift.toward == pytest.approx(20.0)
    assert drift.by_degree().steadiness == pytest.approx(drift.steadiness, rel=1e-3)


@given(
    st.lists(st.tuples(st.floats(0, 359.9), st.floats(0, 100)), min_size=1, max_size=20), st.floats(0, 360)
)
def test_turning_the_compass_turns_the_drift_only(winds, turn):
    drift = drift_of(winds)
    turned = drift_of([((direction + turn) % 360, amount) for direction, amount in winds])
    assert turned.total == pytest.approx(drift.total)
    assert turned.resultant == pytest.approx(drift.resultant, abs=1e-9 * (1 + drift.total))
    assert 0 <= drift.resultant <= drift.total * (1 + 1e-12)


def test_nothing_moves_in_a_calm():
    still = drift_potential(record([3.0, 0.0], 270.0))
    assert still.total == 0
    assert np.isnan(still.steadiness)
    assert np.isnan(still.toward)


def test_drift_potential_is_in_knots_and_shares_of_the_time():
    winds = record([20 * KNOT, 12 * KNOT, 30 * KNOT, 5.0], [90.0, 10.0, 90.0, 10.0], hours=[1, 2, 1, 6])
    expected = 20**2 * 8 * 0.1 + 30**2 * 18 * 0.1
    assert drift_potential(winds).total == pytest.approx(expected)
    assert drift_potential(winds).toward == pytest.approx(270.0)


def test_energy_classes_in_metres_are_those_of_bullard():
    assert [round(in_metres(limit)) for limit in (200.0, 400.0)] == [27, 54]
    assert [energy(potential) for potential in (0.0, 199.0, 200.0, 399.0, 400.0, 4000.0)] == [
        "low",
        "low",
        "intermediate",
        "intermediate",
        "high",
        "high",
    ]


def test_the_flux_of_a_year_is_the_mean_flux_times_a_year():
    sand = Saltation(law="owen")
    winds = record([12.0, 2.0], [270.0, 90.0], hours=[3, 1])
    drift = sand_flux(winds, sand)
    assert drift.total == pytest.approx(0.75 * sand.volume_flux(12.0) * YEAR)
    assert drift.unit == "m²/yr"
