"""Upright cylinders in the wind's way: stems, posts, tufts of plants."""

from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.ground.places import LONGEST, SHORTEST, distances
from barchan.ground.terrain import TALLEST, Terrain
from barchan.lattice import Lattice
from barchan.parameters import Parameters, parameter
from barchan.streams import Stream


class Cylinder(Parameters):
    """Where a cylinder stands, and its size."""

    x: float = parameter(
        0.3, unit="-", ge=0, le=1, meaning="Where its axis is, as a fraction of the field from the west."
    )
    y: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where its axis is, as a fraction of the field from the south."
    )
    radius: float = parameter(
        5.0,
        unit="m",
        ge=SHORTEST,
        le=LONGEST,
        scale="log",
        meaning="Distance from the axis to the wall; a cylinder covers one cell at least.",
    )
    height: float = parameter(10.0, unit="m", ge=0, le=TALLEST, meaning="Height of the top.")


def _one() -> list[Cylinder]:
    return [Cylinder()]


class Cylinders(Terrain):
    """Upright cylinders on level ground, bare at the start; where two overlap the higher one stands."""

    standing: ClassVar[str] = "stem"
    kind: Literal["cylinders"] = parameter(
        "cylinders", unit="-", meaning="Upright cylinders on level ground, without sand at the start."
    )
    cylinders: list[Cylinder] = parameter(
        _one,
        unit="-",
        max_length=100,
        meaning="Where they stand, and their sizes.",
        source="Prague thesis, §3.5 and Fig. 3.8: plants as cylinders; places and sizes are ours",
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        ground = np.zeros(lattice.shape)
        for cylinder in self.cylinders:
            inside = _covered(cylinder, lattice)
            ground[inside] = np.maximum(ground[inside], cylinder.height)
        return ground

    def bare(self, lattice: Lattice) -> NDArray[np.bool_]:
        """The cells of the cylinders."""
        mask = np.zeros(lattice.shape, bool)
        for cylinder in self.cylinders:
            mask |= _covered(cylinder, lattice)
        return mask


def _covered(cylinder: Cylinder, lattice: Lattice) -> NDArray[np.bool_]:
    """The cells whose centres lie inside, and the one nearest to the axis."""
    away = distances(lattice, cylinder.x, cylinder.y)
    return (away < cylinder.radius) | (np.arange(away.size).reshape(away.shape) == away.argmin())
