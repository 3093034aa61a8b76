"""Spells: iterations of grains in flight between which nothing else happens, shared among threads."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from barchan.kernels.grains.state import MOST_ITERATIONS


def spells(first: int, end: int, *intervals: int) -> Iterator[tuple[int, int]]:
    """Cut iterations wherever one of the intervals begins anew: where each begins, and how many they are."""
    while first < end:
        ends = [end, first + MOST_ITERATIONS]
        ends += [first - first % interval + interval for interval in intervals]
        yield first, min(ends) - first
        first = min(ends)


@contextmanager
def shared_scene(scene: Any, key: int, slots: int, first: int) -> Iterator[Callable[[int], None]]:
    """What makes spells of a scene up to before an iteration, from ``first`` on, shared among threads."""
    from barchan.kernels.core import threads
    from barchan.kernels.grains.iterations import plan_of, spell

    plan = plan_of(key, slots, first)
    count = min(threads.thread_count(), slots // threads.LEAST)
    with threads.helped(lambda: spell(False, plan, scene, 0), plan.board, count - 1):
        yield lambda end: spell(True, plan, scene, end)
