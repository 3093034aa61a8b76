"""A wind is judged by all theories at once, from a record or a scenario."""

from dataclasses import replace

import numpy as np
import pytest

from barchan.aeolian import Saltation
from barchan.scenario import load_scenario
from barchan.theory.assessment import assess_record, assess_winds, scenario_drift
from tests.theory.winds import record
from tests.tiny import tiny


def test_a_steady_wind_gives_crests_across_it():
    found = assess_record(record([12.0, 3.0], [300.0, 10.0]), Saltation(), supply=0.5)
    assert found.drift.steadiness == pytest.approx(1.0)
    assert found.drift.toward == pytest.approx(120.0)
    assert found.gross_transport.azimuth == pytest.approx(30.0, abs=0.06)
    assert found.variability.name == "narrow unimodal"
    assert found.dunes == "barchans"


def test_drift_potential_is_of_the_wind_at_ten_metres():
    winds = record([9.0], [270.0])
    high, low = (assess_record(winds, Saltation(height=height)).potential.total for height in (10.0, 2.0))
    speed = 9.0 * np.log(10 / 1e-3) / np.log(2 / 1e-3) / (1852 / 3600)
    assert low == pytest.approx(speed**2 * (speed - 12))
    assert low > 2 * high


def test_a_wind_below_the_threshold_moves_nothing():
    found = assess_record(record([3.0], [270.0]), Saltation())
    assert not found.moves
    assert found.dunes == "none: nothing moves"


def test_the_winds_of_a_scenario_weigh_by_steps_and_hops():
    regimes = [
        {"direction": 270.0, "steps": 3, "speed": 4.0},
        {"direction": 0.0, "steps": 1, "speed": 6.0, "final_speed": 12.0},
        {"direction": 90.0, "steps": 1},
    ]
    wind = {"kind": "regimes", "regimes": regimes}
    drift = scenario_drift(tiny(wind=wind, run__steps=5, model__hop_length=5.0))
    weights = np.array([12.0, 9.0, 5.0])
    np.testing.assert_allclose(drift.amount, weights / weights.sum())
    assert drift.direction.tolist() == [270, 0, 90]


@pytest.mark.parametrize(
    ("preset", "steadiness"), [("barchans", 1.0), ("star", 0.0), ("linear", 0.5), ("opposite-winds", 0.0)]
)
def test_presets_have_the_winds_that_they_mention(preset, steadiness):
    assert scenario_drift(load_scenario(preset)).steadiness == pytest.approx(steadiness, abs=0.01)


def test_speeds_are_taken_from_the_height_of_the_record():
    winds = replace(record([9.0], [270.0]), height=2.0)
    speed = 9.0 * np.log(10 / 1e-3) / np.log(2 / 1e-3) / (1852 / 3600)
    found = assess_record(winds, Saltation())
    assert found.potential.total == pytest.approx(speed**2 * (speed - 12))
    assert found.drift.total == pytest.approx(
        assess_record(record([9.0], [270.0]), Saltation(height=2.0)).drift.total
    )


def test_a_stated_threshold_is_that_of_the_drift_potential():
    found = assess_record(record([9.0], [270.0]), Saltation(threshold=5.0))
    speed, least = 9.0 / (1852 / 3600), 5.0 / (1852 / 3600)
    assert found.threshold == pytest.approx(least)
    assert found.potential.total == pytest.approx(speed**2 * (speed - least))


def test_a_record_shorter_than_a_year_says_that_its_drift_potential_is_not_annual():
    short, long = (
        record(np.full(days, 9.0), np.full(days, 270.0), hours=np.full(days, 24)) for days in (10, 365)
    )
    assert (
        "spans 10 days: its drift potential is that of these days, not of a year"
        in assess_record(short, Saltation()).remarks[0]
    )
    assert not any("of a year" in remark for remark in assess_record(long, Saltation()).remarks)
    assert "means over so long hide strong winds" in assess_record(long, Saltation()).remarks[0]


KNOT = 1852 / 3600


def test_winds_in_metres_a_second_have_a_drift_potential_and_a_flux():
    """12 m/s for a third of the time and calm for the rest: a third of U² (U - 12) knots, and of the flux."""
    regimes = [
        {"direction": 225.0, "steps": 2, "speed": 12.0, "unit": "m/s"},
        {"direction": 0.0, "steps": 4, "speed": 0.0, "unit": "m/s"},
    ]
    found = assess_winds(tiny(wind={"kind": "regimes", "regimes": regimes}, clock={}, run__steps=12))
    assert found.potential.total == pytest.approx((12 / KNOT) ** 2 * (12 / KNOT - 12) / 3)
    assert found.potential.toward == pytest.approx(45.0)
    seconds_of_a_year = 365.25 * 86400
    assert found.drift.unit == "m²/yr"
    assert found.drift.total == pytest.approx(float(Saltation().volume_flux(12.0)) / 3 * seconds_of_a_year)


def test_winds_of_a_scenario_are_brought_from_the_height_of_its_clock_to_ten_metres():
    wind = {"kind": "steady", "speed": 9.0, "unit": "m/s"}
    found = assess_winds(tiny(wind=wind, clock={"height": 2.0, "roughness": 1e-3}))
    speed = 9.0 * np.log(10 / 1e-3) / np.log(2 / 1e-3) / KNOT
    assert found.potential.total == pytest.approx(speed**2 * (speed - 12))


def test_the_own_speed_of_a_grain_model_has_a_drift_potential():
    found = assess_winds(load_scenario("ripples"))
    assert found.potential.total == pytest.approx((12 / KNOT) ** 2 * (12 / KNOT - 12))


def test_winds_in_cells_have_no_drift_potential():
    assert assess_winds(load_scenario("barchans")).potential is None
