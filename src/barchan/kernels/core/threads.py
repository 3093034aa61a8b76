"""Threads that help one that leads: compiled code that lets go of Python's lock, and a board (``board``).

What a piece of work gives depends on nothing that other threads do, so the bits are the same for any number.
"""

import ctypes
import os
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from functools import cache
from typing import TypeVar

from barchan.errors import BarchanError

LEAST = 4096
"""Slots for each thread below which it is not worth its start."""


MOST_THREADS = 1024

VARIABLE = "BARCHAN_THREADS"
"""The environment variable that states the number of threads."""

Given = TypeVar("Given")

_asked: ContextVar[int | None] = ContextVar("threads", default=None)


def state_threads(threads: int | None) -> None:
    """State the number of threads of this process and those that it starts (None: leave it as it is).

    Raises BarchanError where the environment states a number that is none.
    """
    if threads is not None:
        os.environ[VARIABLE] = str(threads)
    thread_count()


@contextmanager
def asked_for(threads: int | None) -> Iterator[None]:
    """Use so many threads meanwhile (None: as many as outside), unless the environment states a number."""
    token = _asked.set(_asked.get() if threads is None else threads)
    try:
        yield
    finally:
        _asked.reset(token)


def thread_count() -> int:
    """Threads to use: as many as the environment, the command line or the scenario states, or all cores.

    Raises BarchanError where ``BARCHAN_THREADS`` is no whole number from 1 to ``MOST_THREADS``.
    """
    from numba import config

    stated = os.environ.get(VARIABLE, "").strip()
    if stated:
        if not (stated.isascii() and stated.isdigit() and 1 <= int(stated) <= MOST_THREADS):
            raise BarchanError(
                f"{VARIABLE} is {stated!r}; a whole number from 1 to {MOST_THREADS} is allowed"
            )
        return int(stated)
    asked = _asked.get()
    return int(config.NUMBA_NUM_THREADS) if asked is None else asked  # type: ignore[attr-defined]


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
        self._work: Future[object] | None = None

    def submit(self, work: Callable[[], object]) -> None:
        """Let it work; raises what ended its work before, if that was an error."""
        before, self._work = self._work, None
        if before is not None and before.done():
            before.result()
        self._keep_off()
        self._work = self._thread.submit(work)

    def wait(self) -> None:
        """Wait until it has worked."""
        if self._work is not None:
            wait([self._work])

    def _keep_off(self) -> None:
        find = _processor_finder()
        here = -1 if find is None else find()
        if sys.platform == "linux" and here != self._kept_off:
            self._kept_off = here
            others = os.sched_getaffinity(0) - {here}
            with suppress(OSError):
                os.sched_setaffinity(self._id, others or {here})


class Workers:
    """The workers of this process, each of which works for one leader at a time."""

    def __init__(self) -> None:
        """Start with none: they come when they are asked for."""
        self._free: list[Worker] = []
        self._made = 0
        self._lock = threading.Lock()

    @contextmanager
    def taken(self, most: int) -> Iterator[list[Worker]]:
        """Up to ``most`` workers that nobody else has; there are no more than that in all."""
        with self._lock:
            if not self._free and self._made < most:
                missing = most - self._made
                self._free += [Worker() for _ in range(missing)]
                self._made += missing
            count = max(0, min(most, len(self._free)))
            mine, self._free = self._free[:count], self._free[count:]
        try:
            yield mine
        finally:
            with self._lock:
                self._free += mine


_workers = [Workers()]


def _start_anew() -> None:
    """A forked process has none of the threads, and maybe a lock that nobody opens."""
    _workers[0] = Workers()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_start_anew)


@contextmanager
def with_helpers(works: Sequence[Callable[[], object]], dismiss: Callable[[], None]) -> Iterator[int]:
    """Have each of ``works`` done by a helper of its own, or by as many as are free; tells how many.

    A helper may begin late, or after all is done. ``dismiss`` sends helpers away that wait for more: it is
    called at the end, whatever ends it.
    """
    with _workers[0].taken(len(works)) as workers:
        try:
            for worker, work in zip(workers, works, strict=False):
                worker.submit(work)
            yield len(workers)
        finally:
            dismiss()


def at_once(works: Sequence[Callable[[], Given]]) -> list[Given]:
    """What independent ``works`` give, in their order; they are done here and by helpers that are free.

    The first error of one of them is raised when all that have begun are done.
    """
    left, found, failed = deque(enumerate(works)), dict[int, Given](), list[BaseException]()

    def go_on() -> None:
        while not failed:
            try:
                number, work = left.popleft()
            except IndexError:
                return
            try:
                found[number] = work()
            except BaseException as error:
                failed.append(error)

    with _workers[0].taken(min(thread_count(), len(works)) - 1) as workers:
        try:
            for worker in workers:
                worker.submit(go_on)
            go_on()
        finally:
            left.clear()
            for worker in workers:
                worker.wait()
    if failed:
        raise failed[0]
    return [found[number] for number in range(len(works))]
