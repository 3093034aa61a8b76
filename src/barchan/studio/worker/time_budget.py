"""What may cost a share of the time, and no more: it is done the more seldom the longer it takes."""

import time
from collections.abc import Iterator
from contextlib import contextmanager


class Ration:
    """When something may be done again, by how long it took."""

    def __init__(self, share: float) -> None:
        """Let it take a share of the time; it may be done at once."""
        self._share = share
        self.due = 0.0
        """When it may be done (``time.perf_counter``)."""

    @property
    def is_due(self) -> bool:
        """Whether it may be done now."""
        return time.perf_counter() >= self.due

    def at_once(self) -> None:
        """Let it be done at once, whatever it cost before."""
        self.due = 0.0

    @contextmanager
    def spending(self) -> Iterator[None]:
        """Do it, and count how long it takes."""
        began = time.perf_counter()
        yield
        now = time.perf_counter()
        self.due = now + (now - began) / self._share
