"""Workers that help: each helps one leader at a time, and none outlasts its board."""

import multiprocessing
import os
import sys
import threading

import pytest

from barchan.kernels.core import threads as thread_pool
from barchan.kernels.core.threads import Worker, Workers, with_helpers
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
