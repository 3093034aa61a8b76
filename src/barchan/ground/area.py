"""Rectangles of the field."""

from collections.abc import Sequence
from typing import Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from barchan.lattice import Lattice
from barchan.parameters import Parameters, parameter


class Area(Parameters):
    """A rectangle of the field, its edges given as fractions of the field."""

    west: float = parameter(0.0, unit="-", ge=0, le=1, meaning="West edge.", source="ours")
    east: float = parameter(1.0, unit="-", ge=0, le=1, meaning="East edge.", source="ours")
    south: float = parameter(0.0, unit="-", ge=0, le=1, meaning="South edge.", source="ours")
    north: float = parameter(1.0, unit="-", ge=0, le=1, meaning="North edge.", source="ours")

    @model_validator(mode="after")
    def _has_area(self) -> Self:
        if not (self.west < self.east and self.south < self.north):
            raise ValueError(
                f"a {type(self).__name__.lower()} must have an area: west {self.west} < east {self.east} "
                f"and south {self.south} < north {self.north}"
            )
        return self

    def where(self, lattice: Lattice) -> tuple[slice, slice]:
        """The cells of the rectangle, as slices of rows and columns."""
        rows = slice(round(self.south * lattice.rows), round(self.north * lattice.rows))
        cols = slice(round(self.west * lattice.columns), round(self.east * lattice.columns))
        return rows, cols


def covered(areas: Sequence[Area], lattice: Lattice) -> NDArray[np.bool_]:
    """The cells that any of the rectangles covers."""
    mask = np.zeros(lattice.shape, bool)
    for area in areas:
        mask[area.where(lattice)] = True
    return mask
