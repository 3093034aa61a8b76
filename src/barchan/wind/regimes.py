"""Winds one after the other: seasons."""

import math
from collections.abc import Iterator
from typing import ClassVar, Literal, Self

from pydantic import Field, model_validator

from barchan.parameters import Parameters, parameter
from barchan.wind.blowing import SPEED, Blowing, speed_in_words
from barchan.wind.changes import Change
from barchan.wind.clock import spoken
from barchan.wind.interval import FOR_EVER, StepClock, WindInterval
from barchan.wind.ramps import AnyRamp, Linear
from barchan.wind.weather import SNOWFALL, TEMPERATURE, Weather
from barchan.wind.weather_course import snowfall_change, temperature_change
from barchan.words import counted

FINENESS = 0.01
"""Change of speed from one slice of a step to the next, over the greater of a regime's speeds."""
MOST_SLICES = 64

_MOMENTS = 8
"""Number of moments of an interval whose speeds are compared to find how much the speed changes."""

_NOTHING = 1e-9
"""Shares of a step below this are rounding."""

_MOST_TOLD = 8
"""Regimes that are told one by one."""


class Regime(Blowing):
    """A wind that blows for a while."""

    direction: float = parameter(
        unit="degrees",
        ge=0,
        lt=360,
        meaning="Where the wind comes from, clockwise from north.",
        source="Prague thesis, §5.3",
    )
    steps: int | None = parameter(
        None,
        unit="steps",
        ge=1,
        le=10**9,
        scale="log",
        meaning="Duration of the regime; give this or seconds.",
        source="Prague thesis, §5.3",
    )
    seconds: float | None = parameter(
        None,
        unit="s",
        gt=0,
        le=1e12,
        scale="log",
        meaning="Duration of the regime, in a scenario with a clock.",
    )
    final_speed: float | None = parameter(
        None,
        meaning="Speed at the end of the regime; by default the first speed.",
        source="Prague thesis, §5.3",
        **SPEED,
    )
    speed_ramp: AnyRamp = Field(
        default_factory=Linear, description="How the speed changes from the first to the last."
    )

    final_temperature: float | None = parameter(
        None,
        meaning="Temperature of the air at the end of the regime; by default the first temperature.",
        source="Prague thesis, §5.12",
        **TEMPERATURE,
    )
    temperature_ramp: AnyRamp = Field(
        default_factory=Linear, description="How the temperature changes from the first to the last."
    )
    final_snowfall: float | None = parameter(
        None,
        meaning="Snowfall at the end of the regime; by default the first snowfall.",
        source="ours",
        **SNOWFALL,
    )
    snowfall_ramp: AnyRamp = Field(
        default_factory=Linear, description="How the snowfall changes from the first to the last."
    )

    @model_validator(mode="after")
    def _lasts_and_starts(self) -> Self:
        if (self.steps is None) == (self.seconds is None):
            given = "neither steps nor seconds is" if self.steps is None else "steps and seconds are both"
            raise ValueError(f"{given} given; give one of them")
        for name in ("speed", "temperature", "snowfall"):
            last = getattr(self, f"final_{name}")
            if last is not None and getattr(self, name) is None:
                raise ValueError(f"final_{name} {last} is given without {name}; give both")
        return self

    def speeds_in_metres(self) -> list[tuple[str, float]]:
        """The first and the last speed, and the highest on the way, where they are stated in m/s."""
        found = super().speeds_in_metres()
        if not found or self.final_speed is None or self.speed is None:
            return found
        rise = self.final_speed - self.speed
        highest = max(self.speed + rise * share for share in self.speed_ramp.extremes())
        ends = [*found, ("final_speed", self.final_speed)]
        return ends if highest <= max(self.speed, self.final_speed) else [*ends, ("speed_ramp", highest)]

    def in_words(self) -> str:
        """Where it comes from, the speed and the variation that it states, and for how long."""
        return f"{super().in_words()} ({self._duration_in_words()})"

    def _speed_in_words(self) -> str:
        if self.speed is None:
            return ""
        return f" {speed_in_words(self.unit, self.speed, self.final_speed)}"

    def _duration_in_words(self) -> str:
        if self.seconds is not None:
            return spoken(self.seconds)
        return counted(self.steps or 0, "step")

    @property
    def longest_hop(self) -> float | None:
        """Longest hop (cells) that the regime states, if any."""
        if self.unit == "m/s":
            return None
        return max(filter(None, (self.speed, self.final_speed)), default=None)

    @property
    def calm(self) -> bool:
        """Whether it is no wind at all, from first to last."""
        return super().calm and not self.changes

    @property
    def lasting_seconds(self) -> float | None:
        """Duration of the regime (s), if stated in seconds."""
        return self.seconds

    def duration(self, clock: StepClock) -> float:
        """Duration of the regime (steps)."""
        if self.seconds is not None:
            return self.seconds / clock.seconds()
        assert self.steps is not None, "the validator saw to it"
        return float(self.steps)

    def speed_at(self, time: float) -> float | None:
        """The mean speed after a share of the regime's duration; not below zero."""
        if self.speed is None or self.final_speed is None:
            return self.speed
        return max(self.speed + (self.final_speed - self.speed) * self.speed_ramp.share(time), 0.0)

    @property
    def changes(self) -> bool:
        """Whether its mean speed changes."""
        return self.final_speed is not None and self.final_speed != self.speed

    def weather_changes(self) -> tuple[Change | None, Change | None]:
        """How temperature and snowfall change during the regime, where they do."""
        temperature = snowfall = None
        if self.temperature is not None and self.final_temperature is not None:
            temperature = temperature_change(self.temperature, self.final_temperature, self.temperature_ramp)
        if self.snowfall is not None and self.final_snowfall is not None:
            snowfall = snowfall_change(self.snowfall, self.final_snowfall, self.snowfall_ramp)
        return temperature, snowfall

    def weather_at(self, over: float, clock: StepClock) -> Weather:
        """The weather after ``over`` steps of the regime."""
        duration = self.duration(clock)
        values = [None if c is None else c.value(over, duration) for c in self.weather_changes()]
        return Weather(*values).completed_by(self.weather)

    @property
    def temperatures(self) -> tuple[float, ...]:
        """The least and the greatest temperature (°C) of the regime, where it states any."""
        change, _ = self.weather_changes()
        return super().temperatures if change is None else change.range()

    def lasts(self, over: float, clock: StepClock) -> int:
        """Number of steps, from ``over`` steps of the regime on, in which wind and weather stay the same."""
        left = self.duration(clock) - over
        if self.varies:
            return 1
        if left <= 0.0:
            return FOR_EVER
        if self.changes:
            return 1
        weather = [c.lasts(over, self.duration(clock)) for c in self.weather_changes() if c is not None]
        return min(max(math.floor(left + _NOTHING), 1), *weather, FOR_EVER)

    def slices(self, start: float, end: float) -> int:
        """Into how many slices the time between two shares of its duration is cut, for its speed changes."""
        if not self.changes or self.speed is None or self.final_speed is None:
            return 1
        speeds = [self.speed_at(start + (end - start) * k / _MOMENTS) or 0.0 for k in range(_MOMENTS + 1)]
        fine = FINENESS * max(self.speed, self.final_speed)
        return min(max(math.ceil((max(speeds) - min(speeds)) / fine), 1), MOST_SLICES)


class Regimes(Parameters):
    """Winds one after the other, over and over or once.

    While a speed changes a step is cut into slices that differ by at most a hundredth of it (at most 64),
    each with the speed in its middle. Once all regimes are over and are not repeated, the last one's wind
    goes on as it ended. A cycle shorter than a step is blown once a step.
    """

    kind_key: ClassVar[str] = "kind"

    kind: Literal["regimes"] = parameter("regimes", unit="-", meaning="Winds one after the other.")
    regimes: list[Regime] = parameter(
        unit="-", min_length=1, max_length=1000, meaning="The winds, in order.", source="Prague thesis, §5.3"
    )
    repeat: bool = parameter(
        True, unit="-", meaning="Whether they start over when all are done.", source="Prague thesis, §5.3"
    )

    def cycle(self, clock: StepClock) -> float:
        """How long all regimes blow together, in steps."""
        return math.fsum(regime.duration(clock) for regime in self.regimes)

    def period(self, step: int, clock: StepClock) -> float:
        """Steps after which the wind comes again: 0 if within a step or all are done, infinite if never."""
        cycle = self.cycle(clock)
        if self.repeat:
            same = len(self.regimes) == 1 and not self.regimes[0].changes
            return 0.0 if same or cycle < 1.0 else cycle
        return 0.0 if step >= cycle else math.inf

    def lasts(self, step: int, clock: StepClock) -> int:
        """Number of steps from ``step`` on in which the wind stays the same."""
        regime, over = self._at(step, clock)
        return regime.lasts(over, clock)

    def intervals(self, step: int, clock: StepClock) -> list[WindInterval]:
        """Intervals of a step, in order."""
        found: list[WindInterval] = []
        for regime, over, start, share in self._pieces(step, clock):
            duration = regime.duration(clock)
            first, last = (min((over + t) / duration, 1.0) for t in (0.0, share))
            count = regime.slices(first, last)
            weather = regime.weather_at(over + share / 2, clock)
            for k in range(count):
                speed = regime.speed_at(first + (last - first) * (k + 0.5) / count)
                at, part = start + share * k / count, share / count
                found.append(regime.interval(step, at, part, speed, clock, weather))
        return found

    def _pieces(self, step: int, clock: StepClock) -> Iterator[tuple[Regime, float, float, float]]:
        """The regimes of a step: how much of each is over, where in the step it starts, and its share."""
        if self.repeat and self.cycle(clock) < 1.0 - _NOTHING:
            scale, start = 1.0 / self.cycle(clock), 0.0
            for regime in self.regimes:
                yield regime, 0.0, start, regime.duration(clock) * scale
                start += regime.duration(clock) * scale
            return
        start = 0.0
        while start < 1.0 - _NOTHING:
            regime, over = self._at(step + start, clock)
            left = regime.duration(clock) - over
            share = 1.0 - start if left <= 0.0 else min(left, 1.0 - start)
            yield regime, over, start, share
            start += share

    def _at(self, time: float, clock: StepClock) -> tuple[Regime, float]:
        """The regime of a time and how much of it is over, both in steps."""
        cycle = self.cycle(clock)
        if not self.repeat and time >= cycle - _NOTHING:
            return self.regimes[-1], self.regimes[-1].duration(clock)
        time = math.fmod(time, cycle)
        for regime in self.regimes:
            if time < regime.duration(clock) - _NOTHING:
                return regime, max(time, 0.0)
            time -= regime.duration(clock)
        return self.regimes[0], 0.0

    def off_axes(self, hexagonal: bool = False) -> bool:
        """Whether any of them ever blows off the axes of a lattice."""
        return any(regime.off_axes(hexagonal) for regime in self.regimes)

    def placed_parts(self) -> list[tuple[tuple[str | int, ...], Blowing]]:
        """The winds that it is made of, and under which keys they stand."""
        return [(("regimes", number), regime) for number, regime in enumerate(self.regimes)]

    def summary(self) -> str:
        """The winds in a few words."""
        winds = ", ".join(regime.in_words() for regime in self.regimes[:_MOST_TOLD])
        more = f" and {len(self.regimes) - _MOST_TOLD} more" if len(self.regimes) > _MOST_TOLD else ""
        return f"from {winds}{more}{' in turn' if self.repeat else ', once'}"
