"""Changes during a run: a parameter moved, the wind overridden, a stroke painted.

Scenario plus events gives the same bits again.
"""

import json
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args

from pydantic import Field, TypeAdapter, ValidationError, field_validator, model_validator

from barchan.errors import Problem, ScenarioError
from barchan.parameters import declarations, parameter
from barchan.scenario import Scenario, nearest, validate
from barchan.scenario.definition import without_empty_notes
from barchan.scenario.effects import refuse_weather
from barchan.scenario.migrations import current_key, current_value, current_wind
from barchan.simulation.change import Change, wrong
from barchan.simulation.strokes import IceStroke, PlantStroke, RockStroke, SnowfallStroke, Stroke
from barchan.wind import Wind

if TYPE_CHECKING:
    from barchan.simulation.core import Simulation


class SetParameter(Change):
    """A live parameter of the model takes a new value."""

    kind: Literal["set"] = parameter("set", unit="-", meaning="A parameter takes a new value.")
    key: str = parameter(unit="-", meaning="The parameter, for instance model.hop_length.")
    value: Any = parameter(unit="-", meaning="Its value from now on.")

    @model_validator(mode="before")
    @classmethod
    def _called_as_now(cls, data: Any) -> Any:
        """A key of an earlier format is the one that it stands for now."""
        key = data.get("key") if isinstance(data, dict) else None
        if not isinstance(key, str) or current_key(key) == key:
            return data
        now = current_key(key)
        return {**data, "key": now, "value": current_value(now, data.get("value"))}

    def apply(self, simulation: "Simulation") -> None:
        """Give the model its new parameters; where they change which slopes stand, the bed settles."""
        model = simulation.model
        live = [f"model.{d.key}" for d in declarations(type(model.parameters)) if d.live]
        if self.key not in live:
            message = f"cannot change during a run{nearest(self.key, live)}; what can: {', '.join(live)}"
            raise ScenarioError([Problem(self.key, message)], "event")
        rules = model.slope_rules()
        simulation.change_model(_amended(simulation, self))
        if model.slope_rules() != rules:
            model.relax(simulation.bed)

    def summary(self) -> str:
        """Key and value."""
        return f"{self.key} {json.dumps(self.value, ensure_ascii=False)}"

    def amend(self, scenario: dict[str, Any]) -> None:
        """Set the value at its key."""
        *groups, name = self.key.split(".")
        group = scenario
        for inner in groups:
            group = group[inner]
        group[name] = self.value


class SetWind(Change):
    """Another wind from now on."""

    kind: Literal["wind"] = parameter("wind", unit="-", meaning="Another wind.")
    wind: Wind = Field(description="The wind from now on.")

    @field_validator("wind", mode="before")
    @classmethod
    def _steady_unless_stated(cls, wind: Any) -> Any:
        return {"kind": "steady", **wind} if isinstance(wind, dict) else wind

    def apply(self, simulation: "Simulation") -> None:
        """Replace the wind."""
        wanted = _amended(simulation, self).wind
        # A record that cannot be read is refused before anything changes.
        replace(simulation.forcing, wind=wanted).wind_of(simulation.steps_done)
        refuse_weather(simulation.scenario, wanted)
        simulation.wind = wanted

    def summary(self) -> str:
        """The wind in few words."""
        return f"wind {self.wind.summary()}"

    def amend(self, scenario: dict[str, Any]) -> None:
        """Replace the wind."""
        scenario["wind"] = self.wind.model_dump(mode="json")


AnyEvent = SetParameter | SetWind | Stroke | SnowfallStroke | RockStroke | IceStroke | PlantStroke

Event = Annotated[AnyEvent, Field(discriminator="kind")]

_EVENTS: TypeAdapter[Any] = TypeAdapter(Event)


@dataclass(frozen=True)
class Record:
    """An event and the number of steps that were done when it happened."""

    step: int
    event: AnyEvent

    def __str__(self) -> str:
        return f"at step {self.step}: {self.event.summary()}"

    def data(self) -> dict[str, Any]:
        """The record as plain data."""
        data = without_empty_notes(self.event.model_dump(mode="json"))
        if data.get("trail") == []:
            del data["trail"]  # as journals of earlier versions have it
        return {"step": self.step, **data}

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> "Record":
        """The record that ``data`` holds."""
        data = dict(data)
        if data.get("kind") == "set":
            data.setdefault("value", None)  # earlier journals left out a null
        if data.get("kind") == "wind":
            data["wind"] = current_wind(data["wind"])
        return cls(data.pop("step"), event_from(data))


def in_force(scenario: Scenario, events: Iterable[Record], step: int) -> Scenario:
    """The scenario with the parameters and the wind of the last of ``step`` steps (at 0: of the first)."""
    data = scenario.data()
    for record in events:
        if record.step < max(step, 1):
            record.event.amend(data)
    return validate(data, "events").lasting(scenario)


def event_from(data: Any) -> AnyEvent:
    """An event from plain data; raises ScenarioError where it is not one."""
    try:
        event: AnyEvent = _EVENTS.validate_python(data)
    except ValidationError as error:
        raise wrong(error, _kind_of(data), data) from None
    return event


def _kind_of(data: Any) -> type[Change]:
    """The class of event that plain data mean to be."""
    kinds = {kind.model_fields["kind"].default: kind for kind in get_args(AnyEvent)}
    name = data.get("kind") if isinstance(data, dict) else None
    return kinds.get(name, Change) if isinstance(name, str) else Change


def _amended(simulation: "Simulation", change: Change) -> Scenario:
    """The scenario as it is in force, with a change made; raises ScenarioError where it is not sound."""
    data = simulation.current_data()
    change.amend(data)
    return validate(data, "event")
