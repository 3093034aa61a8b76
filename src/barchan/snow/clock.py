"""The bond clock: one age for all snow, counted at the rate of the present temperature.

Layers keep the epoch at which they came to rest, so nothing has to be updated as snow ages. Time is summed in
whole microseconds: sums do not depend on how a run is cut.
"""

from typing import Any

from barchan.snow.conditions import EPOCH_SECONDS

FIRST_EPOCH = 1 << 20
"""Epoch at the start of a run: twenty years at -10 °C, the oldest snow to begin with."""

_EPOCH = round(EPOCH_SECONDS * 1e6)


class BondClock:
    """Time of bonding (µs at -10 °C), and the run's time (µs)."""

    def __init__(self) -> None:
        """Start at the first epoch."""
        self.bonding = FIRST_EPOCH * _EPOCH
        self.time = 0

    @property
    def epoch(self) -> int:
        """The present epoch."""
        return self.bonding // _EPOCH

    def pass_time(self, bonding: int, time: int, steps: int) -> None:
        """Let ``steps`` pass, each of ``time`` µs, in which bonds age by ``bonding`` µs."""
        self.bonding += bonding * steps
        self.time += time * steps

    def steps_to_next_epoch(self, bonding: int) -> int:
        """Steps, each ageing bonds by ``bonding`` µs, until the epoch changes; at least one."""
        if bonding == 0:
            return 2**62
        return -(-((self.epoch + 1) * _EPOCH - self.bonding) // bonding)

    def state(self) -> dict[str, Any]:
        """Bonding and run time."""
        return {"bonding": self.bonding, "time": self.time}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up a remembered state."""
        self.bonding, self.time = int(state["bonding"]), int(state["time"])
