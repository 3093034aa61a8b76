"""Two simulations run in lockstep, so that they can be compared at every frame."""

import time
from collections.abc import Callable

from barchan.simulation import StepPacer
from barchan.studio.server.worker_handle import WorkerHandle

MEETING_SECONDS = 0.06
"""Seconds that the slower run takes from one meeting to the next, about."""


class Lockstep:
    """Lets two workers run the same number of steps, then the next ones when both have arrived."""

    def __init__(self, workers: dict[str, WorkerHandle], on_change: Callable[[bool], None]) -> None:
        """Lead these workers; ``on_change`` is called with whether they run."""
        self.workers = workers
        self.running = False
        self._on_change = on_change
        self._left: int | None = None
        self._pacer = StepPacer(MEETING_SECONDS)
        self._steps = 0
        self._keep = False
        self._away: set[str] = set()
        self._began = 0.0

    def run(self, steps: int | None = None) -> None:
        """Run: on and on, or a number of steps."""
        self._left = steps
        self.running = True
        self._on_change(True)
        if not self._away:
            self._go()

    def pause(self) -> None:
        """Stop where both meet next; there both are measured."""
        self.running = False
        self._on_change(False)
        if not self._away:
            self._pause_workers()

    def _pause_workers(self) -> None:
        for worker in self.workers.values():
            worker.send("pause")

    def keep(self) -> None:
        """Let both send their states where they meet next, so that both are of the same step."""
        self._keep = True
        if not self._away:
            self._send_keep()

    def _send_keep(self) -> None:
        if self._keep:
            self._keep = False
            for worker in self.workers.values():
                worker.send("keep")

    def arrived(self, name: str) -> None:
        """A worker has done its steps."""
        if name not in self._away:
            return
        self._away.discard(name)
        if self._away:
            return
        self._send_keep()
        self._pacer.record(self._steps, time.perf_counter() - self._began)
        if self._left == 0:
            self.pause()
        elif self.running:
            self._go()
        else:
            self._pause_workers()

    def _go(self) -> None:
        self._steps = self._pacer.steps if self._left is None else min(self._pacer.steps, self._left)
        if self._left is not None:
            self._left -= self._steps
        self._away = set(self.workers)
        self._began = time.perf_counter()
        for worker in self.workers.values():
            worker.send("run", steps=self._steps, brief=True)
