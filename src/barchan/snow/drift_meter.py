"""The drift in the air, measured by how far quanta travelled in the last steps."""

from typing import Any

DRIFTING = 0.01
"""Drift in the air over saturation from which impacts keep loose snow moving."""

_FRACTION = 1e9
"""Parts in which the drift in the air is remembered."""


class DriftMeter:
    """Travel of quanta over that of saturated drift, in whole numbers, so that sums do not depend on cuts."""

    def __init__(self) -> None:
        """No drift is in the air yet."""
        self.share = 0.0
        """Drift in the air over saturation."""
        self._travel = 0
        self._saturated = 0

    def note(self, travel: int, saturated: int) -> None:
        """Take in how far quanta travelled, and how far they would have over flat, fresh drift."""
        self._travel += travel
        self._saturated += saturated

    def take_stock(self) -> None:
        """Find the share since the last time; nothing in a calm."""
        self.share = 0.0
        if self._saturated > 0:
            self.share = round(self._travel / self._saturated * _FRACTION) / _FRACTION
        self._travel = self._saturated = 0

    def state(self) -> dict[str, Any]:
        """What to remember."""
        return {"drift": self.share, "travel": self._travel, "saturated": self._saturated}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up what was remembered."""
        self.share = float(state["drift"])
        self._travel, self._saturated = int(state["travel"]), int(state["saturated"])
