"""Work beside the run: it counts, and ends where it is broken off."""

import threading
import time

import pytest

from barchan.studio.worker.background import AllMeasured, Background, BrokenOffError, Reading
from barchan.studio.worker.owed import OwedAnswers
from barchan.studio.worker.run import started
from tests.studio.worker.test_run import run_to


def finished(later):
    end = time.monotonic() + 10
    while (result := later.result()) is None and time.monotonic() < end:
        time.sleep(0.005)
    return result


def endless(count):
    while True:
        count(1, 2)
        time.sleep(0.001)


def test_work_that_is_broken_off_ends_where_it_counts_next():
    later = Background(endless)
    time.sleep(0.02)
    assert later.result() is None
    assert (later.done, later.of) == (1, 2)
    later.break_off()
    with pytest.raises(BrokenOffError, match="broken off"):
        finished(later)


def test_waiting_for_measures_can_be_broken_off(scenario):
    run = started(scenario)
    later = AllMeasured(lambda: run)
    later.break_off()
    with pytest.raises(BrokenOffError):
        later.result()


def test_only_the_answer_that_is_named_is_broken_off():
    sent, refused = [], []
    owed = OwedAnswers(
        lambda kind, **content: sent.append((kind, content)),
        lambda request, error: refused.append((request["id"], str(error))),
    )
    works = {number: Background(endless) for number in (3, 4)}
    for number, work in works.items():
        owed.add({"id": number}, work)
    owed.break_off(4)
    end = time.monotonic() + 10
    while not refused and time.monotonic() < end:
        owed.pay()
        time.sleep(0.005)
    assert refused == [(4, "broken off")]
    assert len(owed) == 1
    works[3].break_off()


def test_a_reading_that_is_broken_off_is_answered_at_once():
    """Nobody waits for work that cannot be stopped: it goes on, and what it gives is dropped."""
    go_on = threading.Event()
    reading = Reading(lambda _: {"rows": [1]} if go_on.wait(10.0) else {})
    assert reading.result() is None
    reading.break_off()
    with pytest.raises(BrokenOffError):
        reading.result()
    go_on.set()


def test_the_table_of_measures_ends_with_the_state_where_the_run_rests(scenario):
    """Not of a run that goes on: where that is depends on the machine."""
    run = started(scenario)
    run_to(run, 13)
    assert table_steps(run) == ["0", "10", "13"]
    run_to(run, 20)
    assert table_steps(run) == ["0", "10", "20"]
    run.run()
    run.live.advance(3)
    assert table_steps(run) == ["0", "10", "20"]
    run.pause()
    assert table_steps(run) == ["0", "10", "20", "23"]


def table_steps(run):
    return [row[0] for row in AllMeasured(lambda: run).result()["rows"]]
