"""A wind that blows as it was recorded."""

import numpy as np
import pytest

from barchan.errors import ScenarioError
from barchan.simulation import Simulation
from barchan.wind import Recorded
from tests.tiny import tiny
from tests.wind.blown import forcing, segments

HOUR = 3600.0


@pytest.fixture
def hourly(tmp_path):
    """Six hours of wind: two calm, two weak, two strong."""
    path = tmp_path / "wind.csv"
    rows = [(0, 0), (0, 0), (4, 200), (4, 200), (10, 270), (12, 300)]
    lines = [f"2020-01-01T{hour:02}:00,{speed},{way}" for hour, (speed, way) in enumerate(rows)]
    path.write_text("\n".join(["time,speed (m/s),direction", *lines]) + "\n")
    return Recorded(kind="record", path=str(path))


def strength(speeds):
    return np.maximum(speeds - 6.0, 0.0) / 4.0


def test_winds_have_polls_in_proportion_to_the_sand_they_move(hourly):
    found = segments(hourly, 0, 6, step_seconds=HOUR, strength=strength)
    assert [(s.step, s.steps, s.polls) for s in found] == [
        (0, 1, 0),
        (1, 1, 0),
        (2, 1, 0),
        (3, 1, 0),
        (4, 1, 100),
        (5, 1, 150),
    ]
    assert [s.direction for s in found[4:]] == [270.0, 300.0]
    assert [s.speed for s in found] == [0.0, 0.0, 4.0, 4.0, 10.0, 12.0]


def test_a_step_that_covers_many_winds_has_them_in_order(hourly):
    found = segments(hourly, 0, 1, step_seconds=6 * HOUR, strength=strength)
    assert [s.polls for s in found] == [0, 0, 0, 0, 16, 25]
    assert sum(s.share for s in found) == pytest.approx(1.0)


def test_a_step_within_one_wind_takes_its_share_and_steps_go_together(hourly):
    found = segments(hourly, 16, 8, step_seconds=HOUR / 4, strength=strength)
    assert [(s.step, s.steps, s.polls, s.direction) for s in found] == [
        (16, 4, 100, 270.0),
        (20, 4, 150, 300.0),
    ]


def test_a_record_starts_over_at_its_end(hourly):
    found = segments(hourly, 1, 1, step_seconds=5 * HOUR, strength=strength)
    assert [(s.direction, round(s.share, 9)) for s in found] == [
        (300.0, 0.2),
        (0.0, 0.2),
        (0.0, 0.2),
        (200.0, 0.2),
        (200.0, 0.2),
    ]


def test_a_record_that_does_not_start_over_ends_in_a_calm(hourly):
    once = hourly.model_copy(update={"repeat": False})
    found = segments(once, 1, 4, step_seconds=5 * HOUR, strength=strength)
    assert [(s.step, s.steps, s.polls) for s in found] == [(1, 1, 30), (1, 1, 0), (2, 3, 0)]


def test_a_step_longer_than_the_record_blows_it_once(hourly):
    found = segments(hourly, 3, 1, step_seconds=600 * HOUR, strength=strength)
    assert [s.polls for s in found] == [0, 0, 0, 0, 17, 25]


def test_winds_are_picked_by_the_sand_they_move():
    few = Recorded(kind="record", winds=4)
    clock = {"step_seconds": 40 * 86400.0, "strength": strength, "cells": 100_000}
    all_winds = Recorded(kind="record", winds=100_000)
    totals, means = [], []
    for wind in (few, all_winds):
        found = [s for seed in range(1, 31) for s in segments(wind, 2, 1, seed=seed, **clock)]
        angles = np.radians([s.direction for s in found])
        polls = np.array([s.polls for s in found])
        totals.append(polls.sum() / 30)
        means.append(np.dot(polls, np.exp(1j * angles)) / polls.sum())
    assert len(segments(few, 2, 1, **clock)) <= 4
    assert totals[0] == pytest.approx(totals[1], abs=2)
    assert abs(means[0] - means[1]) < 0.1


def test_the_wind_of_a_step_is_that_of_all_its_winds():
    few, all_winds = (forcing(Recorded(kind="record", winds=n), 40 * 86400.0, strength) for n in (1, 100_000))
    assert few.wind_of(5) == all_winds.wind_of(5)


def test_a_record_drives_a_run_the_same_after_any_interruption():
    scenario = tiny(wind={"kind": "record"}, clock={"reference_speed": 7.0})
    whole, parts = Simulation(scenario), Simulation(scenario)
    whole.advance(12)
    for steps in (1, 5, 2, 4):
        parts.advance(steps)
        parts = Simulation.from_state(parts.state())
    assert whole.tally.moved > 0
    assert whole.tally == parts.tally
    np.testing.assert_array_equal(whole.bed.sand, parts.bed.sand)


def test_a_record_that_cannot_be_read_is_named_with_its_key(tmp_path):
    bad = tmp_path / "wind.csv"
    bad.write_text("time,speed,direction\n2020-01-01T00:00,5,400\n2020-01-01T01:00,-5,40\n")
    said = r"wind\.path: row 3, column 'speed': is -5.*\n.*wind\.path: row 2, column 'direction': is 400"
    with pytest.raises(ScenarioError, match=said):
        Simulation(tiny(wind={"kind": "record", "path": str(bad)}, clock={}))
    with pytest.raises(ScenarioError, match=r"wind\.path: no such file"):
        Simulation(tiny(wind={"kind": "record", "path": str(tmp_path / "none.csv")}, clock={}))


def test_a_record_needs_a_clock():
    with pytest.raises(ScenarioError, match=r"wind\.kind: is a record, whose winds need a clock"):
        tiny(wind={"kind": "record"})


def low(folder, height):
    """Six hours of 8 m/s at a height that the file states."""
    rows = "\n".join(f"2020-01-01T{hour:02}:00,8,270" for hour in range(6))
    path = folder / "low.csv"
    path.write_text(f"time,ws_{height}m (m/s),wd\n{rows}\n")
    return {"kind": "record", "path": str(path)}


def test_speeds_at_the_height_of_the_record_are_brought_to_that_of_the_clock(tmp_path):
    """By the law of the wall over 1 mm: ln(10 m / 1 mm) over ln(2 m / 1 mm) times faster."""
    scenario = tiny(wind=low(tmp_path, 2), clock={})
    blows = next(iter(scenario.seeded().forcing().segments(0, 1)))
    faster = np.log(10 / 1e-3) / np.log(2 / 1e-3)
    assert [segment.speed for segment in blows] == pytest.approx([8 * faster] * len(blows))


def test_a_record_at_a_height_that_cannot_be_brought_to_another_is_refused(tmp_path):
    wind = low(tmp_path, 0.5)
    said = r"wind\.columns\.height: the record's height is 0.5 m; allowed: above the roughness length, 1 m"
    with pytest.raises(ScenarioError, match=said):
        list(tiny(wind=wind, clock={"roughness": 1.0}).seeded().forcing().segments(0, 1))
    with pytest.raises(ScenarioError, match=r"is 0.5 m; allowed without a clock: winds at 10 m"):
        segments(Recorded(**wind), 0, 1, step_seconds=HOUR, strength=strength)
