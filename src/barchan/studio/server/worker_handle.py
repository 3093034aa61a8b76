"""The server's end of a worker: starts it, hears it, ends it."""

import asyncio
import json
import multiprocessing
import threading
from collections.abc import Callable
from typing import Any

from barchan.studio.worker.loop import work

Heard = Callable[["Link", bytes], None]
Lost = Callable[["Link"], None]

PATIENCE = 2.0
"""Seconds that a worker has to end by itself."""


class Link:
    """A worker process and the pipe to it."""

    def __init__(self, name: str, heard: Heard, lost: Lost) -> None:
        """Start the process; ``heard`` and ``lost`` are called in the running event loop."""
        context = multiprocessing.get_context("spawn")
        self.name = name
        self.closing = False
        self._heard, self._lost = heard, lost
        self._loop = asyncio.get_running_loop()
        self._connection, theirs = context.Pipe()
        self.process = context.Process(target=work, args=(theirs, name), daemon=True, name=f"barchan-{name}")
        self.process.start()
        theirs.close()
        self._sending = threading.Lock()
        self._thread = threading.Thread(target=self._listen, daemon=True, name=f"barchan-{name}-ear")
        self._thread.start()

    def send(self, **order: Any) -> None:
        """Give the worker an order; one that has ended hears nothing."""
        try:
            with self._sending:
                self._connection.send_bytes(json.dumps(order).encode())
        except OSError:
            pass

    def _listen(self) -> None:
        try:
            while True:
                self._loop.call_soon_threadsafe(self._heard, self, self._connection.recv_bytes())
        except (EOFError, OSError, RuntimeError):
            pass
        if not self.closing and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._lost, self)

    def close(self) -> None:
        """End the worker, politely at first."""
        self.closing = True
        self.process.terminate()
        self.process.join(PATIENCE)
        if self.process.is_alive():
            self.process.kill()
            self.process.join()
        self._connection.close()
