"""Sends frames of a run when the browser can take them, with only those parts that it does not have."""

import time
from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

from barchan.simulation import Simulation
from barchan.squares import Squares
from barchan.studio.protocol import FRAMES_IN_FLIGHT, EncodedField, frame
from barchan.studio.worker.frame_fields import CHANGE, encoded, encoded_field, surface_fields
from barchan.studio.worker.grain_paths import GrainPaths
from barchan.studio.worker.overlay import Overlay
from barchan.studio.worker.run import StudioRun
from barchan.studio.worker.time_budget import TimeBudget

FIELDS_SHARE = 0.03
"""Share of the time that may go into fields beside the surface."""

FRAME_PAUSE = 0.012
"""Seconds from one frame to the next, at least; the chunks of a run let some 60 a second pass."""


class FrameSender:
    """Makes frames, and knows which parts of earlier ones the browser has."""

    def __init__(self, name: str, send: Callable[[bytes], None]) -> None:
        """Send frames of the run ``name``, as bytes; none may be sent before a browser comes."""
        self.name = name
        self.fields: list[str] = []
        """Fields that the browser shows beside the surface."""
        self.overlay: Overlay | None = None
        """The terrain that the surface is compared with."""
        self.paths = GrainPaths()
        self.credit = 0
        """Frames that the browser can take now."""
        self.stale = True
        """Whether the run is no longer as the last frame shows it."""
        self.loaded = 0
        """The number of the start that loaded the run's scenario, which frames and descriptions name."""
        self._send = send
        self._field_budget = TimeBudget(FIELDS_SHARE)
        self._ground_sent: NDArray | None = None
        self._history_sent: list[int] = []
        self._number = 0
        self._next = 0.0
        self._owed: float | None = None
        """Moment from which the parts that the last frame lacks may follow."""

    def attach(self) -> None:
        """A browser came that has no frame yet."""
        self.credit = FRAMES_IN_FLIGHT
        self.stale = True
        self.forget()

    def confirm(self) -> None:
        """The browser has drawn a frame, of those that are on their way to it."""
        self.credit = min(self.credit + 1, FRAMES_IN_FLIGHT)

    def forget(self) -> None:
        """Send ground, history and paths again: those that the browser has are of another run."""
        self._ground_sent = None
        self._history_sent = []
        self.paths.resend()

    @property
    def is_first(self) -> bool:
        """Whether the next frame is the first one of a run."""
        return self._ground_sent is None

    def refresh(self) -> None:
        """Send a frame with all fields as soon as possible."""
        self.stale = True
        self._field_budget.at_once()

    def wait(self) -> float | None:
        """Seconds until a frame is due for a run at rest; None where no frame is."""
        due = self._next if self.stale else self._owed
        return max(0.0, due - time.perf_counter()) if due is not None and self.credit else None

    def send_if_due(self, run: StudioRun) -> None:
        """Send a frame where one is due and the browser can take it."""
        now = time.perf_counter()
        if self._owed is not None and now >= self._owed:
            self.stale = True
        if self.stale and self.credit and now >= self._next:
            self.send(run)

    def send(self, run: StudioRun) -> None:
        """Send a frame."""
        shown = run.shown
        encoded = list(surface_fields(shown, shown.bed.ground is not self._ground_sent))
        self._owed = None
        if self.fields and self._may(self._field_budget):
            with self._field_budget.spending():
                encoded += self._encoded(run)
        header = self._header(run)
        if self.paths.wanted_over(shown) and self._may(self.paths.budget):
            header["paths"] = self.paths.over(shown)
        self._next = time.perf_counter() + FRAME_PAUSE
        self._number += 1
        self.credit -= 1
        self.stale = False
        self._ground_sent = shown.bed.ground
        self._send(frame(header, encoded))

    def _encoded(self, run: StudioRun) -> list[EncodedField]:
        earlier = run.earlier() if CHANGE in self.fields else None
        found = (self._field(run.shown, name, earlier) for name in self.fields)
        return [field for field in found if field is not None]

    def _field(self, shown: Simulation, name: str, earlier: NDArray | None) -> EncodedField | None:
        own = self.overlay.values(name, shown) if self.overlay and self.overlay.fits(shown) else None
        return encoded_field(shown, name, earlier) if own is None else encoded(shown, name, own)

    def _header(self, run: StudioRun) -> dict[str, Any]:
        squares = Squares(run.shown.lattice).lattice
        header: dict[str, Any] = {
            "shown": self.fields,
            "run": self.name,
            "number": self._number,
            "loaded": self.loaded,
            "rows": squares.rows,
            "columns": squares.columns,
            "status": run.status(),
        }
        steps = run.history.steps
        if steps != self._history_sent:
            header["history"] = self._history_sent = steps
        return header | run.measures.unsent()

    def _may(self, budget: TimeBudget) -> bool:
        """Whether a part may go with a frame; if not, it is owed."""
        if not budget.is_due:
            self._owed = budget.due if self._owed is None else min(self._owed, budget.due)
        return budget.is_due
