"""The conditions of ``run.until``, which end a run before its last step; they are checked between steps."""

from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from barchan.model import Tally
from barchan.scenario import Scenario
from barchan.words import counted

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
        """The observations up to now: arrays, and values that JSON can hold."""
        ...

    def restore(self, state: dict[str, Any]) -> None:
        """Take up earlier observations."""
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
        return f"nothing moved for {counted(self.idle, 'step')}" if self.idle >= self.limit else None

    def state(self) -> dict[str, Any]:
        """The steps counted."""
        return {"idle": self.idle}

    def restore(self, state: dict[str, Any]) -> None:
        """Go on counting from there."""
        self.idle = state["idle"]


class StopConditions(dict[str, StopCondition]):
    """The conditions that ``run.until`` states, by its keys."""

    def __init__(self, scenario: Scenario) -> None:
        """Make the conditions of a scenario."""
        super().__init__(_conditions(scenario))

    def steps_to_next(self, step: int, limit: int) -> int:
        """Number of steps from ``step`` to the next look of any condition, ``limit`` at most."""
        return min([limit, *(condition.every - step % condition.every for condition in self.values())])

    def check(self, simulation: "Simulation", tally: Tally) -> str | None:
        """The first reason to end the run now; ``tally`` holds what happened since the last look."""
        due = (condition for condition in self.values() if simulation.steps_done % condition.every == 0)
        reasons = (condition.check(simulation, tally) for condition in due)
        return next((reason for reason in reasons if reason is not None), None)

    def state(self) -> tuple[dict[str, dict[str, Any]], dict[str, NDArray]]:
        """The observations of all conditions: plain data by name, and arrays as ``<name>/<key>``."""
        data: dict[str, dict[str, Any]] = {name: {} for name in self}
        arrays: dict[str, NDArray] = {}
        for name, condition in self.items():
            for key, value in condition.state().items():
                if isinstance(value, np.ndarray):
                    arrays[f"{name}/{key}"] = value
                else:
                    data[name][key] = value
        return data, arrays

    def restore(self, data: dict[str, dict[str, Any]], arrays: dict[str, NDArray]) -> None:
        """Take up the observations that ``state`` gave."""
        for name, condition in self.items():
            own = {k.removeprefix(f"{name}/"): v for k, v in arrays.items() if k.startswith(f"{name}/")}
            condition.restore({**data[name], **own})


def _conditions(scenario: Scenario) -> dict[str, StopCondition]:
    until = scenario.run.until
    found: dict[str, StopCondition] = {}
    if until.idle_steps is not None:
        found["idle_steps"] = IdleSteps(until.idle_steps)
    if until.steady is not None:
        from barchan.simulation.steady_state import SteadyBedforms

        found["steady"] = SteadyBedforms(until.steady, scenario)
    return found
