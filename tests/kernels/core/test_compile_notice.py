"""Compilation is told at once, and then how many functions are done, now and then."""

from numba.core import event

from barchan.kernels.core import compile_notice
from barchan.kernels.core.compile_notice import told_of_compilation


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
