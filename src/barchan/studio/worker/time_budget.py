"""Limits a periodic task to a given fraction of wall-clock time."""

import time
from collections.abc import Iterator
from contextlib import contextmanager


class TimeBudget:
    """The moment from which a task may be done again, given the time that it took."""

    def __init__(self, share: float, least_pause: float = 0.0) -> None:
        """Let it take a share of the time, with a pause (s) at least; it may be done at once."""
        self._share = share
        self._least_pause = least_pause
        self.due = 0.0
        """Moment from which it may be done (``time.perf_counter``)."""

    @property
    def is_due(self) -> bool:
        """Whether it may be done now."""
        return time.perf_counter() >= self.due

    def at_once(self) -> None:
        """Let it be done at once, whatever it cost before."""
        self.due = 0.0

    @contextmanager
    def spending(self) -> Iterator[None]:
        """Do it, and count the time that it takes."""
        began = time.perf_counter()
        yield
        now = time.perf_counter()
        self.due = now + max(self._least_pause, (now - began) / self._share)
