"""Changes during a run: a parameter moved, the wind overridden, a stroke painted.

Scenario plus events gives the same bits again.
"""

from dataclasses import dataclass
from typing import Annotated, Any, Literal

from pydantic import Field, TypeAdapter, ValidationError

from barchan.errors import Problem, ScenarioError
from barchan.ground.brush import Falloff
from barchan.parameters import Parameters, parameter
from barchan.wind import Wind


class SetParameter(Parameters):
    """A live parameter of the model takes a new value."""

    kind: Literal["set"] = parameter("set", unit="-", meaning="A parameter takes a new value.")
    key: str = parameter(unit="-", meaning="The parameter, for instance model.hop_length.")
    value: Any = parameter(unit="-", meaning="Its value from now on.")


class SetWind(Parameters):
    """Another wind from now on."""

    kind: Literal["wind"] = parameter("wind", unit="-", meaning="Another wind.")
    wind: Wind = Field(description="The wind from now on.")


class Stroke(Parameters):
    """Sand added to, or taken from, a round patch."""

    kind: Literal["stroke"] = parameter("stroke", unit="-", meaning="Sand added or taken away.")
    x: float = parameter(unit="m", meaning="Centre, from the west edge.")
    y: float = parameter(unit="m", meaning="Centre, from the south edge.")
    radius: float = parameter(unit="m", gt=0, meaning="Radius of the patch.")
    amount: int = parameter(unit="slabs", meaning="Slabs at the centre; negative to take away.")
    falloff: Falloff = parameter("smooth", unit="-", meaning="How the amount falls towards the rim.")


Event = Annotated[SetParameter | SetWind | Stroke, Field(discriminator="kind")]

_EVENTS: TypeAdapter[Any] = TypeAdapter(Event)


@dataclass(frozen=True)
class Record:
    """An event and the number of steps that were done when it happened."""

    step: int
    event: SetParameter | SetWind | Stroke

    def data(self) -> dict[str, Any]:
        """The record as plain data."""
        return {"step": self.step, **self.event.model_dump(mode="json", exclude_none=True)}

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> "Record":
        """The record that ``data`` holds."""
        data = dict(data)
        return cls(data.pop("step"), event_from(data))


def event_from(data: Any) -> SetParameter | SetWind | Stroke:
    """An event from plain data; raises ScenarioError where it is not one."""
    try:
        event: SetParameter | SetWind | Stroke = _EVENTS.validate_python(data)
    except ValidationError as error:
        problems = [
            Problem(".".join(map(str, item["loc"])), item["msg"]) for item in error.errors(include_url=False)
        ]
        raise ScenarioError(problems, "event") from None
    return event
