"""The branches of one run: each is kept, so that one can return to it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from barchan.errors import BarchanError
from barchan.simulation import Simulation
from barchan.studio.worker.history import BUDGET, History
from barchan.studio.worker.live_measures import LiveMeasures

MOST = 8
"""Branches that are kept; beyond, the one that was left first is forgotten."""


@dataclass(frozen=True)
class Branch:
    """A branch of the run, as it was when it was left; left again it is another one."""

    number: int
    began: int
    """The step at which it branched off."""
    simulation: Simulation
    history: History
    measures: LiveMeasures


class Branches:
    """All branches of one run, in the order in which they were left; the one that it is on comes last."""

    def __init__(self, current: Branch, others: Sequence[Branch] = (), numbered: int = 1) -> None:
        """A run on a branch, with others in the order in which they were left; ``numbered`` so far."""
        self._kept = [*others, current]
        self._numbered = numbered

    @property
    def current(self) -> int:
        """The number of the branch that the run is on."""
        return self._kept[-1].number

    @property
    def began(self) -> int:
        """The step at which the branch that the run is on branched off."""
        return self._kept[-1].began

    @property
    def others(self) -> list[Branch]:
        """The branches that the run is not on."""
        return self._kept[:-1]

    @property
    def numbered(self) -> int:
        """The highest number that a branch has had."""
        return self._numbered

    @property
    def series(self) -> set[int]:
        """The numbers of the series of all branches at the desk where states are measured."""
        return {branch.measures.number for branch in self._kept}

    @property
    def numbers(self) -> list[int]:
        """The numbers of all branches that are kept."""
        return [branch.number for branch in self._kept]

    def leave(self, simulation: Simulation, history: History, measures: LiveMeasures) -> None:
        """Keep the branch that the run is on as it is now."""
        self._kept[-1] = Branch(self.current, self.began, simulation, history, measures)
        history.fit(BUDGET // MOST)

    def add(
        self, simulation: Simulation, history: History, measures: LiveMeasures, began: int | None = None
    ) -> None:
        """Begin a branch with a simulation that has this past; it began now, or at a step."""
        self._numbered += 1
        began = simulation.steps_done if began is None else began
        self._kept = [
            *self._kept[-MOST + 1 :],
            Branch(self._numbered, began, simulation, history, measures),
        ]

    def take(self, number: int) -> Branch:
        """Return to another branch; raises BarchanError where it is not kept."""
        found = next((branch for branch in self._kept if branch.number == number), None)
        if found is None:
            raise BarchanError(f"no branch {number}; kept: {', '.join(map(str, self.numbers))}")
        self._kept = [*(branch for branch in self._kept if branch is not found), found]
        return found

    def listing(self, live: int) -> list[dict[str, Any]]:
        """Number of each branch, the steps at which it began and ended; ``live`` is the run's newest step."""
        listed = [{"number": b.number, "began": b.began, "step": b.simulation.steps_done} for b in self._kept]
        listed[-1]["step"] = live
        return sorted(listed, key=lambda branch: branch["number"])
