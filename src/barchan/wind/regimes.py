"""Winds one after the other: seasons."""

from collections.abc import Iterator
from typing import Any, ClassVar, Literal, Self

from pydantic import Field, model_validator

from barchan.parameters import Parameters, parameter
from barchan.wind.courses import AnyCourse, Linear
from barchan.wind.segment import Segment

_SPEED: dict[str, Any] = {"unit": "cells", "gt": 0, "le": 100_000, "source": "seed 000, §5.3"}


class Regime(Parameters):
    """A wind that blows for a while."""

    direction: float = parameter(
        unit="degrees",
        ge=0,
        lt=360,
        meaning="Where the wind comes from, clockwise from north.",
        source="seed 000, §5.3",
    )
    steps: int = parameter(
        unit="steps", ge=1, le=10**9, scale="log", meaning="How long it blows.", source="seed 000, §5.3"
    )
    speed: float | None = parameter(
        None, meaning="Speed at its beginning, as a hop length, instead of the model's own.", **_SPEED
    )
    final_speed: float | None = parameter(
        None, meaning="Speed at its end; the first speed where it is not given.", **_SPEED
    )
    course: AnyCourse = Field(
        default_factory=Linear, description="How the speed goes from the first to the last."
    )

    @model_validator(mode="after")
    def _starts_somewhere(self) -> Self:
        if self.final_speed is not None and self.speed is None:
            raise ValueError(f"final_speed {self.final_speed} is given without speed; give both")
        return self

    def hop_length(self, time: float) -> float | None:
        """The speed (cells) after a share of the regime's duration; not below zero."""
        if self.speed is None or self.final_speed is None:
            return self.speed
        return max(self.speed + (self.final_speed - self.speed) * self.course.share(time), 0.0)

    @property
    def changes(self) -> bool:
        """Whether the speed changes."""
        return self.final_speed is not None and self.final_speed != self.speed


class Regimes(Parameters):
    """Winds one after the other, over and over or once.

    A speed that changes is taken in the middle of each step. Once all regimes are over and are not
    repeated, the last one's wind goes on as it ended.
    """

    kind_key: ClassVar[str] = "kind"

    kind: Literal["regimes"] = parameter("regimes", unit="-", meaning="Winds one after the other.")
    regimes: list[Regime] = parameter(
        unit="-", min_length=1, max_length=1000, meaning="The winds, in order.", source="seed 000, §5.3"
    )
    repeat: bool = parameter(
        True, unit="-", meaning="Whether they start over when all are done.", source="seed 000, §5.3"
    )

    @property
    def cycle(self) -> int:
        """Steps of all regimes together."""
        return sum(regime.steps for regime in self.regimes)

    def _at(self, step: int) -> tuple[Regime, int]:
        """The regime of a step and how many of its steps are over."""
        if not self.repeat and step >= self.cycle:
            return self.regimes[-1], self.regimes[-1].steps
        step %= self.cycle
        for regime in self.regimes:
            if step < regime.steps:
                return regime, step
            step -= regime.steps
        raise AssertionError("a step of the cycle lies in one of its regimes")

    def direction_at(self, step: int) -> float:
        """Where the wind of a step comes from (degrees)."""
        return self._at(step)[0].direction

    def speeds(self) -> list[tuple[float | None, float]]:
        """The greatest speed (cells; None: the model's own) and the direction of each regime."""
        return [
            (max(filter(None, (regime.speed, regime.final_speed)), default=None), regime.direction)
            for regime in self.regimes
        ]

    def summary(self) -> str:
        """The winds in a few words."""
        directions = ", ".join(f"{regime.direction:g}°" for regime in self.regimes[:8])
        more = f" and {len(self.regimes) - 8} more" if len(self.regimes) > 8 else ""
        return f"from {directions}{more} in turn"

    def segments(self, step: int, steps: int, cells: int) -> Iterator[Segment]:
        """The forcing of ``steps`` steps from ``step`` on, over a lattice of ``cells`` cells."""
        end = step + steps
        while step < end:
            regime, over = self._at(step)
            left = regime.steps - over if over < regime.steps else end - step
            count = 1 if regime.changes and over < regime.steps else min(left, end - step)
            time = min((over + 0.5) / regime.steps, 1.0) if over < regime.steps else 1.0
            hop = regime.hop_length(time)
            polls = 0 if hop == 0.0 else cells
            yield Segment(step, count, 0, polls, regime.direction, hop or regime.speed)
            step += count
