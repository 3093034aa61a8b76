"""Workers that help: each helps one leader at a time, and none outlasts its board."""

import multiprocessing
import os
import sys
import threading
from functools import partial

import pytest

from barchan.kernels.core import threads as thread_pool
from barchan.kernels.core.threads import Worker, Workers, at_once, with_helpers
from barchan.kernels.core.work_queue import CLOSED, OFFER, close, new_board


@pytest.fixture(autouse=True)
def own_workers(monkeypatch):
    monkeypatch.setattr(thread_pool, "_workers", [Workers()])


def test_helpers_work_beside_the_leader():
    met = threading.Barrier(3)
    with with_helpers([lambda: met.wait(60)] * 2, lambda: None) as helpers:
        assert helpers == 2
        met.wait(60)


def test_two_leaders_never_have_the_same_worker():
    workers = Workers()
    with workers.taken(2) as mine, workers.taken(2) as theirs:
        assert len(mine) == 2
        assert theirs == []
        with workers.taken(3) as more:
            assert len(more) == 1
            assert more[0] not in mine
    with workers.taken(3) as again:
        assert len(again) == 3


@pytest.mark.parametrize("most", [0, -1])
def test_who_asks_for_no_help_starts_no_thread(most):
    before = threading.active_count()
    with with_helpers([lambda: None] * most, lambda: None) as helpers:
        assert helpers == 0
    assert threading.active_count() == before


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt])
def test_a_leader_that_fails_dismisses_its_helpers(error):
    board = new_board()
    with pytest.raises(error), with_helpers([lambda: None], lambda: close(board)):
        raise error
    assert board[OFFER] == CLOSED
    with with_helpers([lambda: None], lambda: None) as helpers:
        assert helpers == 1


def test_an_error_of_a_worker_reaches_who_asks_it_next():
    worker = Worker()

    def fail():
        raise ValueError("beyond")

    worker.submit(fail)
    worker.wait()
    with pytest.raises(ValueError, match="beyond"):
        worker.submit(fail)
    worker.submit(fail)


def _children_help(results):
    with with_helpers([lambda: None], lambda: None) as helpers:
        results.put(helpers)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes do not fork here")
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")
def test_a_forked_process_has_workers_of_its_own():
    forking = multiprocessing.get_context("fork")
    results = forking.SimpleQueue()
    with thread_pool._workers[0].taken(1), thread_pool._workers[0]._lock:
        child = forking.Process(target=_children_help, args=(results,))
        child.start()
    child.join(60)
    assert child.exitcode == 0
    assert results.get() == 1


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux reports it")
def test_a_worker_stays_off_the_callers_processor_and_the_caller_goes_where_it_likes():
    allowed = os.sched_getaffinity(0)
    if len(allowed) == 1:
        pytest.skip("there is one processor only")
    worker, found = Worker(), []
    worker.submit(lambda: found.append(os.sched_getaffinity(0)))
    worker.wait()
    mine = found[0]
    assert len(mine) == len(allowed) - 1
    assert mine < allowed
    assert os.sched_getaffinity(0) == allowed


def test_works_at_once_give_what_they_give_in_their_order(monkeypatch):
    monkeypatch.setattr(thread_pool, "thread_count", lambda: 3)
    met = threading.Barrier(3)
    together = [lambda number=number: (number, met.wait(60) >= 0) for number in range(3)]
    assert at_once(together) == [(0, True), (1, True), (2, True)]
    assert at_once([lambda number=number: number for number in range(50)]) == list(range(50))
    assert at_once([]) == []


def test_works_are_done_one_after_the_other_by_one_thread(monkeypatch):
    monkeypatch.setattr(thread_pool, "thread_count", lambda: 1)
    done = []
    at_once([lambda number=number: done.append((number, threading.get_ident())) for number in range(4)])
    assert done == [(number, threading.get_ident()) for number in range(4)]


@pytest.mark.parametrize("fails", [0, 1, 7])
def test_an_error_of_one_of_the_works_is_raised_and_workers_stay_fit(fails, monkeypatch):
    monkeypatch.setattr(thread_pool, "thread_count", lambda: 2)

    def work(number):
        if number == fails:
            raise IndexError(f"work {number}")
        return number

    with pytest.raises(IndexError, match=f"work {fails}"):
        at_once([partial(work, number) for number in range(8)])
    assert at_once([partial(work, number + 8) for number in range(8)]) == list(range(8, 16))
