"""Compilation is told at once, and then how many functions are done, now and then."""

import gc

from numba.core import event

from barchan.kernels.core import compile_notice
from barchan.kernels.core.compile_notice import collection_rests, told_of_compilation


def compile_functions(count):
    for _ in range(count):
        event.broadcast(event.Event("numba:compile", event.EventStatus.START))
        event.broadcast(event.Event("numba:compile", event.EventStatus.END))


def test_the_first_is_told_at_once_and_nothing_where_all_is_loaded():
    told = []
    with told_of_compilation(told.append):
        assert told == []
        event.broadcast(event.Event("numba:compile", event.EventStatus.START))
        assert told == [0]
        event.broadcast(event.Event("numba:compile", event.EventStatus.END))


def test_later_reports_count_what_is_done_and_keep_a_distance(monkeypatch):
    now = [100.0]
    monkeypatch.setattr(compile_notice.time, "monotonic", lambda: now[0])
    told = []
    with told_of_compilation(told.append):
        compile_functions(3)
        assert told == [0]
        now[0] += compile_notice.EVERY
        compile_functions(2)
        assert told == [0, 4]


def test_garbage_is_collected_before_and_after_a_compilation_but_not_within_one():
    start = event.Event("numba:compile", event.EventStatus.START)
    end = event.Event("numba:compile", event.EventStatus.END)
    with collection_rests():
        assert gc.isenabled()
        event.broadcast(start)
        event.broadcast(start)
        assert not gc.isenabled()
        event.broadcast(end)
        assert not gc.isenabled()
        event.broadcast(end)
        assert gc.isenabled()


def test_a_collector_that_was_off_stays_off():
    gc.disable()
    try:
        with collection_rests():
            event.broadcast(event.Event("numba:compile", event.EventStatus.START))
            event.broadcast(event.Event("numba:compile", event.EventStatus.END))
            assert not gc.isenabled()
    finally:
        gc.enable()
