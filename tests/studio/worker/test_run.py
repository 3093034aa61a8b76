import time

import numpy as np
import pytest

from barchan.errors import BarchanError
from barchan.simulation import SetParameter, Simulation
from barchan.studio.worker.branches import MOST
from barchan.studio.worker.run import StudioRun, started
from barchan.studio.worker.run_speed import RunSpeed
from tests.studio.conftest import small


def run_to(run: StudioRun, step: int) -> None:
    run.run(step)
    while run.busy:
        run.advance_chunk()


def test_a_branch_gives_the_bits_of_the_run_that_it_came_from(scenario):
    run = started(scenario)
    run_to(run, 60)
    sand = run.live.bed.sand.copy()
    run.look(30)
    assert run.status()["looking"]
    assert run.shown.steps_done == 30
    run.branch()
    assert run.history.steps == [0, 10, 20, 30]
    assert max(row["step"] for row in run.measures.rows) <= 30
    run_to(run, 60)
    assert np.array_equal(run.live.bed.sand, sand)


def test_a_branch_may_go_another_way_and_keeps_its_events(scenario):
    run = started(scenario)
    run_to(run, 40)
    run.look(20)
    run.branch()
    run.live.apply(SetParameter(key="model.hop_length", value=2.0))
    run_to(run, 40)
    other = Simulation(scenario)
    other.advance(20)
    other.apply(SetParameter(key="model.hop_length", value=2.0))
    other.advance(20)
    assert np.array_equal(run.live.bed.sand, other.bed.sand)


def test_branches_are_kept_and_gone_back_to(scenario):
    run = started(scenario)
    run_to(run, 40)
    first = run.live.bed.sand.copy()
    run.look(20)
    run.branch()
    run.live.apply(SetParameter(key="model.hop_length", value=2.0))
    run_to(run, 30)
    second = run.live.bed.sand.copy()
    assert run.branches.current == 2
    assert run.branches.listing(30) == [
        {"number": 1, "began": 0, "step": 40},
        {"number": 2, "began": 20, "step": 30},
    ]
    run.switch(1)
    assert np.array_equal(run.live.bed.sand, first)
    assert run.history.steps == [0, 10, 20, 30, 40]
    assert run.live.events == []
    run.switch(2)
    assert np.array_equal(run.live.bed.sand, second)
    assert not run.busy
    with pytest.raises(BarchanError, match="no branch 3; kept: 1, 2"):
        run.switch(3)


def test_the_branch_that_was_left_first_is_forgotten_beyond_the_most(scenario):
    run = started(scenario)
    run_to(run, 20)
    for _ in range(MOST):
        run.look(10)
        run.branch()
    assert [branch["number"] for branch in run.branches.listing(10)] == list(range(2, MOST + 2))


def test_pieces_of_any_length_give_the_bits_of_one_run(scenario):
    run = started(scenario)
    for step in (1, 2, 17, 35):
        run_to(run, step)
    whole = Simulation(scenario)
    whole.advance(35)
    assert np.array_equal(run.live.bed.sand, whole.bed.sand)


def test_looking_back_changes_nothing_of_the_run(scenario):
    run = started(scenario)
    run_to(run, 25)
    before = run.live.bed.sand.copy()
    run.look(10)
    assert run.status()["step"] == 10
    assert run.status()["live"] == 25
    run.look_now()
    assert np.array_equal(run.live.bed.sand, before)


def test_a_run_that_comes_to_rest_states_why_and_stops():
    run = started(small(sand={"mean": 0}, run={"steps": 100, "seed": 1, "until": {"idle_steps": 5}}))
    run_to(run, 50)
    assert not run.busy
    assert "nothing moved" in run.status()["finished"]


@pytest.mark.parametrize("limit", [20.0, 100.0])
def test_the_speed_limit_holds(scenario, limit):
    run = started(scenario)
    run_to(run, 5)
    run.speed.limit = limit
    run.run()
    began = time.perf_counter()
    while time.perf_counter() - began < 0.6:
        run.advance_chunk()
        time.sleep(min(run.speed.wait(), 0.05))
    done = run.live.steps_done - 5
    assert done <= limit * (time.perf_counter() - began) + 1


def test_a_speed_without_limit_never_waits():
    speed = RunSpeed(1.0)
    speed.limit = None
    assert speed.wait() == 0.0
    assert speed.steps == 1
    speed.record(1, 1e-3)
    assert speed.steps == 2


def test_measures_grow_with_the_run(scenario):
    run = started(scenario)
    run_to(run, 30)
    rows = run.measures.unsent()["measures"]
    assert rows[0]["step"] == 0
    assert rows[-1]["step"] == 30
    assert rows[-1]["values"]["highest_stack"] == run.live.bed.sand.max()
    assert rows[0]["values"]["speed"] is None
    assert rows[0]["doubts"]["speed"] == "no earlier frame to compare with"
    assert "highest_stack" not in rows[-1]["doubts"]
    assert run.measures.unsent() == {}


def test_a_branch_that_only_begins_does_not_let_the_run_count_as_one_that_has_not_begun():
    run = started(small())
    run_to(run, 20)
    run.look(0)
    run.branch()
    assert run.live.steps_done == 0
    assert run.would_be_missed


def test_the_status_says_how_many_winds_blew_in_the_step():
    steady = Simulation(small())
    mixed = Simulation(small(wind={"kind": "mixed_axes", "first": 270, "second": 180, "share": 0.4}))
    assert (steady.winds, mixed.winds) == (1, 2)
