"""Measures at fixed steps: which steps they are, and what they give, depends on no clock."""

import threading
import time
from multiprocessing import Pipe

import pytest

from barchan.simulation import SetParameter
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.live_measures import ROWS, interval, next_step
from barchan.studio.worker.loop import run_measurer
from barchan.studio.worker.run import started
from tests.studio.conftest import small
from tests.studio.worker.test_run import run_to


def steps(run) -> list[int]:
    return [row["step"] for row in run.measures.rows]


def values(run) -> dict:
    return {row["step"]: row["values"] for row in run.measures.rows}


def test_the_interval_doubles_whenever_the_step_has_doubled():
    assert [interval(step, 20) for step in (0, 3999, 4000, 7999, 8000, 16000)] == [20, 20, 40, 40, 80, 160]
    found, step = 0, 0
    while step < 10**6:
        following = next_step(step, 20)
        assert following % interval(step, 20) == 0
        found, step = found + 1, following
    assert found <= ROWS * 5  # 200 at first, and 100 for each of the eight doublings of 4000 up to a million


def test_steps_and_values_do_not_depend_on_how_the_run_was_cut(scenario):
    """Every state is a function of scenario and step, and so must its measures be."""
    smooth, jerky = started(scenario), started(scenario)
    run_to(smooth, 60)
    for step in (3, 10, 11, 29, 60):
        run_to(jerky, step)
        jerky.pause()
    assert steps(smooth) == steps(jerky) == [0, 10, 20, 30, 40, 50, 60]
    assert values(smooth) == values(jerky)


def test_a_pause_is_measured_at_once_and_kept_apart(scenario):
    run = started(scenario)
    run_to(run, 13)
    found = run.measures.unsent()["measures"]
    assert [(row["step"], row.get("extra", False)) for row in found] == [(0, False), (10, False), (13, True)]
    assert steps(run) == [0, 10]


def test_a_run_continued_from_an_earlier_state_is_measured_as_if_it_had_never_left(scenario):
    run = started(scenario)
    run_to(run, 60)
    before = values(run)
    run.look(30)
    run.branch()
    run_to(run, 60)
    assert values(run) == before
    run.look(30)
    run.branch()
    run.live.apply(SetParameter(key="model.hop_length", value=2.0))
    run_to(run, 40)
    assert values(run)[40] != before[40]


@pytest.fixture
def measured_elsewhere():
    """A desk whose states are measured by a thread that answers as the process does."""
    ours, theirs = Pipe()
    thread = threading.Thread(target=run_measurer, args=(theirs,), daemon=True)
    yield Desk(ours), thread
    ours.close()
    thread.join(10)


def test_another_process_gives_the_same_rows_as_measuring_here(scenario, monkeypatch, measured_elsewhere):
    monkeypatch.setattr("os.nice", lambda _: 0)
    monkeypatch.setattr("signal.signal", lambda *_: None)
    desk, process = measured_elsewhere
    run, here = started(scenario, desk), started(scenario)
    run_to(run, 40)
    run_to(here, 40)
    assert steps(run) == []
    assert desk.pending == 5
    desk.wake()
    process.start()
    end = time.monotonic() + 60
    while desk.pending:
        desk.collect()
        assert time.monotonic() < end
    assert values(run) == values(here)


def test_a_run_waits_where_too_many_states_wait_so_that_no_step_is_left_out(scenario, monkeypatch):
    ours, theirs = Pipe()
    run = started(scenario, Desk(ours))
    monkeypatch.setattr("barchan.studio.worker.desk.ROOM", 0)
    run.run()
    run.advance_chunk()
    assert run.live.steps_done == 0
    theirs.close()
    run.desk.collect()  # the process has ended: what waits is measured here
    run.advance_chunk()
    assert run.live.steps_done > 0
    assert steps(run)[0] == 0


def test_the_states_of_a_run_that_was_given_up_are_not_measured(scenario):
    ours, _theirs = Pipe()
    desk = Desk(ours)
    first = started(scenario, desk)
    run_to(first, 40)
    second = started(small(), desk)
    desk.keep_only({second.measures.number})
    assert desk.pending == 1
