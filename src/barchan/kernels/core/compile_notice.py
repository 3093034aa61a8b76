"""Telling when a kernel is compiled instead of loaded from the cache."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager


@contextmanager
def told_of_compilation(tell: Callable[[], None]) -> Iterator[None]:
    """Call ``tell`` once, when the first kernel is compiled."""
    from numba.core import event

    class Listener(event.Listener):
        said = False

        def on_start(self, _: event.Event) -> None:
            if not self.said:
                self.said = True
                tell()

        def on_end(self, _: event.Event) -> None:
            """Nothing to say."""

    with event.install_listener("numba:compile", Listener()):
        yield
