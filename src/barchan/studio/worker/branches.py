"""The ways that one run went from its states: each is kept, so that one can go back to it."""

from dataclasses import dataclass
from typing import Any

from barchan.errors import BarchanError
from barchan.simulation import Simulation
from barchan.studio.worker.history import BUDGET, History
from barchan.studio.worker.live_measures import Gauges

MOST = 8
"""Branches that are kept; beyond, the one that was left first is forgotten."""


@dataclass
class Branch:
    """A way that the run went, as it was when it was left."""

    number: int
    began: int
    """The step from which on it goes its own way."""
    simulation: Simulation
    history: History
    gauges: Gauges


class Branches:
    """All ways of one run, in the order in which they were left, last of all the one that it is on."""

    def __init__(self, simulation: Simulation, history: History, gauges: Gauges) -> None:
        """A run that went one way only."""
        self._kept = [Branch(1, 0, simulation, history, gauges)]
        self._numbered = 1

    @property
    def current(self) -> int:
        """The number of the branch that the run is on."""
        return self._kept[-1].number

    def leave(self, simulation: Simulation, history: History, gauges: Gauges) -> None:
        """Keep the branch that the run is on as it is now."""
        now = self._kept[-1]
        now.simulation, now.history, now.gauges = simulation, history, gauges
        history.fit(BUDGET // MOST)

    def add(self, simulation: Simulation, history: History, gauges: Gauges) -> None:
        """Go another way from a simulation that has this past."""
        self._numbered += 1
        began = simulation.steps_done
        self._kept = [
            *self._kept[-MOST + 1 :],
            Branch(self._numbered, began, simulation, history, gauges),
        ]

    def take(self, number: int) -> Branch:
        """Go on with another branch; raises BarchanError where it is not kept."""
        found = next((branch for branch in self._kept if branch.number == number), None)
        if found is None:
            raise BarchanError(f"no branch {number}; kept: {', '.join(str(b.number) for b in self._kept)}")
        self._kept = [*(branch for branch in self._kept if branch is not found), found]
        return found

    def told(self, live: int) -> list[dict[str, Any]]:
        """Number of each branch, the step at which it began and the last one; ``live`` is the run's."""
        told = [{"number": b.number, "began": b.began, "step": b.simulation.steps_done} for b in self._kept]
        told[-1]["step"] = live
        return sorted(told, key=lambda branch: branch["number"])
