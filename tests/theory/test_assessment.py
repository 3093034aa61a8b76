"""A wind is judged by all theories at once, from a record or a scenario."""

import numpy as np
import pytest

from barchan.aeolian import Saltation
from barchan.scenario import load_scenario
from barchan.theory.assessment import assess_record, scenario_drift
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
