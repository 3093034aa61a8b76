"""Starts of runs that workers were asked for and have not answered yet."""

from dataclasses import dataclass
from typing import Any

from barchan.studio.protocol import Request


@dataclass(frozen=True)
class Start:
    """A request to begin a run."""

    number: int
    request: Request | None
    """None for one that continues from a kept state."""
    scenario: dict[str, Any] | None
    """The scenario that it begins, where that is known before."""


class Starts:
    """The starts of each run in the order in which they were asked for, until they are answered."""

    def __init__(self) -> None:
        """None yet."""
        self._waiting: dict[str, list[Start]] = {}
        self._numbered = 0

    def add(self, run: str, request: Request | None, scenario: dict[str, Any] | None = None) -> Start:
        """One more start."""
        self._numbered += 1
        numbered = None if request is None else {**request, "number": self._numbered}
        start = Start(self._numbered, numbered, scenario)
        self._waiting.setdefault(run, []).append(start)
        return start

    def answered(self, run: str, number: int) -> Start | None:
        """The start of that number, which counts as answered from now on."""
        waiting = self._waiting.get(run, [])
        self._waiting[run] = [start for start in waiting if start.number > number]
        return next((start for start in waiting if start.number == number), None)

    def scenario(self, run: str) -> dict[str, Any] | None:
        """The scenario that was asked for last and has not begun yet."""
        asked = [start.scenario for start in self._waiting.get(run, []) if start.scenario is not None]
        return asked[-1] if asked else None

    def lost(self, run: str) -> Request | None:
        """The newest start that was never looked at because the process ended in an earlier one.

        None where there is none: the first one in the row may have ended the process, and is not tried again.
        """
        waiting = self._waiting.pop(run, [])
        return waiting[-1].request if len(waiting) > 1 else None
