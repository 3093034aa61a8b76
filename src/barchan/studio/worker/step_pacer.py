"""How fast a run goes, and how fast it may."""

import time

MEMORY = 0.5
"""Seconds over which the speed is averaged, about."""


class Pace:
    """Steps per second: measured, and limited where one wants to watch."""

    def __init__(self) -> None:
        """No limit, nothing measured."""
        self.limit: float | None = None
        self.rate = 0.0
        self._each = 0.0
        self.restart()

    def restart(self) -> None:
        """Measure from now on."""
        self._since = self._allowed_from = time.perf_counter()
        self._counted = self._allowed = 0

    def steps(self, seconds: float) -> int:
        """Steps to do in about so many seconds, at least one; 0 while the limit says to wait."""
        count = max(1, int(seconds / self._each)) if self._each else 1
        if self.limit is None:
            return count
        allowed = int((time.perf_counter() - self._allowed_from) * self.limit) + 1 - self._allowed
        return max(0, min(count, allowed))

    def wait(self) -> float:
        """Seconds until the limit lets the next step pass."""
        if self.limit is None:
            return 0.0
        return max(0.0, self._allowed_from + self._allowed / self.limit - time.perf_counter())

    def took(self, steps: int, seconds: float) -> None:
        """So many steps were done."""
        if steps:
            self._each = seconds / steps if not self._each else 0.7 * self._each + 0.3 * seconds / steps
        self._counted += steps
        self._allowed += steps
        now = time.perf_counter()
        if now - self._since >= MEMORY:
            self.rate = self._counted / (now - self._since)
            self._since, self._counted = now, 0
        if self.limit is not None and now - self._allowed_from > self._allowed / self.limit + 1.0:
            self._allowed_from, self._allowed = now, 0  # slower than allowed: no catching up later
