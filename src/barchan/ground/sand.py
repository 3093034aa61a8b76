"""The sand that lies on the ground at the start."""

from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import AfterValidator, Field, model_validator

from barchan.bed import Lattice
from barchan.parameters import Parameters, parameter
from barchan.streams import Stream, below, high, low

MOST_SLABS = 1_000_000


class Part(Parameters):
    """A rectangle of the field with a mean of its own, its edges given as fractions of the field."""

    mean: float = parameter(unit="slabs", ge=0, le=MOST_SLABS, meaning="Mean sand in this part.")
    west: float = parameter(0.0, unit="-", ge=0, le=1, meaning="West edge.")
    east: float = parameter(1.0, unit="-", ge=0, le=1, meaning="East edge.")
    south: float = parameter(0.0, unit="-", ge=0, le=1, meaning="South edge.")
    north: float = parameter(1.0, unit="-", ge=0, le=1, meaning="North edge.")

    @model_validator(mode="after")
    def _has_area(self) -> Self:
        if not (self.west < self.east and self.south < self.north):
            raise ValueError(
                f"a part must have an area: west {self.west} < east {self.east} "
                f"and south {self.south} < north {self.north}"
            )
        return self

    def where(self, lattice: Lattice) -> tuple[slice, slice]:
        """The cells of the part, as slices of rows and columns."""
        rows = slice(round(self.south * lattice.rows), round(self.north * lattice.rows))
        cols = slice(round(self.west * lattice.columns), round(self.east * lattice.columns))
        return rows, cols


def _parts() -> Any:
    return parameter(
        list,
        unit="-",
        max_length=100,
        meaning="Rectangles with another mean; later ones lie over earlier ones.",
        source="seed 004, moderate sand in one part and low elsewhere",
    )


def _whole(parts: list[Part]) -> list[Part]:
    for number, part in enumerate(parts):
        if part.mean != round(part.mean):
            raise ValueError(f"parts[{number}].mean is {part.mean}; allowed here: whole numbers of slabs")
    return parts


WholeParts = Annotated[list[Part], AfterValidator(_whole)]


class FlatSand(Parameters):
    """The same number of slabs on every cell."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["flat"] = parameter("flat", unit="-", meaning="The same number of slabs on every cell.")
    mean: int = parameter(
        3,
        unit="slabs",
        ge=0,
        le=MOST_SLABS,
        scale="log",
        meaning="Slabs on a cell.",
        source="seed 000, Table 6.1",
    )
    parts: WholeParts = _parts()

    def slabs(self, lattice: Lattice, _stream: Stream) -> NDArray[np.int32]:
        """Slabs on each cell."""
        return _stacks(self.mean, self.parts, lattice)


class RandomSand(Parameters):
    """The same number of slabs on every cell, give or take one."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["random"] = parameter("random", unit="-", meaning="A number of slabs, give or take one.")
    mean: int = parameter(
        3,
        unit="slabs",
        ge=0,
        le=MOST_SLABS,
        scale="log",
        meaning="Slabs on a cell before one is added, taken away or neither.",
        source="seed 000, §6.5.2",
    )
    parts: WholeParts = _parts()

    def slabs(self, lattice: Lattice, stream: Stream) -> NDArray[np.int32]:
        """Slabs on each cell."""
        change = below(high(stream.draws(0, lattice.cells)), 3) - 1
        stacks = _stacks(self.mean, self.parts, lattice)
        return np.maximum(stacks + change.reshape(lattice.shape), 0).astype(np.int32)


class DroppedSand(Parameters):
    """Slabs dropped on cells drawn at random."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["dropped"] = parameter("dropped", unit="-", meaning="Slabs dropped on random cells.")
    mean: float = parameter(
        3.0,
        unit="slabs",
        ge=0,
        le=MOST_SLABS,
        scale="log",
        meaning="Mean number of slabs on a cell.",
        source="seed 004",
    )
    parts: list[Part] = _parts()

    def slabs(self, lattice: Lattice, stream: Stream) -> NDArray[np.int32]:
        """Slabs on each cell; their total is the mean times the cells, rounded, in each part."""
        whole = Part(mean=self.mean)
        stacks = np.zeros(lattice.shape, np.int32)
        for number, part in enumerate([whole, *self.parts]):
            view = stacks[part.where(lattice)]
            view[...] = 0
            rows, cols = view.shape
            draws = stream.draws(number, round(part.mean * view.size))
            cell = below(low(draws), rows) * cols + below(high(draws), cols)
            view += np.bincount(cell, minlength=view.size).reshape(rows, cols).astype(np.int32)
        return stacks


def _stacks(mean: int, parts: list[Part], lattice: Lattice) -> NDArray[np.int32]:
    stacks = np.full(lattice.shape, mean, np.int32)
    for part in parts:
        stacks[part.where(lattice)] = round(part.mean)
    return stacks


Sand = Annotated[FlatSand | RandomSand | DroppedSand, Field(discriminator="kind")]
