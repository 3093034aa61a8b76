"""Two simulations run in lockstep, so that they can be compared at every frame."""

import time
from collections.abc import Callable
from itertools import count
from typing import Any

from barchan.simulation import StepPacer
from barchan.studio.server.worker_handle import WorkerHandle

MEETING_SECONDS = 0.06
"""Seconds that the slower run takes from one meeting to the next, about."""

_ORDERS = count(1)
"""Numbers of orders to run, each given once: the answer to an order of an earlier pair counts for nothing."""


class Lockstep:
    """Lets two workers run the same number of steps, then the next ones when both have arrived."""

    def __init__(self, workers: dict[str, WorkerHandle], on_change: Callable[[bool], None]) -> None:
        """Lead these workers; ``on_change`` is called with whether they run."""
        self.workers = workers
        self.running = False
        """Whether they run, or are still on their way to where they meet."""
        self.ends: dict[str, int] = {}
        """The step at which each run stops by itself."""
        self._at: dict[str, int] = {}
        """The step where each run stands, or stood when it arrived last."""
        self._behind: set[str] = set()
        """Runs that go up to the step of the other one first; that one stands still meanwhile."""
        self._goes_on = False
        self._on_change = on_change
        self._left: int | None = None
        self._until: int | None = None
        self._pacer = StepPacer(MEETING_SECONDS)
        self._steps = 0
        self._order = 0
        self._keep = False
        self._away: set[str] = set()
        self._held: list[Callable[[], None]] = []
        self._began = 0.0

    def run(self, steps: int | None = None, until: int | None = None) -> None:
        """Run a number of steps, or up to a step; else to the earlier end, and from there on and on.

        A number of steps stops at the scenario's end, too, where that is ahead.

        Of two that stand at different steps the one that is behind comes to the step of the other one first.
        """
        at, end = self._step, min(self.ends.values(), default=0)
        if until is None and at < end:
            until = end
        self._left = None if steps is None else max(1, int(steps))
        self._until = None if until is None else int(until)
        self._behind = {name for name, step in self._at.items() if step < at}
        self._goes_on = self.running = True
        self._on_change(True)
        if not self._away:
            self._go()

    @property
    def _step(self) -> int:
        """The step where they stand; of two that stand apart that of the one ahead."""
        return max(self._at.values(), default=0)

    def restart(self) -> None:
        """Both begin again: the scenario's end is ahead."""
        self._at.clear()

    def stands(self, name: str, step: int, end: int) -> None:
        """A run is at a step, and stops by itself at another one; both on their way go so far."""
        before = min(self.ends.values(), default=None)
        self._at[name], self.ends[name] = step, end
        if self._until is not None and self._until == before:
            self._until = min(self.ends.values())

    def pause(self) -> None:
        """Stop where both meet next; there both are measured, and not before are they said to pause."""
        self._goes_on = False
        if not self._away:
            self._rest()

    def meet(self, act: Callable[[], None], pausing: bool = False) -> None:
        """Do something where both are at one step, at once or where they meet next; ``pausing`` there."""
        if not self._away:
            act()
            return
        self._held.append(act)
        if pausing:
            self._goes_on = False

    def leave(self) -> None:
        """Lead them no more; what was to be done where they meet is done now."""
        self._goes_on, self._away = False, set()
        self._do_held()

    def halt(self) -> None:
        """Stop both at once, wherever each of them is; what was to be done where they meet is done now."""
        self.leave()
        self._rest()

    def keep(self) -> None:
        """Let both send their states where they meet next, so that both are of the same step."""
        self._keep = True
        if not self._away:
            self._send_keep()

    def arrived(self, name: str, step: int, order: Any) -> None:
        """A worker has done the steps of an order, and is at a step."""
        if name not in self._away or order != self._order:
            return
        self._away.discard(name)
        if self._behind:
            self._came_nearer(name, step)
        self._at[name] = step
        if self._away:
            return
        self._send_keep()
        self._pacer.record(self._steps, time.perf_counter() - self._began)
        if not self._behind and (self._left == 0 or (self._until is not None and self._step >= self._until)):
            self._goes_on = False
        self._met()

    def _came_nearer(self, name: str, step: int) -> None:
        """One that was behind is at a step: at that of the other one, or where it cannot go on."""
        if step >= self._step or step == self._at.get(name):
            self._behind.discard(name)

    def stopped(self, name: str) -> None:
        """A worker could not do its steps: both pause, the other one where it arrives."""
        self._goes_on = False
        if name in self._away:
            self._away.discard(name)
            if not self._away:
                self._met()

    def _met(self) -> None:
        if not self._goes_on:
            self._rest()
        self._do_held()
        if self._goes_on:
            self._go()

    def _rest(self) -> None:
        for worker in self.workers.values():
            worker.send("pause")
        self.running = False
        self._on_change(False)

    def _do_held(self) -> None:
        held, self._held = self._held, []
        for act in held:
            act()

    def _send_keep(self) -> None:
        if self._keep:
            self._keep = False
            for worker in self.workers.values():
                worker.send("keep")

    def _go(self) -> None:
        self._steps = self._pacer.steps
        until = self._until
        if self._behind:
            until = self._step
        elif self._left is not None:
            self._steps = min(self._steps, self._left)
            self._left -= self._steps
        self._away = set(self._behind or self.workers)
        self._order = next(_ORDERS)
        self._began = time.perf_counter()
        for name in self._away:
            self.workers[name].send("run", steps=self._steps, until=until, brief=True, order=self._order)
