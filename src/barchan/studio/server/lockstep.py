"""Two simulations led step by step together, so that they can be compared at every moment."""

import time
from collections.abc import Callable

from barchan.studio.server.worker_handle import Link

AIM = 0.06
"""Seconds that the slower one takes from one meeting to the next, about."""


class Pair:
    """Lets two workers run the same number of steps, then again when both have arrived."""

    def __init__(self, links: dict[str, Link], tell: Callable[[bool], None]) -> None:
        """Lead these workers; ``tell`` is told whether they run."""
        self.links = links
        self.running = False
        self._tell = tell
        self._left: int | None = None
        self._chunk = 1
        self._away: set[str] = set()
        self._began = 0.0

    def run(self, steps: int | None = None) -> None:
        """Run, on and on or so many steps."""
        self._left = steps
        self.running = True
        self._tell(True)
        if not self._away:
            self._go()

    def pause(self) -> None:
        """Stop where both meet next."""
        self.running = False
        self._tell(False)

    def arrived(self, name: str) -> None:
        """A worker has done its steps."""
        if name not in self._away:
            return
        self._away.discard(name)
        if self._away:
            return
        took = max(time.perf_counter() - self._began, 1e-4)
        self._chunk = max(1, min(2 * self._chunk, round(self._chunk * AIM / took)))
        if self._left == 0:
            self.pause()
        elif self.running:
            self._go()

    def _go(self) -> None:
        steps = self._chunk if self._left is None else min(self._chunk, self._left)
        if self._left is not None:
            self._left -= steps
        self._away = set(self.links)
        self._began = time.perf_counter()
        for link in self.links.values():
            link.send(do="run", steps=steps, brief=True)
