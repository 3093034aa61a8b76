"""The process of one simulation: it obeys, works, and sends frames when the browser can take them."""

import json
import signal
import time
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from barchan.errors import BarchanError, ScenarioError
from barchan.studio.protocol import FRAMES_IN_FLIGHT, frame, message

if TYPE_CHECKING:
    from barchan.studio.worker.time_budget import Ration

FIELDS_SHARE = 0.03
"""Share of the time that may go into fields beside the surface."""

FRAME_PAUSE = 0.012
"""Seconds from one frame to the next, at least; a run's breath lets some 60 a second pass."""


def work(connection: Connection, name: str) -> None:
    """Be the worker at this end of a connection until it is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's: it ends its workers itself
    from barchan.kernels.core.compile_notice import told_of_compilation

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
        from barchan.studio.worker.commands import Orders
        from barchan.studio.worker.grain_paths import Flights
        from barchan.studio.worker.time_budget import Ration

        self.connection = connection
        self.name = name
        self.orders = Orders(self)
        self.wanted: list[str] = []
        """Fields that the browser shows beside the surface."""
        self.fields = Ration(FIELDS_SHARE)
        self.flights = Flights()
        self.credit = 0
        self.stale = True
        self.ground_sent: NDArray | None = None
        """The ground that the browser has."""
        self.history_sent: list[int] = []
        self._number = 0
        self._next_frame = 0.0
        self._owed: float | None = None
        """When what the last frame was sent without may follow."""

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
        due = self._next_frame if self.stale else self._owed
        if due is not None and self.credit and run is not None:
            return max(0.0, due - time.perf_counter())
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
        elif self._owed is not None and time.perf_counter() >= self._owed:
            self.stale = True
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
        from barchan.studio.worker.description import description

        run = self.orders.run
        assert run is not None
        branches = run.branches.told(run.live.steps_done)
        self.tell("scenario", **description(run.live), branches=branches, branch=run.branches.current)

    def _may(self, ration: "Ration") -> bool:
        """Whether something may go with a frame; if not, it is owed."""
        if not ration.is_due:
            self._owed = ration.due if self._owed is None else min(self._owed, ration.due)
        return ration.is_due

    def _send_frame(self) -> None:
        from barchan.studio.worker.frame_fields import CHANGE, plane_of, surface_planes

        run = self.orders.run
        assert run is not None
        shown = run.shown
        planes = list(surface_planes(shown, shown.bed.ground is not self.ground_sent))
        self._owed = None
        if self.wanted and self._may(self.fields):
            with self.fields.spending():
                earlier = run.earlier() if CHANGE in self.wanted else None
                found = (plane_of(shown, name, earlier) for name in self.wanted)
                planes += [plane for plane in found if plane is not None]
        header: dict[str, Any] = {
            "fields": self.wanted,
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
        if self.flights.wanted_over(shown) and self._may(self.flights.ration):
            header["paths"] = self.flights.over(shown)
        self._next_frame = time.perf_counter() + FRAME_PAUSE
        self._number += 1
        self.credit -= 1
        self.stale = False
        self.ground_sent = shown.bed.ground
        self.connection.send_bytes(frame(header, planes))


def folder_of(order: dict[str, Any]) -> Path:
    """The folder that the server names in an order; it never comes from the browser as it is."""
    return Path(order["folder"])
