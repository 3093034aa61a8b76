"""Telling when kernels are compiled instead of loaded from the cache, and how far that is."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

EVERY = 0.5
"""Seconds between two reports at least."""


@contextmanager
def told_of_compilation(tell: Callable[[int], None]) -> Iterator[None]:
    """Call ``tell`` with 0 when the first function is compiled, later with how many have been."""
    from numba.core import event

    class Listener(event.Listener):
        done = 0
        told_at = -1.0

        def on_start(self, _: event.Event) -> None:
            if self.told_at < 0.0:
                self._tell()

        def on_end(self, _: event.Event) -> None:
            self.done += 1
            if time.monotonic() - self.told_at >= EVERY:
                self._tell()

        def _tell(self) -> None:
            self.told_at = time.monotonic()
            tell(self.done)

    with event.install_listener("numba:compile", Listener()):
        yield
