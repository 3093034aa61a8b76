"""A wind that never changes."""

from collections.abc import Iterator
from typing import ClassVar, Literal

from barchan.parameters import Parameters, parameter
from barchan.wind.segment import Segment


class Steady(Parameters):
    """A steady wind from one direction."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["steady"] = parameter("steady", unit="-", meaning="A wind that never changes.")
    direction: float = parameter(
        270.0,
        unit="degrees",
        ge=0,
        lt=360,
        live=True,
        meaning="Where the wind comes from, clockwise from north (270: from the west).",
        source="seed 000, Table 6.1",
    )
    speed: float | None = parameter(
        None,
        unit="cells",
        gt=0,
        le=100_000,
        live=True,
        meaning="Wind speed as a hop length, instead of the model's own.",
        source="seed 000, §5.3",
    )
    unit: Literal["cells"] = parameter("cells", unit="-", meaning="Unit of the speed.")

    def direction_at(self, _step: int) -> float:
        """Where the wind of a step comes from (degrees)."""
        return self.direction

    def speeds(self) -> list[tuple[float | None, float]]:
        """The speed (cells; None: the model's own) and the direction."""
        return [(self.speed, self.direction)]

    def summary(self) -> str:
        """The wind in a few words."""
        return f"from {self.direction:g}°"

    def segments(self, step: int, steps: int, cells: int) -> Iterator[Segment]:
        """The forcing of ``steps`` steps from ``step`` on, over a lattice of ``cells`` cells."""
        yield Segment(step, steps, 0, cells, self.direction, self.speed)
