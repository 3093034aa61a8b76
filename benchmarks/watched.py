"""What it costs a model to be watched in the studio: steps with a browser that takes all frames, and without.

Browser and measures have processes of their own and are left out; frames go to another process.
"""

import time
from collections.abc import Iterator
from multiprocessing import Pipe, get_context
from multiprocessing.connection import Connection

from barchan.entry import load
from barchan.kernels.core import threads as thread_pool
from barchan.studio.protocol import FRAMES_IN_FLIGHT
from barchan.studio.worker.loop import Worker

SIDES = (256, 1024)
SPELLS, SECONDS = 8, 2.0
"""Spells of each kind, in turns, and how long one takes."""


def report() -> Iterator[str]:
    """The table, line by line."""
    yield ""
    yield "| a worker of the studio, `barchans`, one thread | frames a second | steps lost |"
    yield "|---|---|---|"
    for side in SIDES:
        frames, lost = measure(side)
        yield f"| {side}² | {frames:.0f} | {100 * lost:.1f} % |"


def measure(side: int) -> tuple[float, float]:
    """Frames a second, and the share of steps that their making takes: medians of spells."""
    here, there = Pipe()
    reader = get_context("spawn").Process(target=_take_all, args=(there,), daemon=True)
    reader.start()
    there.close()
    whole, thread_pool.thread_count = thread_pool.thread_count, lambda: 1
    try:
        worker = Worker(here, "run")
        worker.frames.attach()
        scenario = load("barchans", rows=side, columns=side, seed=1, steps=10**9)
        worker.on_request({"command": "start", "scenario": scenario.data(), "running": True})
        worker.on_request({"command": "limit", "rate": None})
        _spell(worker, watched=True)
        spells = [(_spell(worker, watched=True), _spell(worker, watched=False)) for _ in range(SPELLS)]
    finally:
        thread_pool.thread_count = whole
        here.close()
        reader.join()
    ratios = sorted(watched[0] / alone[0] for watched, alone in spells)
    frames = sorted(watched[1] for watched, _ in spells)
    return frames[SPELLS // 2], 1.0 - ratios[SPELLS // 2]


def _spell(worker: Worker, *, watched: bool) -> tuple[float, float]:
    """Steps and frames a second."""
    frames, run = worker.frames, worker.commands.current
    steps, sent, began = run.live.steps_done, frames._number, time.perf_counter()
    while (took := time.perf_counter() - began) < SECONDS:
        frames.credit = FRAMES_IN_FLIGHT if watched else 0
        worker.work()
    return (run.live.steps_done - steps) / took, (frames._number - sent) / took


def _take_all(connection: Connection) -> None:
    try:
        while True:
            connection.recv_bytes()
    except EOFError:
        return
