"""An oblique wind as a mixture of two winds along the lattice's axes."""

from typing import ClassVar, Literal, Self

from pydantic import model_validator

from barchan.directions import bearing, downwind
from barchan.parameters import Parameters, parameter
from barchan.wind.blowing import Blowing, speed_in_words
from barchan.wind.interval import FOR_EVER, StepClock, WindInterval
from barchan.wind.steady import Steady


class MixedAxes(Parameters):
    """A wind that blows a share of each step along one axis of the lattice, the rest along another.

    Nield and Baas's way to an oblique wind. A third along one and two thirds along the other come to an
    angle of 63.4 degrees between the first and the mean transport; they call it 60. Slabs still hop along
    the axes, which is not the same as an oblique hop: compare a steady wind from ``nominal_direction``.
    """

    kind_key: ClassVar[str] = "kind"

    kind: Literal["mixed_axes"] = parameter(
        "mixed_axes", unit="-", meaning="Polls shared between two axes of the lattice."
    )
    first: Literal[0, 90, 180, 270] = parameter(
        270, unit="degrees", meaning="Where the first wind comes from.", source="Nield & Baas 2008"
    )
    second: Literal[0, 90, 180, 270] = parameter(
        180, unit="degrees", meaning="Where the second wind comes from.", source="Nield & Baas 2008"
    )
    share: float = parameter(
        1 / 3,
        unit="-",
        gt=0,
        lt=1,
        meaning="Share of the polls under the first wind.",
        source="Nield & Baas 2008: a third and two thirds",
    )
    alternations: int = parameter(
        8, unit="-", ge=1, le=64, meaning="Number of times within a step that each of the two winds blows."
    )
    speed: float | None = parameter(
        None,
        unit="cells",
        gt=0,
        le=100_000,
        meaning="Wind speed as a hop length, instead of the model's own.",
    )

    @model_validator(mode="after")
    def _crosses(self) -> Self:
        if (self.first - self.second) % 180 == 0:
            raise ValueError(
                f"second is {self.second} where first is {self.first}; allowed: {(self.first + 90) % 360} or "
                f"{(self.first + 270) % 360}, at a right angle to it"
            )
        return self

    @property
    def nominal_direction(self) -> float:
        """Where the mean transport comes from (degrees)."""
        (x, y), (across_x, across_y) = downwind(self.first), downwind(self.second)
        rest = 1.0 - self.share
        return bearing(self.share * x + rest * across_x, self.share * y + rest * across_y)

    def lasts(self, _step: int, _clock: StepClock) -> int:
        """Number of steps from ``step`` on in which the wind stays the same."""
        return FOR_EVER

    def intervals(self, _step: int, _clock: StepClock) -> list[WindInterval]:
        """Intervals of a step, in order."""
        shares = self.share, 1.0 - self.share
        axes = self.first, self.second
        return [
            WindInterval(share / self.alternations, float(axis), self.speed)
            for _ in range(self.alternations)
            for axis, share in zip(axes, shares, strict=True)
        ]

    def period(self, _step: int, _clock: StepClock) -> float:
        """Steps after which the wind comes again: 0, as every step is the same."""
        return 0.0

    def off_axes(self, hexagonal: bool = False) -> bool:
        """Whether it ever blows off the axes of a lattice: on hexagons, which have none at right angles."""
        return hexagonal

    def placed_parts(self) -> list[tuple[tuple[str | int, ...], Blowing]]:
        """The winds of both axes, with their keys."""
        axes = self.first, self.second
        return [((), Steady(direction=float(axis), speed=self.speed)) for axis in axes]

    def summary(self) -> str:
        """The wind in a few words."""
        speed = "" if self.speed is None else f" {speed_in_words('cells', self.speed)}"
        return (
            f"{self.share:.3g} from {self.first}° and {1 - self.share:.3g} from {self.second}° "
            f"(on the whole {self.nominal_direction:.1f}°){speed}"
        )
