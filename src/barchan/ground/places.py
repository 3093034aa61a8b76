"""Where cells lie, seen from a place on the lattice."""

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice

SHORTEST, LONGEST = 1e-4, 1e7
"""Lengths (m) that shapes may have along the ground."""


def extent(lattice: Lattice) -> tuple[float, float]:
    """Length of the field from west to east and from south to north (m)."""
    return lattice.width, lattice.height


def shares(lattice: Lattice) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Distances of the cells' centres from the west and the south edge, as fractions of the field.

    They broadcast to the lattice. In a shifted row the last centre may lie on the east edge.
    """
    x, y = (np.arange(count) + 0.5 for count in (lattice.columns, lattice.rows))
    shift = lattice.shift[:, None] / lattice.width
    return x[None, :] / lattice.columns + shift, y[:, None] / lattice.rows


def offsets(lattice: Lattice, x: float, y: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """How far (m) the cells' centres lie east and north of a place, the short way over joined edges.

    ``x`` and ``y`` are fractions of the field. The two broadcast to the lattice.
    """
    width, height = extent(lattice)
    centres = lattice.x[None, :] + lattice.shift[:, None] if lattice.hexagonal else lattice.x[None, :]
    east = _short(centres - x * width, width, lattice.boundary_x == "periodic")
    north = _short(lattice.y - y * height, height, lattice.boundary_y == "periodic")
    return east, north[:, None]


def distances(lattice: Lattice, x: float, y: float) -> NDArray[np.float64]:
    """Distance (m) of the cells' centres from a place given in fractions of the field."""
    return np.hypot(*offsets(lattice, x, y))


def _short(offset: NDArray[np.float64], length: float, joined: bool) -> NDArray[np.float64]:
    return offset - length * np.rint(offset / length) if joined else offset
