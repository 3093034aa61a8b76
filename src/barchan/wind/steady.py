"""A wind that keeps its mean."""

from typing import ClassVar, Literal

from barchan.parameters import parameter
from barchan.wind.blowing import Blowing
from barchan.wind.interval import FOR_EVER, StepClock, WindInterval


class Steady(Blowing):
    """A steady wind from one direction."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["steady"] = parameter("steady", unit="-", meaning="A wind that keeps its mean.")

    def lasts(self, _step: int, _clock: StepClock) -> int:
        """Number of steps from ``step`` on in which the wind stays the same."""
        return 1 if self.varies else FOR_EVER

    def intervals(self, step: int, clock: StepClock) -> list[WindInterval]:
        """Intervals of a step, in order."""
        return [self.interval(step, 0.0, 1.0, self.speed, clock)]

    def period(self, _step: int, _clock: StepClock) -> float:
        """Steps after which the wind comes again: 0, as it stays the same but for its random variation."""
        return 0.0

    def placed_parts(self) -> list[tuple[tuple[str | int, ...], Blowing]]:
        """The winds that it is made of, and under which keys they stand."""
        return [((), self)]

    def summary(self) -> str:
        """The wind in a few words."""
        return f"from {self.in_words()}"
