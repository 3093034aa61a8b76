"""Slots shared among threads: compiled code that lets go of Python's lock, each thread with slots of its own.

What a thread does depends on nothing that another one does, so the bits are the same for any number.
"""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache

LEAST = 8192
"""Slots below which a thread is not worth its start."""


def thread_count() -> int:
    """Threads to use: as many as Numba was told to (``NUMBA_NUM_THREADS``), or one for each core."""
    from numba import config

    return int(config.NUMBA_NUM_THREADS)  # type: ignore[attr-defined]


@cache
def _pool(_process: int, threads: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(threads)


def shared(work: Callable[[int, int], int], slots: int, block: int, threads: int) -> list[tuple[int, int]]:
    """Call ``work(first, last)`` for shares of the slots; the first slot and the result of each, in order."""
    shares = max(1, min(threads, slots // LEAST))
    size = -(-slots // (shares * block)) * block
    firsts = list(range(0, slots, size))
    if len(firsts) == 1:
        return [(0, work(0, slots))]
    pool = _pool(os.getpid(), threads)
    others = [pool.submit(work, first, min(first + size, slots)) for first in firsts[1:]]
    results = [work(0, size), *(other.result() for other in others)]
    return list(zip(firsts, results, strict=True))
