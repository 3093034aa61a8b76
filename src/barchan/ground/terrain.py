"""The base of all kinds of ground."""

from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice
from barchan.parameters import Parameters
from barchan.streams import Stream

HIGHEST = 1e5
"""Farthest that ground may lie above or below zero (m)."""

TALLEST = 1e4
"""Height of the tallest landform (m)."""


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

    def georeference(self) -> dict[str, Any]:
        """Where on Earth the field lies: ``crs`` and the south-west corner, where that is known."""
        return {}
