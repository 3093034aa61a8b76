"""The base of everything that may change during a run."""

from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from barchan.errors import ScenarioError
from barchan.parameters import Parameters
from barchan.scenario.messages import problems_of

if TYPE_CHECKING:
    from barchan.simulation.core import Simulation


class Change(Parameters):
    """A change between two steps of a run; raises ScenarioError where it is given wrongly."""

    if not TYPE_CHECKING:  # for a type checker the fields are the signature

        def __init__(self, **data: Any) -> None:
            try:
                super().__init__(**data)
            except ValidationError as error:
                raise wrong(error, type(self), data) from None

    def apply(self, simulation: "Simulation") -> None:
        """Make the change; raises BarchanError, and leaves the simulation as it was, where that cannot be."""
        raise NotImplementedError

    def summary(self) -> str:
        """The change in few words."""
        raise NotImplementedError

    def amend(self, scenario: dict[str, Any]) -> None:
        """Write the change into a scenario's data, in place; changes of the bed leave the scenario alone."""


def wrong(error: ValidationError, kind: type[Parameters], data: Any) -> ScenarioError:
    """The error of a change that is given wrongly."""
    return ScenarioError(problems_of(error, kind, data, lambda _: ""), "event")
