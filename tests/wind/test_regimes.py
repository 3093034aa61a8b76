"""Winds one after the other."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import barchan
from barchan.errors import ScenarioError
from barchan.simulation import Simulation
from barchan.wind import Regime, Regimes
from barchan.wind.courses import Bezier
from tests.tiny import tiny


def winds(*regimes, repeat=True):
    return Regimes(kind="regimes", regimes=[Regime(**regime) for regime in regimes], repeat=repeat)


WEST_NORTH = winds({"direction": 270.0, "steps": 3}, {"direction": 0.0, "steps": 2, "speed": 4.0})
RISING = winds({"direction": 270.0, "steps": 4, "speed": 2.0, "final_speed": 10.0})


def blown(wind, step, steps):
    """(step, direction, speed) of every single step."""
    return [
        (segment.step + k, segment.direction, segment.hop_length)
        for segment in wind.segments(step, steps, 100)
        for k in range(segment.steps)
    ]


def test_winds_blow_in_turn_over_and_over():
    assert [direction for _, direction, _ in blown(WEST_NORTH, 0, 8)] == [270, 270, 270, 0, 0, 270, 270, 270]
    assert [speed for _, _, speed in blown(WEST_NORTH, 2, 3)] == [None, 4.0, 4.0]


def test_winds_that_do_not_repeat_go_on_as_they_ended():
    once = winds(
        {"direction": 90.0, "steps": 2},
        {"direction": 0.0, "steps": 2, "speed": 1.0, "final_speed": 3.0},
        repeat=False,
    )
    assert blown(once, 3, 4) == [(3, 0.0, 2.5), (4, 0.0, 3.0), (5, 0.0, 3.0), (6, 0.0, 3.0)]


def test_a_speed_that_changes_is_taken_in_the_middle_of_each_step():
    assert [speed for _, _, speed in blown(RISING, 0, 5)] == [3.0, 5.0, 7.0, 9.0, 3.0]


def test_a_course_bends_the_change_over_the_regimes_own_duration():
    course = Bezier(kind="bezier", time_1=0.5, value_1=0.0, time_2=0.5, value_2=1.0)
    bent = winds(
        {"direction": 270.0, "steps": 50},
        {"direction": 0.0, "steps": 4, "speed": 2.0, "final_speed": 10.0, "course": course},
    )
    speeds = [speed for _, _, speed in blown(bent, 50, 4)]
    assert speeds[0] < 3.0
    assert speeds[3] > 9.0
    assert speeds[0] + speeds[3] == pytest.approx(12.0)


@given(st.integers(0, 60), st.integers(1, 40), st.integers(0, 40))
def test_segments_do_not_depend_on_where_they_are_cut(step, steps, cut):
    wind = winds(
        {"direction": 270.0, "steps": 7, "speed": 2.0, "final_speed": 3.0}, {"direction": 10.0, "steps": 4}
    )
    cut = min(cut, steps)
    assert blown(wind, step, steps) == blown(wind, step, cut) + blown(wind, step + cut, steps - cut)


def test_sand_is_kept_when_the_wind_turns_at_every_step():
    wind = {"kind": "regimes", "regimes": [{"direction": d, "steps": 1} for d in (270.0, 13.0, 200.0, 91.5)]}
    simulation = Simulation(tiny(wind=wind))
    before = simulation.bed.slabs
    simulation.advance(20)
    assert simulation.bed.slabs == before
    assert simulation.wind_direction == 91.5


def test_a_calm_moves_nothing_and_time_passes():
    fade = {
        "direction": 270.0,
        "steps": 2,
        "speed": 1.0,
        "final_speed": 0.5,
        "course": {"kind": "points", "points": [{"time": 0.01, "value": 9.0}, {"time": 0.99, "value": 9.0}]},
    }
    simulation = Simulation(tiny(wind={"kind": "regimes", "regimes": [fade]}))
    assert simulation.advance(4).moved == 0
    assert simulation.steps_done == 4


def test_interrupted_and_uninterrupted_runs_agree_under_changing_winds():
    wind = {
        "kind": "regimes",
        "regimes": [
            {"direction": 270.0, "steps": 5},
            {"direction": 0.0, "steps": 3, "speed": 2.0, "final_speed": 6.0},
        ],
    }
    whole, parts = Simulation(tiny(wind=wind)), Simulation(tiny(wind=wind))
    whole.advance(19)
    for steps in (1, 6, 2, 10):
        parts.advance(steps)
        parts = Simulation.from_state(parts.state())
    np.testing.assert_array_equal(whole.bed.sand, parts.bed.sand)
    assert whole.tally == parts.tally


def test_frames_tell_the_wind_that_made_them():
    wind = {"kind": "regimes", "regimes": [{"direction": 270.0, "steps": 5}, {"direction": 0.0, "steps": 5}]}
    dataset = barchan.simulate(tiny(wind=wind))
    assert dataset["wind_direction"].values.tolist() == [270.0, 270.0, 0.0, 270.0, 0.0]
    np.testing.assert_array_equal(dataset["step"], [0, 5, 10, 15, 20])


@pytest.mark.parametrize(
    ("regimes", "said"),
    [
        ([], r"wind\.regimes"),
        ([{"direction": 400.0, "steps": 3}], r"wind\.regimes\[0\]\.direction: is 400"),
        ([{"direction": 0.0, "steps": 0}], r"wind\.regimes\[0\]\.steps"),
        ([{"direction": 0.0, "steps": 3, "final_speed": 2.0}], "final_speed 2.0 is given without speed"),
        ([{"direction": 0.0, "steps": 3, "sped": 2.0}], r"did you mean 'speed'"),
    ],
)
def test_regimes_that_are_none_are_refused(regimes, said):
    with pytest.raises(ScenarioError, match=said):
        tiny(wind={"kind": "regimes", "regimes": regimes})
