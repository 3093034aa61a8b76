"""Telling how long work goes that is no step of a run, such as slopes that relax before the first one.

Nothing here imports the compiler.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

_listeners: list[Callable[[str], None]] = []


def report(text: str) -> None:
    """Tell whoever listens how far the work is."""
    for listener in _listeners:
        listener(text)


@contextmanager
def told_of_progress(tell: Callable[[str], None]) -> Iterator[None]:
    """Call ``tell`` with how far long work is, some times a second."""
    _listeners.append(tell)
    try:
        yield
    finally:
        _listeners.remove(tell)
