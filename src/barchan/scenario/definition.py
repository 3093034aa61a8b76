"""The parts of a scenario and their defaults."""

import secrets
from collections.abc import Iterable
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self, Union

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, PrivateAttr, model_validator
from pydantic_core import PydanticCustomError

from barchan.bed import Bed
from barchan.fields import LayerInfo
from barchan.ground.landforms import FlatGround
from barchan.ground.sand import FlatSand, Sand
from barchan.ground.start import first_bed
from barchan.ground.surface import Ground
from barchan.lattice import Lattice
from barchan.models import Model, models
from barchan.parameters import Parameters, parameter
from barchan.scenario.consistency import broken_edges, inconsistencies, starved_edges
from barchan.scenario.effects import (
    falls_too_little,
    idle,
    recorded_facts,
    recorded_remarks,
    sand_facts,
    stated_speeds,
    unmoved,
    unused,
)
from barchan.scenario.lengths import unmatched_frames, wind_length_facts
from barchan.scenario.source_map import SourceMap
from barchan.scenario.summary import html_table, in_a_line, summary
from barchan.wind import Clock, Forcing, Steady, StepClock, WeatherCourse, Wind
from barchan.wind.clock import spoken
from barchan.wind.influx import AnyInflux

FORMAT = 5
"""Version of the configuration format that this program writes."""

LARGEST_SEED = 2**53 - 1

MOST_STEPS = 10**12
"""Steps of the longest run."""

TOGETHER = "parts_do_not_go_together"
"""Type of the error for parts of a scenario that do not fit each other."""

if TYPE_CHECKING:
    AnyModel = Any
else:
    AnyModel = Annotated[Union[*(m.Parameters for m in models().values())], Field(discriminator="name")]


class SteadyState(Parameters):
    """When a run counts as steady: spacing, straightness and speed stay constant over a window."""

    window: int = parameter(
        500, unit="steps", ge=10, le=10**9, scale="log", meaning="How long the measures must stay constant."
    )
    tolerance: float = parameter(
        0.05,
        unit="-",
        gt=0,
        le=1,
        meaning="Largest spread over the window: of spacing and speed relative to their means, of "
        "straightness (0 to 1) as it is.",
    )


class Until(Parameters):
    """Conditions that end a run before its last step."""

    idle_steps: int | None = parameter(
        None,
        unit="steps",
        ge=1,
        le=10**9,
        meaning="Stop after this number of steps in a row in which nothing moved.",
    )
    steady: SteadyState | None = Field(default=None, description="Stop when the bedforms are steady.")


class Run(Parameters):
    """Number of steps, seed, and frames to keep."""

    steps: int = parameter(
        1000,
        unit="steps",
        ge=0,
        le=MOST_STEPS,
        scale="log",
        meaning="Length of the run; a step polls as many cells as the field has. 'record' is as long as the "
        "wind's record, which must have an end (wind.repeat false).",
        source="Prague thesis, Table 6.1",
    )
    seed: int | None = parameter(
        None,
        unit="-",
        ge=0,
        le=LARGEST_SEED,
        meaning="Start of all random numbers; if none is given, a random one is taken and stored.",
    )
    save_every: int = parameter(
        50, unit="steps", ge=1, le=10**12, scale="log", meaning="Steps from one saved frame to the next."
    )
    threads: int | None = parameter(
        None,
        unit="-",
        ge=1,
        le=1024,
        meaning="Threads that share the work, all cores if not given; results do not depend on it. The "
        "option --threads and the environment variable BARCHAN_THREADS come before it.",
    )
    until: Until = Field(default_factory=Until, description="Conditions that end the run earlier.")


DEFAULT_MODEL = "werner"


def _default_model() -> Any:
    return models()[DEFAULT_MODEL].Parameters()


class Scenario(Parameters):
    """Everything that defines a run: same scenario and seed, same bits."""

    barchan: Literal[5] = parameter(FORMAT, unit="-", meaning="Version of the configuration format.")
    title: str = parameter("", unit="-", max_length=200, meaning="Name of the scenario.")
    citation: str = parameter("", unit="-", max_length=1000, meaning="Where the scenario comes from.")
    look_for: str = parameter("", unit="-", max_length=2000, meaning="Features to watch for in the run.")
    question: str = parameter(
        "", unit="-", max_length=500, meaning="A question that one can answer by changing the run."
    )
    lattice: Lattice = Field(default_factory=Lattice, description="Lattice.")
    ground: Ground = Field(default_factory=FlatGround, description="Ground under the sand.")
    sand: Sand = Field(default_factory=FlatSand, description="Sand at the start.")
    wind: Wind = Field(default_factory=Steady, description="Wind.")
    weather: WeatherCourse | None = Field(
        default=None,
        description="Temperature and snowfall over the run, where the wind states none; unknown where not "
        "given.",
    )
    influx: AnyInflux | None = Field(
        default=None, description="Sand that enters across open edges from upwind; none where not given."
    )
    clock: Clock | None = Field(
        default=None,
        description="Gives steps a duration, and speeds in m/s their polls; without a clock time is counted "
        "in steps.",
    )
    model: AnyModel = Field(default_factory=_default_model, description="Model.")
    run: Run = Field(default_factory=Run, description="Run.")

    _source_map: SourceMap = PrivateAttr(default_factory=SourceMap)

    @property
    def source_map(self) -> SourceMap:
        """Where its keys stand, as far as it was read from somewhere."""
        return self._source_map

    def with_source_map(self, source_map: SourceMap) -> Self:
        """The same scenario, with where its keys stand."""
        copied = self.model_copy()
        copied._source_map = source_map
        return copied

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        found = inconsistencies(self, self.new_model())
        if found:
            raise PydanticCustomError(TOGETHER, "{text}", {"found": found, "text": found[0][1]})
        return self

    @property
    def layers(self) -> tuple[LayerInfo, ...]:
        """The layers on the ground that the model's wind can move, the lowest first."""
        return self.new_model().layers

    def first_bed(self) -> Bed:
        """The bed that a run starts with; raises ScenarioError with every problem found."""
        model = self.new_model()
        return first_bed(
            self.lattice,
            self.ground,
            self.sand,
            self.seed,
            model.layers,
            unit_height=model.unit_height,
            beneath=model.beneath,
        )

    def new_model(self) -> Model:
        """The model, set up for the lattice and the wind."""
        model = models()[self.model.name](self.model, self.lattice)
        model.winds_off_axes = self.wind.off_axes(self.lattice.hexagonal)
        return model

    @property
    def step_seconds(self) -> float | None:
        """Duration of a step (s), where it is known."""
        model = self.new_model()
        return model.step_seconds if self.clock is None else self.clock.duration(model.step_volume())

    def lasting(self, started: "Scenario") -> "Scenario":
        """The same with steps as long as those of the scenario that a run of it ``started`` with.

        A clock gives a step the time in which the reference wind moves as much sand as the step does. A run
        keeps its steps when a parameter changes what they move; the polls of its winds follow.
        """
        clock = self.clock
        if clock is None or clock.step_seconds is not None or self.step_seconds == started.step_seconds:
            return self
        kept = clock.model_copy(update={"step_seconds": started.step_seconds})
        return self.model_copy(update={"clock": kept})

    def time_facts(self) -> dict[str, str]:
        """How long a step and the run last, where that is known, for people to read."""
        seconds = self.step_seconds
        if seconds is None:
            return {}
        facts = {"step": spoken(seconds), "run": spoken(seconds * self.run.steps), **wind_length_facts(self)}
        if self.clock is not None:
            facts["threshold of the wind"] = (
                f"{self.clock.threshold_speed():.3g} m/s at {self.clock.height:g} m"
            )
        return facts

    def facts(self) -> dict[str, str]:
        """What ground, time, parameters and wind come to on this lattice, for people to read."""
        model = self.new_model()
        return {
            **self.ground.facts(self.lattice),
            **sand_facts(self),
            **recorded_facts(self),
            **self.time_facts(),
            **model.facts(),
            **model.wind_facts(stated_speeds(self)),
        }

    def forecast(self) -> dict[str, str]:
        """What can be predicted of the run before it starts, for people to read."""
        return self.new_model().forecast(self.seeded().forcing())

    def forcing(self) -> Forcing:
        """The wind over this scenario's lattice, with its clock; the scenario must have a seed."""
        return Forcing(self.wind, self._step_clock(), self.lattice.cells, self.influx, self.weather)

    def _step_clock(self) -> StepClock:
        clock, model = self.clock, self.new_model()
        if clock is None:
            return StepClock(self.seed, model.step_seconds, model.strength)
        volume = model.step_volume()
        return StepClock(
            self.seed,
            clock.duration(volume),
            lambda speeds: clock.strength(speeds, volume),
            clock.at_own_height,
        )

    def seeded(self, seed: int | None = None) -> Self:
        """The same scenario with a seed: its own, else this ``seed`` or a random one."""
        if self.run.seed is not None:
            return self
        if seed is None:
            seed = secrets.randbelow(2**32)
        return self.model_copy(update={"run": self.run.model_copy(update={"seed": seed})})

    @property
    def seed(self) -> int:
        """The seed of a scenario that has one."""
        if self.run.seed is None:
            raise ValueError("this scenario has no seed yet; use seeded()")
        return self.run.seed

    def data(self) -> dict[str, Any]:
        """The scenario as plain data, complete, without empty notes."""
        plain: dict[str, Any] = self.model_dump(mode="json")
        return without_empty_notes(plain)

    def text(self) -> str:
        """The scenario as the text of a configuration file."""
        return text_of(self.data())

    def __repr__(self) -> str:
        return f"<Scenario {in_a_line(self)}>"

    __str__ = __repr__

    def _repr_html_(self) -> str:
        return html_table(self.title or "Scenario", summary(self))

    def remarks(self, ground: NDArray[np.float64] | None = None) -> list[str]:
        """Remarks that a user should know before running this; ``ground`` (m) as it was made, if it was."""
        model = self.new_model()
        parts = [part for _, part in self.wind.placed_parts()]
        remarks: list[Iterable[str]] = [self.source_map.notes]
        remarks += [recorded_remarks(self), unmoved(self), falls_too_little(self), unused(self), idle(self)]
        remarks += [starved_edges(self), unmatched_frames(self)]
        remarks += [self.ground.remarks(self.lattice), broken_edges(self, ground)]
        remarks += [model.remarks(part.longest_hop, part.direction) for part in parts]
        remarks += [model.wind_remarks()]
        return list(dict.fromkeys(remark for found in remarks for remark in found))


def text_of(data: Any) -> str:
    """Plain data as the text of a configuration file."""
    import json

    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


def without_empty_notes(data: Any) -> Any:
    """Plain data without the notes that nobody made."""
    if isinstance(data, dict):
        return {k: without_empty_notes(v) for k, v in data.items() if k != "note" or v is not None}
    if isinstance(data, list):
        return [without_empty_notes(item) for item in data]
    return data
