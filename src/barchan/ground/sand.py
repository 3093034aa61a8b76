"""The sand that lies on the ground at the start: every kind there is."""

from typing import Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.ground.fitting import FromFile
from barchan.ground.heaps import Block, Cone, Mound, Patch
from barchan.ground.layer import MOST_SLABS, Layer, Part, WholeParts, mean_of, parts_of, whole
from barchan.ground.noise import hills
from barchan.ground.places import LONGEST, SHORTEST
from barchan.ground.terrain import HIGHEST
from barchan.ground.waves import RippledSand, TransverseSand
from barchan.lattice import Lattice
from barchan.parameters import Parameters, parameter
from barchan.streams import Stream, below, high, low

__all__ = ["MOST_SLABS", "Part", "Sand"]


class FlatSand(Layer):
    """The same number of slabs on every cell."""

    kind: Literal["flat"] = parameter("flat", unit="-", meaning="The same number of slabs on every cell.")
    mean: int = mean_of(3, "Slabs on a cell.", "Prague thesis, Table 6.1")
    parts: WholeParts = parts_of()


class RandomSand(Layer):
    """The same number of slabs on every cell, give or take one."""

    kind: Literal["random"] = parameter("random", unit="-", meaning="A number of slabs, give or take one.")
    mean: int = mean_of(
        3, "Slabs on a cell before one is added, taken away or neither.", "Prague thesis, §6.5.2"
    )
    parts: WholeParts = parts_of()

    def slabs(self, lattice: Lattice, _ground: NDArray[np.float64], stream: Stream) -> NDArray[np.int64]:
        """Slabs on each cell."""
        change = below(high(stream.draws(0, lattice.cells)), 3) - 1
        return np.maximum(whole(self.depth(lattice)) + change.reshape(lattice.shape), 0)


class DroppedSand(Layer):
    """Slabs dropped on random cells."""

    kind: Literal["dropped"] = parameter("dropped", unit="-", meaning="Slabs dropped on random cells.")
    mean: float = mean_of(3.0, "Mean number of slabs on a cell.", "Elder 2009")

    def slabs(self, lattice: Lattice, _ground: NDArray[np.float64], stream: Stream) -> NDArray[np.int64]:
        """Slabs on each cell; their total is the mean times the cells, rounded, in each part."""
        stacks = np.zeros(lattice.shape, np.int64)
        layers = [(Part(mean=self.mean), self.gradient_x, self.gradient_y)]
        layers += [(part, 0.0, 0.0) for part in self.parts]
        for number, (part, gradient_x, gradient_y) in enumerate(layers):
            view = stacks[part.where(lattice)]
            rows, cols = view.shape
            draws = stream.draws(number, round(part.mean * view.size))
            row = below(_leaning(low(draws), gradient_y), rows)
            col = below(_leaning(high(draws), gradient_x), cols)
            view[...] = np.bincount(row * cols + col, minlength=view.size).reshape(rows, cols)
        return stacks


class NoisySand(Layer):
    """Smooth random hills of sand."""

    kind: Literal["noise"] = parameter("noise", unit="-", meaning="Smooth random hills of sand.")
    mean: float = mean_of(10.0, "Mean sand on a cell; depths are rounded to whole slabs.")
    height: float = parameter(
        4.0, unit="m", ge=0, le=1e4, meaning="From the lowest hollow to the highest top."
    )
    size: float = parameter(
        10.0,
        unit="m",
        ge=SHORTEST,
        le=LONGEST,
        scale="log",
        meaning="Standard deviation of the Gaussian that smooths the hills; tops lie about six of it apart.",
    )

    def relief(self, lattice: Lattice, stream: Stream) -> NDArray[np.float64]:
        """Height (m) over the layer."""
        shape = hills(lattice, stream, self.size)
        return self.height * (shape - shape.mean())


class LevelSand(Parameters):
    """Sand that fills the ground up to one elevation."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["level"] = parameter("level", unit="-", meaning="The ground is filled up to a level.")
    level: float = parameter(
        1.0,
        unit="m",
        ge=-HIGHEST,
        le=HIGHEST,
        meaning="Elevation that the sand reaches; higher ground is bare.",
    )

    def slabs(self, lattice: Lattice, ground: NDArray[np.float64], _stream: Stream) -> NDArray[np.int64]:
        """Slabs on each cell, so that the surface is as near to the level as whole slabs allow."""
        return whole((self.level - ground) / lattice.thickness)


class FileSand(FromFile):
    """Sand from an image or an array."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["file"] = parameter("file", unit="-", meaning="Depths of sand from a file.")
    unit: Literal["slabs", "m"] = parameter(
        "slabs", unit="-", meaning="Unit of the file's depths; they are rounded to whole slabs."
    )
    lowest: float | None = parameter(
        None, unit="slabs or m", ge=0, le=MOST_SLABS, meaning="Depth that black means, in an image."
    )
    highest: float | None = parameter(
        None, unit="slabs or m", ge=0, le=MOST_SLABS, meaning="Depth that white means, in an image."
    )

    def slabs(self, lattice: Lattice, _ground: NDArray[np.float64], _stream: Stream) -> NDArray[np.int64]:
        """Slabs on each cell."""
        thickness = lattice.thickness if self.unit == "m" else 1.0
        return whole(self.heights(lattice, "sand", 0.0, MOST_SLABS * thickness) / thickness)


def _leaning(half: NDArray[np.uint64], gradient: float) -> NDArray[np.uint64]:
    """32 even random bits turned into ones that favour high values, as a slope of this gradient does.

    The inverse of the slope's distribution, written so that no gradient leaves every bit as it was.
    """
    even = (half.astype(np.float64) + 0.5) / 2.0**32
    root = np.sqrt((1.0 - gradient) ** 2 + 4.0 * gradient * even)
    leaning = np.floor(2.0 * even / (1.0 - gradient + root) * 2.0**32)
    return np.minimum(leaning, 2.0**32 - 1.0).astype(np.uint64)


Sand = Annotated[
    FlatSand
    | RandomSand
    | DroppedSand
    | RippledSand
    | TransverseSand
    | Cone
    | Block
    | Mound
    | Patch
    | NoisySand
    | LevelSand
    | FileSand,
    Field(discriminator="kind"),
]
