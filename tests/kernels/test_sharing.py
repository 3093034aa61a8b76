"""Slots shared among threads."""

import os
import sys
import threading

import pytest

from barchan.kernels import sharing
from barchan.kernels.sharing import Worker, shared


@pytest.mark.parametrize("threads", [1, 2, 3, 5])
@pytest.mark.parametrize("slots", [1, 255, 256, 1000, 4096])
def test_every_slot_falls_to_one_share(monkeypatch, threads, slots):
    monkeypatch.setattr(sharing, "LEAST", 256)
    found = shared(lambda first, last: last - first, slots, 256, threads)
    assert [first for first, _ in found] == [sum(count for _, count in found[:k]) for k in range(len(found))]
    assert sum(count for _, count in found) == slots
    assert len(found) <= threads
    assert all(first % 256 == 0 for first, _ in found)


def test_few_slots_stay_with_the_caller():
    here = threading.get_ident()
    assert shared(lambda *_: threading.get_ident(), 2 * sharing.LEAST - 1, 256, 4) == [(0, here)]


def test_errors_of_any_share_reach_the_caller(monkeypatch):
    monkeypatch.setattr(sharing, "LEAST", 256)

    def fail_beyond(first, last):
        if first:
            raise ValueError("beyond")
        return last

    with pytest.raises(ValueError, match="beyond"):
        shared(fail_beyond, 1024, 256, 2)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells")
def test_a_worker_stays_off_the_callers_processor_and_the_caller_goes_where_it_likes():
    allowed = os.sched_getaffinity(0)
    if len(allowed) == 1:
        pytest.skip("there is one processor only")
    worker = Worker()
    mine = worker.submit(lambda *_: os.sched_getaffinity(0), 0, 1).result()
    assert len(mine) == len(allowed) - 1
    assert mine < allowed
    assert os.sched_getaffinity(0) == allowed
