"""The speed of a run: steps per second, measured and limited."""

import time

from barchan.simulation import StepPacer

WATCHABLE = 40.0
"""Most steps per second unless somebody chooses otherwise: dunes grow as slowly as one can follow."""

AVERAGED_OVER = 0.5
"""Seconds over which the speed is averaged, about."""


class RunSpeed:
    """Steps per second: measured, and limited where the user wants to watch."""

    def __init__(self, chunk_seconds: float) -> None:
        """Nothing measured, a limit that lets one watch; without a limit chunks take this duration."""
        self.limit: float | None = WATCHABLE
        """Most steps per second."""
        self.rate = 0.0
        """Steps per second, measured."""
        self._pacer = StepPacer(chunk_seconds)
        self.restart()

    def restart(self) -> None:
        """Measure from now on."""
        self._since = self._allowed_from = time.perf_counter()
        self._counted = self._allowed = 0

    @property
    def steps(self) -> int:
        """Steps to do in the next chunk, at least one; 0 while the limit asks to wait."""
        if self.limit is None:
            return self._pacer.steps
        allowed = int((time.perf_counter() - self._allowed_from) * self.limit) + 1 - self._allowed
        return max(0, min(self._pacer.steps, allowed))

    def wait(self) -> float:
        """Seconds until the limit lets the next step pass."""
        if self.limit is None:
            return 0.0
        return max(0.0, self._allowed_from + self._allowed / self.limit - time.perf_counter())

    def record(self, steps: int, seconds: float) -> None:
        """Count steps that took a time."""
        self._pacer.record(steps, seconds)
        self._counted += steps
        self._allowed += steps
        now = time.perf_counter()
        if now - self._since >= AVERAGED_OVER:
            self.rate = self._counted / (now - self._since)
            self._since, self._counted = now, 0
        if self.limit is not None and now - self._allowed_from > self._allowed / self.limit + 1.0:
            self._allowed_from, self._allowed = now, 0  # slower than allowed: no catching up later
