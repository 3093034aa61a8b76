"""How a speed, a temperature or a snowfall changes: fraction of the change by fraction of the time."""

from itertools import pairwise
from typing import Annotated, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from barchan.parameters import Parameters, parameter

_SAMPLES = 64
"""Parts of the duration at whose ends the extremes of a curve are sought."""

_HALVINGS = 60
"""Number of halvings after which an interval vanishes in double precision."""


class Ramp(Parameters):
    """A change in normalised time and value, from (0, 0) to (1, 1)."""

    kind_key: ClassVar[str] = "kind"

    kind: str

    def share(self, time: float) -> float:
        """Fraction of the change that is done after the fraction ``time`` of the duration."""
        raise NotImplementedError

    def extremes(self) -> tuple[float, float]:
        """The least and the greatest fraction of the change on the way."""
        shares = [self.share(k / _SAMPLES) for k in range(_SAMPLES + 1)]
        return min(shares), max(shares)


class Linear(Ramp):
    """A straight line."""

    kind: Literal["linear"] = parameter(
        "linear", unit="-", meaning="Change at a constant rate.", source="Prague thesis, §5.3"
    )

    def share(self, time: float) -> float:
        """The time itself."""
        return time


class Bezier(Ramp):
    """A cubic Bézier curve with two control points."""

    kind: Literal["bezier"] = parameter(
        "bezier",
        unit="-",
        meaning="A cubic Bézier curve with two control points.",
        source="Prague thesis, §5.3",
    )
    time_1: float = parameter(0.33, unit="-", ge=0, le=1, meaning="Time of the first control point.")
    value_1: float = parameter(0.0, unit="-", ge=-10, le=10, meaning="Value of the first control point.")
    time_2: float = parameter(0.67, unit="-", ge=0, le=1, meaning="Time of the second control point.")
    value_2: float = parameter(1.0, unit="-", ge=-10, le=10, meaning="Value of the second control point.")

    def share(self, time: float) -> float:
        """The curve's value where its time is ``time``."""
        low, high = 0.0, 1.0
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            if _cubic(self.time_1, self.time_2, middle) < time:
                low = middle
            else:
                high = middle
        return _cubic(self.value_1, self.value_2, high)


def _cubic(first: float, second: float, u: float) -> float:
    """A coordinate of a cubic Bézier curve from 0 to 1 with two control points."""
    v = 1.0 - u
    return 3 * v * v * u * first + 3 * v * u * u * second + u * u * u


class Point(Parameters):
    """A point of a ramp."""

    time: float = parameter(unit="-", ge=0, le=1, meaning="Fraction of the duration.")
    value: float = parameter(unit="-", ge=-10, le=10, meaning="Fraction of the change.")


class Points(Ramp):
    """Straight lines through several points between the first and the last value."""

    kind: Literal["points"] = parameter("points", unit="-", meaning="Straight lines through points.")
    points: list[Point] = parameter(
        unit="-", min_length=1, max_length=1000, meaning="Points between the first and the last value."
    )

    @model_validator(mode="after")
    def _increases(self) -> Self:
        times = [point.time for point in self.points]
        for number, (before, after) in enumerate(pairwise(times), start=1):
            if after <= before:
                raise ValueError(
                    f"points[{number}].time is {after} after {before}; allowed: times that increase"
                )
        return self

    def share(self, time: float) -> float:
        """The value between the two nearest points."""
        times = [0.0, *(point.time for point in self.points), 1.0]
        values = [0.0, *(point.value for point in self.points), 1.0]
        return float(np.interp(time, times, values))

    def extremes(self) -> tuple[float, float]:
        """The least and the greatest value of its points, ends included."""
        values = [0.0, *(point.value for point in self.points), 1.0]
        return min(values), max(values)


AnyRamp = Annotated[Linear | Bezier | Points, Field(discriminator="kind")]
