"""Work of compiled code that a signal can interrupt.

Python handles signals in its main thread, and only between its own instructions. So compiled code that may
take long runs in a thread of its own while the main thread waits, and looks at a number from time to time
that says whether to go on.
"""

import threading
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

_GRACE = 0.5
"""Seconds to wait for interrupted work: code that is being compiled is not waited for."""


def new_interruption() -> NDArray[np.int64]:
    """The number that compiled code looks at: 0 to go on."""
    return np.zeros(1, np.int64)


def interruptible(work: Callable[[], None], interruption: NDArray[np.int64]) -> None:
    """Have ``work`` done; an exception that a signal raises meanwhile ends it, by ``interruption``.

    What it has changed by then is half done.
    """
    if threading.current_thread() is not threading.main_thread():
        work()
        return
    failed: list[BaseException] = []

    def run() -> None:
        try:
            work()
        except BaseException as error:
            failed.append(error)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    try:
        thread.join()
    except BaseException:
        interruption[0] = 1
        thread.join(_GRACE)
        raise
    if failed:
        raise failed[0]
