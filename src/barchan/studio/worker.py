"""The process of one simulation: it obeys, works, and sends frames when the browser can take them."""

import json
import signal
import time
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from barchan.errors import BarchanError, ScenarioError
from barchan.studio.protocol import FRAMES_IN_FLIGHT, frame, message

FRAME_PAUSE = 0.012
"""Seconds from one frame to the next, at least; a run's breath lets some 60 a second pass."""


def work(connection: Connection, name: str) -> None:
    """Be the worker at this end of a connection until it is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's: it ends its workers itself
    from barchan.kernels.compiling import told_of_compilation

    worker = Worker(connection, name)
    with told_of_compilation(lambda: worker.tell("compiling")):
        try:
            while True:
                worker.listen()
                worker.work()
        except (EOFError, BrokenPipeError, ConnectionResetError):
            return


class Worker:
    """Takes orders from its connection and answers on it."""

    def __init__(self, connection: Connection, name: str) -> None:
        """Wait for a scenario."""
        from barchan.studio.flights import Flights
        from barchan.studio.orders import Orders

        self.connection = connection
        self.name = name
        self.orders = Orders(self)
        self.wanted: list[str] = []
        """Fields that the browser shows beside the surface."""
        self.flights = Flights()
        self.credit = 0
        self.stale = True
        self.ground_sent: NDArray | None = None
        """The ground that the browser has."""
        self.history_sent: list[int] = []
        self._number = 0
        self._next_frame = 0.0

    def tell(self, what: str, **content: Any) -> None:
        """Send a control message."""
        self.connection.send_bytes(message(tell=what, run=self.name, **content))

    def listen(self) -> None:
        """Obey what was said; wait for orders where there is nothing else to do."""
        while self.connection.poll(self._patience()):
            self.obey(json.loads(self.connection.recv_bytes()))

    def _patience(self) -> float | None:
        run = self.orders.run
        if run is not None and run.busy:
            return run.pace.wait()
        if self.stale and self.credit and run is not None:
            return max(0.0, self._next_frame - time.perf_counter())
        return None

    def obey(self, order: dict[str, Any]) -> None:
        """Carry out one order; what cannot be done is answered, never fatal."""
        try:
            result = self.orders.obey(order)
        except ScenarioError as error:
            self._refuse(order, "; ".join(map(str, error.problems)), [vars(p) for p in error.problems])
        except (BarchanError, OSError, LookupError, TypeError, ValueError) as error:
            self._refuse(order, str(error), [])
        else:
            if "re" in order:
                self.tell("done", re=order["re"], **(result or {}))

    def _refuse(self, order: dict[str, Any], text: str, problems: list[dict[str, Any]]) -> None:
        self.tell("refused", re=order.get("re"), order=order["do"], text=text, problems=problems)

    def work(self) -> None:
        """Do some steps, then send a frame if one is wanted and can be taken."""
        run = self.orders.run
        if run is None:
            return
        if run.busy:
            arrived = run.breathe()
            self.stale = True
            if arrived:
                if self.credit:  # those who compare two runs see both at every meeting
                    self._send_frame()
                self.tell("arrived", step=run.live.steps_done)
        if self.stale and self.credit and time.perf_counter() >= self._next_frame:
            self._send_frame()

    def attach(self) -> None:
        """A browser came: tell it everything anew."""
        self.credit = FRAMES_IN_FLIGHT
        self.ground_sent = None
        self.history_sent = []
        self.flights.again()
        self.stale = True
        if self.orders.run is not None:
            self.orders.run.gauges.again()
            self.describe()

    def describe(self) -> None:
        """Tell what is being run."""
        from barchan.studio.description import description

        assert self.orders.run is not None
        self.tell("scenario", **description(self.orders.run.live))

    def _send_frame(self) -> None:
        from barchan.studio.planes import plane_of, surface_planes

        run = self.orders.run
        assert run is not None
        shown = run.shown
        planes = list(surface_planes(shown, shown.bed.ground is not self.ground_sent))
        earlier = run.earlier() if "change" in self.wanted else None
        planes += [plane for name in self.wanted if (plane := plane_of(shown, name, earlier)) is not None]
        header: dict[str, Any] = {
            "run": self.name,
            "number": self._number,
            "rows": shown.lattice.rows,
            "columns": shown.lattice.columns,
            "status": run.status(),
        }
        steps = run.history.steps
        if steps != self.history_sent:
            header["history"] = self.history_sent = steps
        if rows := run.gauges.sent():
            header["measures"] = rows
        if (paths := self.flights.over(shown, at_once=not run.busy)) is not None:
            header["paths"] = paths
        self._next_frame = time.perf_counter() + FRAME_PAUSE
        self._number += 1
        self.credit -= 1
        self.stale = False
        self.ground_sent = shown.bed.ground
        self.connection.send_bytes(frame(header, planes))


def folder_of(order: dict[str, Any]) -> Path:
    """The folder that the server names in an order; it never comes from the browser as it is."""
    return Path(order["folder"])
