"""The bond clock: one age for all snow, counted at the rate of the present temperature.

Layers keep the epoch at which they came to rest, so nothing has to be updated as snow ages. Time is summed in
whole milliseconds: sums do not depend on how a run is cut.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.snow.conditions import EPOCH_SECONDS

FIRST_EPOCH = 1 << 20
"""Epoch at the start of a run: twenty years at -10 °C, the oldest snow to begin with."""

_EPOCH = round(EPOCH_SECONDS * 1000)


class BondClock:
    """Time of bonding (ms at -10 °C), the run's time (ms), and when one ran faster against the other."""

    def __init__(self) -> None:
        """Start at the first epoch."""
        self.bonding = FIRST_EPOCH * _EPOCH
        self.time = 0
        self.marks: list[tuple[int, int]] = [(self.bonding, 0)]
        self._last: tuple[int, int] | None = None

    @property
    def epoch(self) -> int:
        """The present epoch."""
        return self.bonding // _EPOCH

    def pass_time(self, bonding: int, time: int, steps: int) -> None:
        """Let ``steps`` pass, each of ``time`` ms, in which bonds age by ``bonding`` ms."""
        if (bonding, time) != self._last:
            self.marks.append((self.bonding, self.time))
            self._last = (bonding, time)
        self.bonding += bonding * steps
        self.time += time * steps

    def steps_to_next_epoch(self, bonding: int) -> int:
        """Steps, each ageing bonds by ``bonding`` ms, until the epoch changes; at least one."""
        if bonding == 0:
            return 2**62
        return -(-((self.epoch + 1) * _EPOCH - self.bonding) // bonding)

    def hours_since(self, epochs: NDArray[np.int64]) -> NDArray[np.float64]:
        """Time (h) since epochs: run time after the start, before it as at -10 °C."""
        marks = [*self.marks, (self.bonding, self.time)]
        bonding, time = (np.array(column, np.float64) for column in zip(*marks, strict=True))
        at = (epochs.astype(np.float64) + 0.5) * _EPOCH
        then = np.interp(at, bonding, time)
        before = np.maximum(bonding[0] - at, 0.0)
        return np.maximum(self.time - then + before, 0.0) / 3.6e6

    def state(self) -> dict[str, Any]:
        """What to remember."""
        marks = np.array([*self.marks], np.int64)
        return {"bonding": self.bonding, "time": self.time, "marks": marks, "last": np.array(self._last or ())}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up what was remembered."""
        self.bonding, self.time = int(state["bonding"]), int(state["time"])
        self.marks = [(int(b), int(t)) for b, t in np.asarray(state["marks"]).tolist()]
        last = np.asarray(state["last"]).astype(np.int64).tolist()
        self._last = (last[0], last[1]) if last else None
