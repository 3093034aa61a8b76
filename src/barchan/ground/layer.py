"""The base of all kinds of initial sand: an even or uneven layer, counted in whole slabs."""

from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import AfterValidator

from barchan.ground.area import Area
from barchan.ground.places import shares
from barchan.lattice import Lattice
from barchan.parameters import Parameters, parameter
from barchan.streams import Stream

MOST_SLABS = 1_000_000


class Part(Area):
    """A rectangle of the field with a mean of its own, its edges given as fractions of the field."""

    mean: float = parameter(unit="slabs", ge=0, le=MOST_SLABS, meaning="Mean sand in this part.")


def mean_of(default: float, meaning: str, source: str = "") -> Any:
    """The mean sand of a layer."""
    return parameter(default, unit="slabs", ge=0, le=MOST_SLABS, scale="log", meaning=meaning, source=source)


def _whole(parts: list[Part]) -> list[Part]:
    for number, part in enumerate(parts):
        if part.mean != round(part.mean):
            raise ValueError(f"parts[{number}].mean is {part.mean}; allowed here: whole numbers of slabs")
    return parts


def parts_of() -> Any:
    """The parts of a layer that have a mean of their own."""
    return parameter(
        list,
        unit="-",
        max_length=100,
        meaning="Rectangles with another mean; later ones lie over earlier ones.",
        source="Elder 2009, moderate sand in one part and low elsewhere",
    )


WholeParts = Annotated[list[Part], AfterValidator(_whole)]


class Layer(Parameters):
    """Sand of a mean depth, more on one side than on the other if wanted, and a shape on top of it."""

    kind_key: ClassVar[str] = "kind"

    kind: str
    mean: float = mean_of(3.0, "Mean sand on a cell; depths are rounded to whole slabs.")
    parts: list[Part] = parts_of()
    gradient_x: float = parameter(
        0.0,
        unit="-",
        ge=-1,
        le=1,
        meaning="Sand rises evenly from west to east: at the east edge so much more than the mean, as a "
        "share of it, and less at the west edge. Parts keep their own mean.",
    )
    gradient_y: float = parameter(
        0.0,
        unit="-",
        ge=-1,
        le=1,
        meaning="Sand rises evenly from south to north: at the north edge so much more than the mean, as a "
        "share of it, and less at the south edge. Parts keep their own mean.",
    )

    def slabs(self, lattice: Lattice, _ground: NDArray[np.float64], stream: Stream) -> NDArray[np.int64]:
        """Slabs on each cell; random numbers come from ``stream``."""
        return whole(self.depth(lattice) + self.relief(lattice, stream) / lattice.thickness)

    def depth(self, lattice: Lattice) -> NDArray[np.float64]:
        """Depth of the layer (slabs)."""
        x, y = shares(lattice)
        stacks = self.mean * _rise(self.gradient_y, y) * _rise(self.gradient_x, x)
        for part in self.parts:
            stacks[part.where(lattice)] = part.mean
        return stacks

    def relief(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Height (m) of the shape on the layer, below zero where the layer is thinner."""
        return np.zeros(lattice.shape)


def whole(depth: NDArray[np.float64]) -> NDArray[np.int64]:
    """Depths as whole numbers of slabs, none below zero."""
    return np.rint(np.maximum(depth, 0.0)).astype(np.int64)


def _rise(gradient: float, share: NDArray[np.float64]) -> NDArray[np.float64]:
    return 1.0 + gradient * (2.0 * share - 1.0)
