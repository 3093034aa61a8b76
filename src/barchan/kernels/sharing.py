"""Slots shared among threads: compiled code that lets go of Python's lock, each thread with slots of its own.

What a thread does depends on nothing that another one does, so the bits are the same for any number.
"""

import ctypes
import os
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from functools import cache

LEAST = 20480
"""Slots below which a thread is not worth its start."""


def thread_count() -> int:
    """Threads to use: as many as Numba was told to (``NUMBA_NUM_THREADS``), or one for each core."""
    from numba import config

    return int(config.NUMBA_NUM_THREADS)  # type: ignore[attr-defined]


@cache
def _processor_finder() -> Callable[[], int] | None:
    if sys.platform != "linux":
        return None
    # PyDLL: to let go of Python's lock would take longer than the call
    return getattr(ctypes.PyDLL(None), "sched_getcpu", None)


class Worker:
    """A thread that is kept off the processor of the thread that it works for.

    Linux wakes a thread where its waker runs, for what is woken so often looks as if it never took long; both
    then take turns on one processor, while another one is idle.
    """

    def __init__(self) -> None:
        """Start the thread."""
        self._thread = ThreadPoolExecutor(1)
        self._id = self._thread.submit(threading.get_native_id).result()
        self._kept_off = -1

    def submit(self, work: Callable[[int, int], int], first: int, last: int) -> "Future[int]":
        """Let it work; the result to come."""
        self._keep_off()
        return self._thread.submit(work, first, last)

    def _keep_off(self) -> None:
        find = _processor_finder()
        here = -1 if find is None else find()
        if sys.platform == "linux" and here != self._kept_off:
            self._kept_off = here
            others = os.sched_getaffinity(0) - {here}
            with suppress(OSError):
                os.sched_setaffinity(self._id, others or {here})


@cache
def _workers(_process: int, count: int) -> list[Worker]:
    return [Worker() for _ in range(count)]


def shared(work: Callable[[int, int], int], slots: int, block: int, threads: int) -> list[tuple[int, int]]:
    """Call ``work(first, last)`` for shares of the slots; the first slot and the result of each, in order."""
    shares = max(1, min(threads, slots // LEAST))
    size = -(-slots // (shares * block)) * block
    firsts = list(range(0, slots, size))
    if len(firsts) == 1:
        return [(0, work(0, slots))]
    workers = _workers(os.getpid(), threads - 1)
    others = [
        worker.submit(work, first, min(first + size, slots))
        for worker, first in zip(workers, firsts[1:], strict=False)
    ]
    results = [work(0, size), *(other.result() for other in others)]
    return list(zip(firsts, results, strict=True))
