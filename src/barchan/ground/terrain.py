"""The base of all kinds of ground."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice
from barchan.parameters import Parameters
from barchan.streams import Stream

HIGHEST = 1e5
"""Farthest that ground may lie above or below zero (m)."""

TALLEST = 1e4
"""Height of the tallest landform (m)."""


@dataclass(frozen=True)
class Georeference:
    """Where on Earth a field lies."""

    west: float
    """Easting of the field's west edge (m)."""
    south: float
    """Northing of its south edge (m)."""
    crs: str | None = None
    """Coordinate reference system, by its code where it has one; None where the terrain states none."""
    wkt: str | None = None
    """The same as well-known text."""


class Terrain(Parameters):
    """A shape of the non-erodible ground."""

    kind_key: ClassVar[str] = "kind"
    standing: ClassVar[str] = ""
    """What stands on the cells that ``bare`` gives, for pictures: ``rock``, ``stem`` or nothing."""

    def elevation(self, lattice: Lattice, stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice; random numbers come from ``stream``."""
        raise NotImplementedError

    def bare(self, lattice: Lattice) -> NDArray[np.bool_]:
        """The cells that start without sand."""
        return np.zeros(lattice.shape, bool)

    def georeference(self) -> Georeference | None:
        """Where on Earth the field lies, where that is known."""
        return None

    def facts(self, _lattice: Lattice) -> dict[str, str]:
        """How the ground was made to fit the lattice, where that is not obvious, for people to read."""
        return {}

    def remarks(self, _lattice: Lattice) -> list[str]:
        """Remarks that a user should know before running this."""
        return []
