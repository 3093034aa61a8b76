"""Rocks and hills that stand in the wind's way."""

from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.ground.area import Area, covered
from barchan.ground.noise import hills
from barchan.ground.places import LONGEST, SHORTEST
from barchan.ground.terrain import TALLEST, Terrain
from barchan.lattice import Lattice
from barchan.parameters import parameter
from barchan.streams import Stream


class Rock(Area):
    """A rectangle that rock stands on."""


def _three() -> list[Rock]:
    """Three rocks; the places are ours, the Prague thesis shows them only in pictures."""
    return [
        Rock(west=0.25, east=0.33, south=0.62, north=0.80),
        Rock(west=0.45, east=0.53, south=0.30, north=0.48),
        Rock(west=0.70, east=0.78, south=0.55, north=0.73),
    ]


class ThreeRocks(Terrain):
    """Rectangular rocks of one height on level ground, bare at the start; three unless stated."""

    standing: ClassVar[str] = "rock"
    kind: Literal["three_rocks"] = parameter(
        "three_rocks", unit="-", meaning="Rectangular rocks on level ground, without sand at the start."
    )
    height: float = parameter(
        10.0,
        unit="m",
        ge=0,
        le=TALLEST,
        meaning="Height of the rocks.",
        source="Prague thesis, §5.10; the number is ours",
    )
    rocks: list[Rock] = parameter(
        _three,
        unit="-",
        max_length=100,
        meaning="Where the rocks stand.",
        source="Prague thesis, §5.10; the places are ours, the text has none",
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        return np.where(self.bare(lattice), self.height, 0.0)

    def bare(self, lattice: Lattice) -> NDArray[np.bool_]:
        """The cells of the rocks."""
        return covered(self.rocks, lattice)


class UnevenGround(Terrain):
    """Smooth random hills, other ones for each seed."""

    kind: Literal["uneven"] = parameter("uneven", unit="-", meaning="Smooth random hills.")
    height: float = parameter(
        8.0,
        unit="m",
        ge=0,
        le=TALLEST,
        meaning="From the lowest hollow to the highest top.",
        source="Prague thesis, §5.10; the number is ours",
    )
    size: float = parameter(
        15.0,
        unit="m",
        ge=SHORTEST,
        le=LONGEST,
        scale="log",
        meaning="Standard deviation of the Gaussian that smooths the hills; tops lie about six of it apart.",
        source="Prague thesis, §5.10; the number is ours",
    )

    def elevation(self, lattice: Lattice, stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        return self.height * hills(lattice, stream, self.size)
