"""The server's end of a worker process: starts it, passes messages, ends it."""

import asyncio
import json
import multiprocessing
import threading
from collections.abc import Callable
from typing import Any

from barchan.studio.worker.loop import run_measurer, run_worker

OnData = Callable[["WorkerHandle", bytes], None]
OnExit = Callable[["WorkerHandle"], None]

PATIENCE = 2.0
"""Seconds that a worker has to end by itself."""


class WorkerHandle:
    """A worker process and the pipe to it."""

    def __init__(self, name: str, on_data: OnData, on_exit: OnExit) -> None:
        """Start the process; ``on_data`` and ``on_exit`` are called in the running event loop."""
        context = multiprocessing.get_context("spawn")
        self.name = name
        self.closing = False
        self.holds_aside = False
        """Whether it holds a run that was set aside."""
        self._on_data, self._on_exit = on_data, on_exit
        self._loop = asyncio.get_running_loop()
        self._connection, theirs = context.Pipe()
        measured, measuring = context.Pipe()
        self.process = context.Process(
            target=run_worker, args=(theirs, name, measured), daemon=True, name=f"barchan-{name}"
        )
        self.process.start()
        self.measurer = context.Process(
            target=run_measurer, args=(measuring,), daemon=True, name=f"barchan-{name}-measurer"
        )
        self.measurer.start()
        for end in (theirs, measured, measuring):
            end.close()
        self._sending = threading.Lock()
        self._thread = threading.Thread(target=self._receive, daemon=True, name=f"barchan-{name}-receiver")
        self._thread.start()

    def send(self, command: str, **content: Any) -> None:
        """Send the worker a request; it is dropped where the worker has ended."""
        self.forward({**content, "command": command})

    def forward(self, request: dict[str, Any]) -> None:
        """Send the worker a request as it is; it is dropped where the worker has ended."""
        self.send_bytes(json.dumps(request).encode())

    def send_bytes(self, data: bytes) -> None:
        """Send the worker a request or a state; it is dropped where the worker has ended."""
        try:
            with self._sending:
                self._connection.send_bytes(data)
        except OSError:
            pass

    def _receive(self) -> None:
        try:
            while True:
                self._loop.call_soon_threadsafe(self._on_data, self, self._connection.recv_bytes())
        except (EOFError, OSError, RuntimeError):
            pass
        if not self.closing and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._on_exit, self)

    def close(self) -> None:
        """End the worker, politely at first."""
        self.closing = True
        self.measurer.terminate()
        self.process.terminate()
        self.measurer.join(PATIENCE)
        self.process.join(PATIENCE)
        if self.process.is_alive():
            self.process.kill()
            self.process.join()
        self._connection.close()
