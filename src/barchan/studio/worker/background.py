"""Answers that take longer than a step: work in a thread beside the run, and measures that are to come."""

import threading
from collections.abc import Callable
from typing import Any, Protocol

from barchan.errors import BarchanError
from barchan.studio.protocol import ANSWERED
from barchan.studio.worker.measures_table import measures_table
from barchan.studio.worker.run import StudioRun

Count = Callable[[int, int], None]
"""Takes how much is done, and of how much."""


class Later(Protocol):
    """Something that will have the content of an answer."""

    done: int
    of: int
    """How much is done, of how much."""

    def result(self) -> dict[str, Any] | None:
        """The content, None as long as there is none; raises what has made it impossible."""

    def break_off(self) -> None:
        """Give it up; ``result`` raises BrokenOffError then."""


class BrokenOffError(BarchanError):
    """Work that somebody has broken off."""

    def __init__(self) -> None:
        super().__init__("broken off")


class AllMeasured:
    """The rows of a run at all fixed steps up to now, as soon as every one of them is measured.

    Of a run that rests the last row is that of its newest state, at whatever step. A run that goes on is at
    a step that depends on the machine, so its table ends at a fixed one.
    """

    def __init__(self, current: Callable[[], StudioRun]) -> None:
        """Wait for the measures that the current run has now."""
        self.done, self.of = 0, 1
        run = current()
        self._current, self._measures = current, run.measures
        self._last = run.measures.newest
        if run.rests:
            run.measures.take_extra(run.live)
            self._last = run.live.steps_done
        self._broken = False

    def break_off(self) -> None:
        """Wait no longer."""
        self._broken = True

    def result(self) -> dict[str, Any] | None:
        """The rows; raises BarchanError where the run has left the branch that was asked about."""
        if self._broken:
            raise BrokenOffError
        if self._current().measures is not self._measures:
            raise BarchanError("another run or branch was begun before all steps were measured")
        rows = self._measures.ending_at(self._last)
        self.done, self.of = len(rows), max(len(rows) + self._current().desk.pending, 1)
        return measures_table(self._current().live.scenario, rows) if self._measures.has(self._last) else None


class Background:
    """A piece of work in a thread; it only reads what no step changes."""

    def __init__(self, work: Callable[[Count], dict[str, Any]]) -> None:
        """Begin; ``work`` gets a function that counts, and returns the content of the answer.

        The function that counts raises BrokenOffError where the work is broken off.
        """
        self.done, self.of = 0, 1
        self._result: dict[str, Any] | None = None
        self._error: Exception | None = None
        self._broken = False
        self._work = work
        self._thread = threading.Thread(target=self._run, daemon=True, name="barchan-background")
        self._thread.start()

    def result(self) -> dict[str, Any] | None:
        """The content of the answer, None while the work goes on; raises what it has raised."""
        if self._thread.is_alive():
            return None
        if self._error is not None:
            raise self._error
        return self._result

    def break_off(self) -> None:
        """Let the work end where it counts next."""
        self._broken = True

    def _count(self, done: int, of: int) -> None:
        if self._broken:
            raise BrokenOffError
        self.done, self.of = done, of

    def _run(self) -> None:
        try:
            self._result = self._work(self._count)
        except ANSWERED as error:
            self._error = error


class Reading(Background):
    """Work that leaves nothing behind and cannot be stopped half-way, such as reading a file.

    Where it is broken off nobody waits for it: what it gives is dropped.
    """

    def result(self) -> dict[str, Any] | None:
        """As of ``Background``; raises BrokenOffError as soon as it is broken off."""
        if self._broken:
            raise BrokenOffError
        return super().result()
