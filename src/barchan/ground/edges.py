"""Whether the ground goes on over joined edges."""

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice

STEEPER = 3.0
"""Steps across a joined edge may be this multiple of those within the field (root mean squares)."""


def unmatched_edges(ground: NDArray[np.float64], lattice: Lattice) -> list[str]:
    """A remark for each pair of joined edges at which the ground (m) breaks off."""
    periodic_y, periodic_x = lattice.periodic
    pairs = (
        (periodic_x, ground, "west and east", "boundary_x"),
        (periodic_y, ground.T, "south and north", "boundary_y"),
    )
    found = []
    for joined, field, sides, key in pairs:
        jump = np.abs(field[:, 0] - field[:, -1])
        if not joined or field.shape[1] < 3 or jump.max() < lattice.thickness:
            continue
        steps = np.diff(field, axis=1)
        if _root_mean_square(jump) > STEEPER * _root_mean_square(steps):
            found.append(
                f"the {sides} edges are joined, but the ground does not match there: it breaks off by up to "
                f"{jump.max():.3g} m, and sand meets a wall; open {key} of the lattice, or use a ground "
                "whose edges match"
            )
    return found


def _root_mean_square(values: NDArray[np.float64]) -> float:
    return float(np.sqrt(np.mean(values**2)))
