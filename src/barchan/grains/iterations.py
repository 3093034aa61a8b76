"""Batches: iterations of grains in flight between which nothing else happens, shared among threads."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial

from barchan.kernels.grains.state import MOST_ITERATIONS, Scene

_UPDATES = 5_000_000
"""Grain updates of a batch at most, where it has more than one iteration: some tenths of a second."""


def batches(first: int, end: int, slots: int, *intervals: int) -> Iterator[tuple[int, int]]:
    """Cut iterations where one of the intervals begins: first iteration and length of each batch.

    With many ``slots`` in use batches are short: a signal is handled between two of them.
    """
    most = max(1, min(MOST_ITERATIONS, _UPDATES // max(slots, 1)))
    while first < end:
        ends = [end, first + most]
        ends += [first - first % interval + interval for interval in intervals]
        yield first, min(ends) - first
        first = min(ends)


@contextmanager
def shared_scene(scene: Scene, key: int, slots: int, first: int) -> Iterator[Callable[[int], None]]:
    """A function that runs a scene up to before an iteration, from ``first`` on, shared among threads."""
    from barchan.kernels.core import threads
    from barchan.kernels.core.work_queue import close
    from barchan.kernels.grains.flight import work_space
    from barchan.kernels.grains.iterations import divided, plan_of, run_iterations

    count = min(threads.thread_count(), slots // threads.LEAST)
    plan = plan_of(key, slots, first, divided(scene, count))
    helpers = [partial(run_iterations, False, plan, scene, work_space(), 0) for _ in range(count - 1)]
    with threads.with_helpers(helpers, lambda: close(plan.board)):
        yield partial(run_iterations, True, plan, scene, work_space())
