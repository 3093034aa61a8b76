"""The desk where states wait to be measured: by a process of its own, or at once where there is none."""

import json
import pickle
from collections import deque
from collections.abc import Callable, Container
from multiprocessing.connection import Connection

from barchan.studio.worker.measuring import Job, Measuring, Row

ROOM = 200_000_000
"""Bytes of states that may wait; beyond, their run waits too, so that no step is left out."""

Take = Callable[[Row], None]
"""Takes the row of a job."""


class Desk:
    """Jobs in the order in which they came; the process has one at a time, so that its pipe never blocks."""

    def __init__(self, connection: Connection | None = None) -> None:
        """Let the process at the other end of a connection measure; without one measure at once."""
        self.connection = connection
        self._own = Measuring()
        self._waiting: deque[tuple[Job, Take]] = deque()
        self._away: tuple[Job, Take] | None = None
        self._woken = self._ready = False

    @property
    def pending(self) -> int:
        """Jobs that are not done."""
        return len(self._waiting) + (self._away is not None)

    @property
    def full(self) -> bool:
        """Whether so many states wait that none may come before others are measured."""
        return sum(job.bytes for job, _ in self._waiting) > ROOM

    def submit(self, job: Job, take: Take) -> None:
        """Let a state be measured; ``take`` gets its row."""
        self._waiting.append((job, take))
        if self.connection is None:
            self._work_through()

    def keep_only(self, series: Container[int]) -> None:
        """Leave out the states of other series that wait: their run was given up."""
        self._waiting = deque((job, take) for job, take in self._waiting if job.series in series)

    def wake(self) -> None:
        """Let the process load what it needs; not before, so that it takes no time from the first picture."""
        if self.connection is not None and not self._woken and self._waiting:
            self._woken = True
            self._tell(b"wake")

    def collect(self) -> bool:
        """Take the rows that have come, and hand out the next job; returns whether any came."""
        came = False
        while self.connection is not None and self._hears():
            came |= self._on_answer()
        if self.connection is not None and self._ready and self._away is None and self._waiting:
            self._away = self._waiting.popleft()
            self._tell(pickle.dumps(self._away[0], pickle.HIGHEST_PROTOCOL))
        return came

    def _hears(self) -> bool:
        try:
            return self.connection is not None and self.connection.poll()
        except OSError:
            self._lose()
            return False

    def _on_answer(self) -> bool:
        assert self.connection is not None
        try:
            data = self.connection.recv_bytes()
        except (EOFError, OSError):
            self._lose()
            return True
        if self._away is None:
            self._ready = True
            return False
        (_, take), self._away = self._away, None
        take(json.loads(data))
        return True

    def _tell(self, data: bytes) -> None:
        assert self.connection is not None
        try:
            self.connection.send_bytes(data)
        except OSError:
            self._lose()

    def _lose(self) -> None:
        """The process has ended: measure here from now on."""
        self.connection = None
        if self._away is not None:
            self._waiting.appendleft(self._away)
            self._away = None
        self._work_through()

    def _work_through(self) -> None:
        while self._waiting:
            job, take = self._waiting.popleft()
            take(self._own.row_or_failure(job))


class ClosedDesk(Desk):
    """A desk where nothing is measured, for those who only look."""

    def submit(self, job: Job, take: Take) -> None:
        """Leave the state as it is."""
