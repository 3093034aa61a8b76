"""Winds one after the other."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import barchan
from barchan.errors import ScenarioError
from barchan.simulation import Simulation
from barchan.wind import Regime, Regimes
from barchan.wind.speed_ramps import Bezier
from tests.tiny import tiny
from tests.wind.blown import blown, forcing, segments


def winds(*regimes, repeat=True):
    return Regimes(kind="regimes", regimes=[Regime(**regime) for regime in regimes], repeat=repeat)


WEST_NORTH = winds({"direction": 270.0, "steps": 3}, {"direction": 0.0, "steps": 2, "speed": 4.0})
RISING = winds({"direction": 270.0, "steps": 4, "speed": 2.0, "final_speed": 10.0})


def test_winds_blow_in_turn_over_and_over():
    assert [direction for _, direction, _ in blown(WEST_NORTH, 0, 8)] == [270, 270, 270, 0, 0, 270, 270, 270]
    assert [speed for _, _, speed in blown(WEST_NORTH, 2, 3)] == [None, 4.0, 4.0]


def test_winds_that_do_not_repeat_go_on_as_they_ended():
    once = winds(
        {"direction": 90.0, "steps": 2},
        {"direction": 0.0, "steps": 2, "speed": 1.0, "final_speed": 3.0},
        repeat=False,
    )
    last = [speed for _, _, speed in blown(once, 3, 1)]
    assert (min(last), max(last)) == pytest.approx((2.0, 3.0), abs=0.03)
    assert blown(once, 4, 3) == [(4, 0.0, 3.0), (5, 0.0, 3.0), (6, 0.0, 3.0)]


def test_a_speed_that_changes_is_taken_in_the_middle_of_slices_of_a_step():
    speeds = [speed for _, _, speed in blown(RISING, 0, 1)]
    assert len(speeds) == 20
    assert speeds == pytest.approx(np.arange(20) * 0.1 + 2.05)


def test_slices_of_a_step_share_its_polls():
    slices = segments(RISING, 0, 1, cells=101)
    assert [s.first for s in slices] == list(np.cumsum([0, *(s.polls for s in slices)])[:-1])
    assert sum(s.polls for s in slices) == 101
    assert [s.ends for s in slices] == [False] * 19 + [True]


def test_a_speed_that_hardly_changes_within_a_step_needs_no_slices():
    slow = winds({"direction": 270.0, "steps": 1000, "speed": 2.0, "final_speed": 10.0})
    assert len(blown(slow, 0, 30)) == 30


def test_durations_in_seconds_need_not_be_whole_steps():
    wind = winds({"direction": 270.0, "seconds": 150.0}, {"direction": 0.0, "seconds": 100.0})
    found = segments(wind, 0, 5, step_seconds=100.0)
    assert [(s.step, s.steps, s.direction, s.polls) for s in found] == [
        (0, 1, 270.0, 100),
        (1, 1, 270.0, 50),
        (1, 1, 0.0, 50),
        (2, 1, 0.0, 50),
        (2, 1, 270.0, 50),
        (3, 1, 270.0, 100),
        (4, 1, 0.0, 100),
    ]


def test_a_cycle_shorter_than_a_step_blows_once_a_step():
    wind = winds({"direction": 270.0, "seconds": 10.0}, {"direction": 0.0, "seconds": 30.0})
    found = segments(wind, 7, 1, step_seconds=1000.0)
    assert [(s.direction, s.polls) for s in found] == [(270.0, 25), (0.0, 75)]


def test_the_wind_of_a_step_points_along_its_mean_transport():
    wind = winds({"direction": 270.0, "seconds": 50.0}, {"direction": 0.0, "seconds": 50.0})
    assert forcing(wind, step_seconds=100.0).wind_of(0).direction == pytest.approx(315.0)


def test_a_course_bends_the_change_over_the_regimes_own_duration():
    course = Bezier(kind="bezier", time_1=0.5, value_1=0.0, time_2=0.5, value_2=1.0)
    bent = winds(
        {"direction": 270.0, "steps": 50},
        {"direction": 0.0, "steps": 4, "speed": 2.0, "final_speed": 10.0, "speed_ramp": course},
    )
    early, late = ([speed for _, _, speed in blown(bent, step, 1)] for step in (50, 53))
    assert 2.0 < min(early) < max(early) < 4.0
    assert 8.0 < min(late) < max(late) < 10.0
    assert np.mean(early) + np.mean(late) == pytest.approx(12.0)


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
    before = simulation.bed.units
    simulation.advance(20)
    assert simulation.bed.units == before
    assert simulation.wind_direction == 91.5


def test_a_calm_moves_nothing_and_time_passes():
    points = [{"time": 0.01, "value": 9.0}, {"time": 0.99, "value": 9.0}]
    fade = {
        "direction": 270.0,
        "steps": 2,
        "speed": 1.0,
        "final_speed": 0.5,
        "speed_ramp": {"kind": "points", "points": points},
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
        ([{"direction": 0.0}], "neither steps nor seconds is given; give one of them"),
        ([{"direction": 0.0, "steps": 3, "seconds": 4.0}], "steps and seconds are both given"),
        ([{"direction": 0.0, "seconds": 4.0}], r"wind\.regimes\[0\]\.seconds: is 4 s, which needs a clock"),
        ([{"direction": 0.0, "steps": 3, "sped": 2.0}], r"did you mean 'speed'"),
    ],
)
def test_regimes_that_are_none_are_refused(regimes, said):
    with pytest.raises(ScenarioError, match=said):
        tiny(wind={"kind": "regimes", "regimes": regimes})
