"""While kernels are compiled instead of loaded from the cache: how far that is; no collection of garbage."""

import gc
import threading
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

    with event.install_listener("numba:compile", Listener()), collection_rests():
        yield


@contextmanager
def collection_rests() -> Iterator[None]:
    """Let Python's collector of cyclic garbage rest while a function is compiled.

    The compiler makes millions of small objects that live until it ends: to search them takes a tenth of its
    time, and finds nothing.
    """
    from numba.core import event

    class Listener(event.Listener):
        depth = 0
        collected = True
        lock = threading.Lock()

        def on_start(self, _: event.Event) -> None:
            with self.lock:
                if self.depth == 0:
                    self.collected = gc.isenabled()
                    gc.disable()
                self.depth += 1

        def on_end(self, _: event.Event) -> None:
            with self.lock:
                self.depth -= 1
                if self.depth == 0 and self.collected:
                    gc.enable()

    with event.install_listener("numba:compile", Listener()):
        yield
