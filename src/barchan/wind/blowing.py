"""Direction and speed of a wind and their random variation, shared by steady winds and regimes."""

from typing import Any, Literal, Self

import numpy as np
from pydantic import Field, ValidationError, model_validator

from barchan.parameters import mistake, parameter
from barchan.wind.frame import off_axes
from barchan.wind.gusts import Gusts, normal
from barchan.wind.interval import StepClock, WindInterval
from barchan.wind.weather import Weather, WithWeather

SPEED: dict[str, Any] = {"unit": "cells or m/s", "ge": 0, "le": 100_000}
"""Declaration shared by all speeds."""


FASTEST = 100.0
"""Speed (m/s) that no mean wind over sand or snow exceeds: the fastest gust known was 113 m/s
(World Meteorological Organization 2010)."""


def too_fast(speed: float) -> str:
    """What is wrong with a speed (m/s) above ``FASTEST``."""
    return (
        f"is {speed:g} m/s, faster than any wind; allowed: up to {FASTEST:g} m/s. Is it in another unit: "
        "cm/s, or a hop length (unit cells)?"
    )


def speed_in_words(unit: str, first: float, last: float | None = None) -> str:
    """A speed, or one that changes, in its unit; one in cells is a hop length."""
    change = f"{first:g}" if last in {None, first} else f"{first:g} to {last:g}"
    return f"at {change} m/s" if unit == "m/s" else f"with hops of {change} cells"


class Blowing(WithWeather):
    """A wind with a direction and a speed, which may vary from step to step."""

    direction: float = parameter(
        270.0,
        unit="degrees",
        ge=0,
        lt=360,
        live=True,
        meaning="Where the wind comes from, clockwise from north (270: from the west).",
        source="Prague thesis, Table 6.1",
    )
    speed: float | None = parameter(
        None,
        live=True,
        meaning="Wind speed: as a hop length instead of the model's own, or in m/s; 0 is a calm.",
        source="Prague thesis, §5.3",
        **SPEED,
    )
    unit: Literal["cells", "m/s"] = parameter(
        "cells",
        unit="-",
        meaning="Unit of the speed. In m/s it acts on slabs through the sand that it moves: more or fewer "
        "polls in the same time, by the clock.",
    )
    spread: float = parameter(
        0.0,
        unit="degrees",
        ge=0,
        le=180,
        live=True,
        meaning="Standard deviation of the direction, random in each step.",
        source="Prague thesis, §2.1.3: barchans stand up to 15 degrees",
    )
    gusts: Gusts | None = Field(default=None, description="Gusts of a speed in m/s; none where not given.")

    @model_validator(mode="after")
    def _speed_in_its_unit(self) -> Self:
        if self.unit == "m/s" and self.speed is None:
            raise ValueError("unit is m/s, but no speed is given")
        if self.gusts is not None and self.unit != "m/s":
            raise ValueError("gusts are given, but the speed is not; allowed: gusts of a speed in m/s")
        return self

    @model_validator(mode="after")
    def _not_faster_than_any_wind(self) -> Self:
        found = [
            mistake((key,), too_fast(speed)) for key, speed in self.speeds_in_metres() if speed > FASTEST
        ]
        if found:
            raise ValidationError.from_exception_data(type(self).__name__, found)
        return self

    def speeds_in_metres(self) -> list[tuple[str, float]]:
        """The mean speeds that are stated in m/s, and their keys."""
        return [("speed", self.speed)] if self.unit == "m/s" and self.speed is not None else []

    def in_words(self) -> str:
        """Where it comes from, and the speed and the variation that it states."""
        spread = f" ± {self.spread:g}°" if self.spread else ""
        gusts = " with gusts" if self.gusts is not None and self.gusts.intensity > 0.0 else ""
        return f"{self.direction:g}°{spread}{self._speed_in_words()}{gusts}"

    def _speed_in_words(self) -> str:
        return "" if self.speed is None else f" {speed_in_words(self.unit, self.speed)}"

    @property
    def longest_hop(self) -> float | None:
        """Longest hop (cells) that the wind states, if any."""
        return None if self.unit == "m/s" else self.speed

    @property
    def lasting_seconds(self) -> float | None:
        """Duration of the wind (s), if stated in seconds."""
        return None

    @property
    def calm(self) -> bool:
        """Whether it is no wind at all."""
        return self.speed == 0.0

    def off_axes(self, hexagonal: bool = False) -> bool:
        """Whether it ever blows off the axes of a lattice, at random or on the whole."""
        return not self.calm and (self.spread > 0.0 or off_axes(self.direction, hexagonal))

    @property
    def varies(self) -> bool:
        """Whether direction or speed vary at random from step to step."""
        return self.spread > 0.0 or (self.gusts is not None and self.gusts.intensity > 0.0)

    def interval(
        self,
        step: int,
        start: float,
        share: float,
        speed: float | None,
        clock: StepClock,
        weather: Weather | None = None,
    ) -> WindInterval:
        """The wind for a share of a step, from a share ``start`` of it on, at a mean speed.

        Its weather is the one that it states, unless one is given.
        """
        weather = self.weather if weather is None else weather
        direction = self.direction
        if self.spread > 0.0 and clock.deviates:
            direction = (direction + self.spread * normal(clock.directions, step)) % 360.0
        if speed is None or self.unit == "cells":
            strength = 0.0 if speed == 0.0 else 1.0
            return WindInterval(share, direction, speed or None, strength=strength, weather=weather)
        speeds = np.array([speed])
        if self.gusts is not None:
            seconds = clock.seconds()
            speeds = speed * self.gusts.factors((step + start) * seconds, share * seconds, clock.gusts)
        mean = float(speeds.mean())
        return WindInterval(
            share,
            direction,
            None,
            mean,
            clock.mean_strength(speeds),
            weather,
            clock.driving_speed(speeds),
        )
