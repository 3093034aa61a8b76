"""The resultant wind is where the sand of a whole cycle of winds comes from, on the whole."""

import math

import pytest

from barchan.directions import bearing
from barchan.wind.resultant import resultant_direction
from tests.tiny import tiny

CLOCK = {"clock": {"grain_diameter": 0.00025, "reference_speed": 8.0}}


def resultant(step=0, usual_hop=1.0, **changes):
    return resultant_direction(tiny(**changes).forcing(), step, usual_hop)


def regimes(*winds, repeat=True):
    return {"kind": "regimes", "repeat": repeat, "regimes": list(winds)}


def wind(direction, steps, **more):
    return {"direction": direction, "steps": steps, **more}


@pytest.mark.parametrize("direction", [0.0, 33.0, 270.0])
@pytest.mark.parametrize("step", [0, 7])
def test_a_steady_wind_is_its_own_resultant(direction, step):
    assert resultant(step, wind__direction=direction, wind__spread=20.0) == pytest.approx(direction)


@pytest.mark.parametrize("step", [0, 5, 29, 30, 1000])
def test_winds_in_turn_count_by_their_duration_at_every_step(step):
    """20 steps eastwards and 10 northwards add up to the vector (20, 10)."""
    found = resultant(step, wind=regimes(wind(270.0, 20), wind(180.0, 10)))
    assert found == pytest.approx(bearing(20, 10))


def test_winds_count_by_the_length_of_their_hops():
    """10 steps of hops of 6 eastwards and of the usual 2 northwards: (60, 20)."""
    found = resultant(usual_hop=2.0, wind=regimes(wind(270.0, 10, speed=6.0), wind(180.0, 10)))
    assert found == pytest.approx(bearing(60, 20))


def test_a_calm_moves_nothing():
    assert resultant(wind=regimes(wind(270.0, 5), wind(90.0, 50, speed=0.0))) == pytest.approx(270.0)


def test_winds_that_cancel_have_no_resultant():
    assert math.isnan(resultant(wind=regimes(wind(270.0, 10), wind(90.0, 10))))


def test_a_cycle_that_ends_within_a_step_is_taken_whole():
    """3.5 steps eastwards and 4 northwards, with seconds of a step's length times as many."""
    second = tiny(**CLOCK).step_seconds
    winds = regimes(
        {"direction": 270.0, "seconds": 3.5 * second}, {"direction": 180.0, "seconds": 4 * second}
    )
    assert resultant(wind=winds, **CLOCK) == pytest.approx(bearing(3.5, 4.0), abs=1e-6)


def test_a_wind_that_never_comes_again_counts_until_now_and_goes_on_as_the_last():
    winds = regimes(wind(270.0, 10), wind(180.0, 10), repeat=False)
    assert resultant(4, wind=winds) == pytest.approx(270.0)
    assert resultant(14, wind=winds) == pytest.approx(bearing(10, 5))
    assert resultant(20, wind=winds) == pytest.approx(180.0)


def test_a_mixture_of_axes_has_the_direction_of_its_mean_transport():
    scenario = tiny(wind={"kind": "mixed_axes"})
    assert resultant(wind={"kind": "mixed_axes"}) == pytest.approx(scenario.wind.nominal_direction)


@pytest.mark.parametrize("step", [0, 5])
def test_rows_of_a_record_count_by_their_duration_whatever_steps_they_fill(step, tmp_path):
    """One hour eastwards, two northwards; the hour at 3 m/s moves no sand."""
    rows = [("00", 9, 270), ("01", 9, 180), ("02", 9, 180), ("03", 3, 90)]
    lines = [f"2024-01-01T{hour}:00,{speed},{direction}" for hour, speed, direction in rows]
    path = tmp_path / "wind.csv"
    path.write_text("\n".join(["time,speed (m/s),direction (deg)", *lines]))
    for seconds in (900.0, 2400.0, 20_000.0):
        clock = {"clock": {"grain_diameter": 0.00025, "step_seconds": seconds}}
        record = {"kind": "record", "path": str(path)}
        assert resultant(step, wind=record, **clock) == pytest.approx(bearing(1.0, 2.0), abs=1e-6)
