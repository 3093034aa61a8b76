"""What ends a run before its last step: the conditions of ``run.until``, looked at between steps."""

from typing import TYPE_CHECKING, Any, Protocol

from barchan.model import Tally
from barchan.scenario import Scenario

if TYPE_CHECKING:
    from barchan.simulation.core import Simulation


class StopCondition(Protocol):
    """Looks at a simulation at its own interval and says when the run ends, and why."""

    every: int
    """Steps from one look to the next."""

    def check(self, simulation: "Simulation", tally: Tally) -> str | None:
        """The reason to end, if there is one; ``tally`` holds what happened since the last look."""
        ...

    def state(self) -> dict[str, Any]:
        """What was seen so far: arrays, and what JSON can hold."""
        ...

    def restore(self, state: dict[str, Any]) -> None:
        """Take up what was seen before."""
        ...


class IdleSteps:
    """Ends a run after a number of steps in a row in which nothing moved."""

    every = 1

    def __init__(self, limit: int) -> None:
        """Count up to ``limit`` steps."""
        self.limit = limit
        self.idle = 0
        """Steps in a row, up to now, in which nothing moved."""

    def check(self, _simulation: "Simulation", tally: Tally) -> str | None:
        """Count a step."""
        self.idle = self.idle + tally.steps if tally.idle else 0
        return f"nothing moved for {self.idle} steps" if self.idle >= self.limit else None

    def state(self) -> dict[str, Any]:
        """The steps counted."""
        return {"idle": self.idle}

    def restore(self, state: dict[str, Any]) -> None:
        """Go on counting from there."""
        self.idle = state["idle"]


def stop_conditions(scenario: Scenario) -> dict[str, StopCondition]:
    """The conditions that ``run.until`` states, by its keys."""
    until = scenario.run.until
    found: dict[str, StopCondition] = {}
    if until.idle_steps is not None:
        found["idle_steps"] = IdleSteps(until.idle_steps)
    if until.steady is not None:
        from barchan.simulation.steady_state import SteadyBedforms

        found["steady"] = SteadyBedforms(until.steady, scenario)
    return found
