"""Changes during a run: a parameter moved, the wind overridden, a stroke painted.

Scenario plus events gives the same bits again.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, TypeAdapter, ValidationError, field_validator

from barchan.errors import ScenarioError
from barchan.ground.brush import Falloff
from barchan.ground.sand import MOST_SLABS
from barchan.parameters import Parameters, parameter
from barchan.scenario import Scenario, validate
from barchan.scenario.messages import problems_of
from barchan.scenario.migrations import current_key, current_value
from barchan.wind import Wind

MOST_PLANTS = 100.0
"""Bound of what one stroke changes of plants."""


class Change(Parameters):
    """What may happen between two steps; raises ScenarioError where it is given wrongly."""

    if not TYPE_CHECKING:  # for a type checker the fields are the signature

        def __init__(self, **data: Any) -> None:
            try:
                super().__init__(**data)
            except ValidationError as error:
                raise _wrong(error, type(self), data) from None


class SetParameter(Change):
    """A live parameter of the model takes a new value."""

    kind: Literal["set"] = parameter("set", unit="-", meaning="A parameter takes a new value.")
    key: str = parameter(unit="-", meaning="The parameter, for instance model.hop_length.")
    value: Any = parameter(unit="-", meaning="Its value from now on.")

    def put(self, data: dict[str, Any]) -> None:
        """Set the value in the plain data of a scenario."""
        *groups, last = self.key.split(".")
        for name in groups:
            data = data[name]
        data[last] = self.value


class SetWind(Change):
    """Another wind from now on."""

    kind: Literal["wind"] = parameter("wind", unit="-", meaning="Another wind.")
    wind: Wind = Field(description="The wind from now on.")

    @field_validator("wind", mode="before")
    @classmethod
    def _steady_unless_stated(cls, wind: Any) -> Any:
        return {"kind": "steady", **wind} if isinstance(wind, dict) else wind


class Patch(Change):
    """A round patch that a brush works on."""

    x: float = parameter(unit="m", meaning="Centre, from the west edge.")
    y: float = parameter(unit="m", meaning="Centre, from the south edge.")
    radius: float = parameter(unit="m", gt=0, meaning="Radius of the patch.")
    falloff: Falloff = parameter("smooth", unit="-", meaning="How the amount falls towards the rim.")


class Stroke(Patch):
    """Sand added to, or taken from, a round patch."""

    kind: Literal["stroke"] = parameter("stroke", unit="-", meaning="Sand added or taken away.")
    amount: int = parameter(
        unit="slabs",
        ge=-MOST_SLABS,
        le=MOST_SLABS,
        meaning="Slabs at the centre; negative to take away.",
    )


class RockStroke(Patch):
    """Ground raised or lowered on a round patch, under the sand that lies there."""

    kind: Literal["rock"] = parameter("rock", unit="-", meaning="Ground raised or lowered.")
    amount: int = parameter(
        unit="slabs",
        ge=-MOST_SLABS,
        le=MOST_SLABS,
        meaning="Height at the centre; negative to lower, to the lowest ground at most.",
    )


class PlantStroke(Patch):
    """Plants of one species, or what else a model lets grow, set or thinned on a round patch."""

    kind: Literal["plants"] = parameter("plants", unit="-", meaning="Plants set or thinned.")
    field: str = parameter(unit="-", meaning="The model's field that is painted, for instance grass.")
    amount: float = parameter(
        unit="-",
        ge=-MOST_PLANTS,
        le=MOST_PLANTS,
        meaning="Change at the centre; negative to thin, to none at most.",
    )


AnyEvent = SetParameter | SetWind | Stroke | RockStroke | PlantStroke

Event = Annotated[AnyEvent, Field(discriminator="kind")]

_EVENTS: TypeAdapter[Any] = TypeAdapter(Event)


@dataclass(frozen=True)
class Record:
    """An event and the number of steps that were done when it happened."""

    step: int
    event: AnyEvent

    def data(self) -> dict[str, Any]:
        """The record as plain data."""
        return {"step": self.step, **self.event.model_dump(mode="json", exclude_none=True)}

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> "Record":
        """The record that ``data`` holds."""
        data = dict(data)
        if data.get("kind") == "set" and current_key(data["key"]) != data["key"]:
            data["key"] = current_key(data["key"])
            data["value"] = current_value(data["key"], data["value"])
        return cls(data.pop("step"), event_from(data))


def in_force(scenario: Scenario, events: Iterable[Record], step: int) -> Scenario:
    """The scenario with the parameters and the wind of the last of ``step`` steps (at 0: of the first)."""
    data = scenario.data()
    for record in events:
        if record.step < max(step, 1):
            if isinstance(record.event, SetParameter):
                record.event.put(data)
            elif isinstance(record.event, SetWind):
                data["wind"] = record.event.wind.model_dump(mode="json")
    return validate(data, "events")


def event_from(data: Any) -> AnyEvent:
    """An event from plain data; raises ScenarioError where it is not one."""
    try:
        event: AnyEvent = _EVENTS.validate_python(data)
    except ValidationError as error:
        raise _wrong(error, Change, data) from None
    return event


def _wrong(error: ValidationError, kind: type[Parameters], data: Any) -> ScenarioError:
    return ScenarioError(problems_of(error, kind, data, lambda _: ""), "event")
