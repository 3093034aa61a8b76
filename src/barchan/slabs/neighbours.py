"""The order in which a cell's neighbours are checked under a wind."""

import math

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.bed.state import BARRED, DOWNSLOPE, SIXFOLD, UPSLOPE, neighbour_code
from barchan.lattice import HEX_ROWS, Lattice
from barchan.slabs.parameters import SlabParameters

Groups = tuple[dict[int, tuple[float, float]], ...]
"""Steps (across, along) to neighbours by the kernels' direction, group by group: faces before corners."""

_FACES = ((0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0))
_CORNERS = ((1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0))
_HEXAGON = ((0.0, 1.0), (HEX_ROWS, 0.5), (HEX_ROWS, -0.5), (0.0, -1.0), (-HEX_ROWS, -0.5), (-HEX_ROWS, 0.5))


def neighbour_groups(parameters: SlabParameters, lattice: Lattice) -> Groups:
    """The neighbours of a cell: four faces, four faces and four corners, or the six of a hexagon."""
    if lattice.hexagonal:
        return (dict(zip(SIXFOLD, _HEXAGON, strict=True)),)
    faces, corners = dict(enumerate(_FACES)), dict(enumerate(_CORNERS, start=4))
    return (faces, corners) if parameters.neighbourhood == "moore" else (faces,)


def order_table(angle: float, groups: Groups, upwind: bool) -> NDArray[np.int64]:
    """Codes of the neighbours, in the order in which a wind at ``angle`` has them checked.

    A slab slides down to the downwind side first and slides in from the upwind side first, faces before
    corners; of two neighbours at the same angle to the wind the one on its left comes first. Without
    ``upwind`` nothing slides against the wind.
    """
    orders = np.full((3, 8), BARRED, np.int64)
    for row, sign in ((DOWNSLOPE, 1), (UPSLOPE, -1)):
        place = 0
        for group in groups:
            sides = []
            for direction, (across, along) in group.items():
                downwind = along * math.cos(angle) + across * math.sin(angle)
                left = across * math.cos(angle) - along * math.sin(angle)
                sides.append((-round(sign * downwind, 9), -round(left, 9), direction))
            for against, _, direction in sorted(sides, key=lambda side: side[:2]):
                if upwind or against < 1e-9:
                    orders[row, direction] = neighbour_code(direction, place)
                place += 1
    return orders
