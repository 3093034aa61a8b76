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

    def segments(self, step: int, steps: int, cells: int) -> Iterator[Segment]:
        """The forcing of ``steps`` steps from ``step`` on, over a lattice of ``cells`` cells."""
        yield Segment(step, steps, 0, cells, self.direction, self.speed)
