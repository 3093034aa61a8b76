"""The weather of a whole run, whatever wind blows: temperature and snowfall over a stated time."""

from typing import Self

from pydantic import Field, model_validator

from barchan.parameters import Parameters, parameter
from barchan.wind.changes import Change
from barchan.wind.interval import FOR_EVER, StepClock
from barchan.wind.ramps import AnyRamp, Linear
from barchan.wind.weather import SNOWFALL, TEMPERATURE, Weather

TEMPERATURE_FINENESS = 0.1
"""Change of temperature (K) from one piece of a run to the next."""

SNOWFALL_FINENESS = 0.02
"""Change of snowfall from one piece of a run to the next, over the greater of its two rates."""


def temperature_change(first: float, last: float, ramp: AnyRamp) -> Change:
    """A temperature that changes (°C)."""
    return Change(first, last, ramp, TEMPERATURE_FINENESS)


def snowfall_change(first: float, last: float, ramp: AnyRamp) -> Change:
    """A snowfall that changes (kg/m²/s)."""
    return Change(first, last, ramp, SNOWFALL_FINENESS * max(first, last))


class Course(Parameters):
    """A quantity of the weather from the run's start on: constant, or changing over a stated time."""

    first: float
    last: float | None
    steps: int | None = parameter(
        None,
        unit="steps",
        ge=1,
        le=10**9,
        scale="log",
        meaning="Steps from the run's start in which it changes; afterwards it stays as it ended. Give this "
        "or seconds.",
    )
    seconds: float | None = parameter(
        None,
        unit="s",
        gt=0,
        le=1e12,
        scale="log",
        meaning="Time in which it changes, where steps have a duration.",
    )
    ramp: AnyRamp = Field(
        default_factory=Linear, description="How it changes from the first value to the last."
    )

    @model_validator(mode="after")
    def _lasts_where_it_changes(self) -> Self:
        given = [name for name in ("steps", "seconds") if getattr(self, name) is not None]
        if self.last is None and given:
            raise ValueError(f"{given[0]} is given without last; give both, or neither where it is constant")
        if self.last is not None and len(given) != 1:
            found = "neither steps nor seconds is" if not given else "steps and seconds are both"
            raise ValueError(f"last is given, and {found} given; give one of them")
        return self

    @property
    def change(self) -> Change:
        """How it changes; a constant to itself."""
        raise NotImplementedError

    def value(self, step: int, clock: StepClock) -> float:
        """The value in the middle of a step."""
        return self.first if self.last is None else self.change.value(step + 0.5, self._duration(clock))

    def lasts(self, step: int, clock: StepClock) -> int:
        """Number of steps from ``step`` on in which it stays the same."""
        return FOR_EVER if self.last is None else self.change.lasts(step, self._duration(clock))

    def _duration(self, clock: StepClock) -> float:
        """Time in which it changes (steps)."""
        if self.seconds is not None:
            return self.seconds / clock.seconds()
        assert self.steps is not None, "the validator saw to it"
        return float(self.steps)


class TemperatureCourse(Course):
    """The temperature of the air during a run."""

    first: float = parameter(
        meaning="Temperature of the air at the start.",
        source="Prague thesis, §5.12 and Fig. 5.6",
        **TEMPERATURE,
    )
    last: float | None = parameter(
        None,
        meaning="Temperature of the air at the end of the change; constant where not given.",
        source="Prague thesis, §5.12 and Fig. 5.6",
        **TEMPERATURE,
    )

    @property
    def change(self) -> Change:
        """How the temperature changes."""
        return temperature_change(self.first, self.first if self.last is None else self.last, self.ramp)


class SnowfallCourse(Course):
    """The snow that falls during a run."""

    first: float = parameter(
        meaning="Snow that falls at the start: mass per area and time.", source="ours", **SNOWFALL
    )
    last: float | None = parameter(
        None,
        meaning="Snowfall at the end of the change; constant where not given.",
        source="ours",
        **SNOWFALL,
    )

    @property
    def change(self) -> Change:
        """How the snowfall changes."""
        return snowfall_change(self.first, self.first if self.last is None else self.last, self.ramp)


class WeatherCourse(Parameters):
    """The weather of a run, whatever wind blows; what a wind states itself counts more."""

    temperature: TemperatureCourse | None = Field(
        default=None, description="Temperature of the air; unknown where not given."
    )
    snowfall: SnowfallCourse | None = Field(
        default=None, description="Snow that falls on the ground; unknown where not given."
    )

    def at(self, step: int, clock: StepClock) -> Weather:
        """The weather in the middle of a step."""
        values = [None if part is None else part.value(step, clock) for part in self.parts()]
        return Weather(*values)

    def lasts(self, step: int, clock: StepClock) -> int:
        """Number of steps from ``step`` on in which the weather stays the same."""
        return min((part.lasts(step, clock) for part in self.parts() if part is not None), default=FOR_EVER)

    def parts(self) -> tuple[TemperatureCourse | None, SnowfallCourse | None]:
        """Temperature and snowfall."""
        return self.temperature, self.snowfall
