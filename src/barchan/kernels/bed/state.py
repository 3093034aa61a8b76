"""Lattice, stacks and slope rules as kernels take them. Nothing here imports the compiler."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Grid(NamedTuple):
    """The lattice as a kernel sees it, in the wind's frame."""

    rows: int
    cols: int
    wrap_along: bool
    """Whether leaving downwind means entering upwind (periodic along the wind)."""
    wrap_across: bool
    hexagonal: bool = False
    """Whether cells are hexagons: odd rows lie half a cell farther along, and rows √3/2 cells apart."""


LEVEL_BITS = 20
"""Binary places of the heights (slabs) that hops are measured against."""


MEAN, DEVIATION = range(2)
"""Places in ``Levels.values``: the surface's mean, and the sum over all cells of their distance from it."""


class Levels(NamedTuple):
    """Mean height and relief of the whole surface, as they were when a round of polls began."""

    values: NDArray[np.int64]
    """``MEAN`` and ``DEVIATION``, in 2**-``LEVEL_BITS`` slabs."""
    shift: int
    """Binary places from units of the surface to those of the levels."""


def new_levels(shift: int) -> Levels:
    """Levels that are not measured yet."""
    return Levels(np.zeros(2, np.int64), shift)


class Stacks(NamedTuple):
    """The stacks of slabs (or parcels) on all cells, flat, in the wind's frame; changed in place."""

    surface: NDArray[np.integer]
    """Height of each stack, ground included, in whole units."""
    sand: NDArray[np.int32] | None
    """Slabs of sand on each cell; None over flat ground, where the surface counts slabs."""
    mobility: NDArray[np.int32] | None = None
    """How freely the wind works on each cell, in 1/``MOBILE``; None: everywhere unhindered."""
    levels: Levels | None = None
    """Measured where hops depend on height."""
    loose: NDArray[np.int32] | None = None
    """Loose parcels by cell and age, of which alone ``sand`` counts those that slide; None: nothing bonds."""


AGES = 4
"""Ages that loose parcels of what bonds are told apart by."""


class Unstable(NamedTuple):
    """Work space of avalanches: the cells whose slopes have still to be checked."""

    queue: NDArray[np.int64]
    """Ring of cells, with room for all of them."""
    waiting: NDArray[np.uint8]
    """Why a cell is in the queue; 0: it is not. All zero before and after an avalanche."""


def unstable_cells(cells: int) -> Unstable:
    """Work space for avalanches on a lattice with ``cells`` cells, empty."""
    return Unstable(np.zeros(cells, np.int64), np.zeros(cells, np.uint8))


class ActiveLayer(NamedTuple):
    """Sand of several sizes: parcels by size class and cell, in the active layer and in the substrate."""

    surface: np.ndarray
    """Parcels in the active layer (int32, size class by cell)."""
    substrate: np.ndarray
    """Parcels below the active layer."""
    capacity: int
    """Parcels that the active layer of a cell holds."""
    rng_state: np.ndarray
    """State of the sequence of random numbers (one uint64)."""


EAST, NORTH, WEST, SOUTH, NORTHEAST, NORTHWEST, SOUTHWEST, SOUTHEAST = range(8)
"""Neighbours in the wind's frame, as seen with the wind blowing east."""


SIXFOLD = (EAST, NORTHEAST, NORTHWEST, WEST, SOUTHWEST, SOUTHEAST)
"""The neighbours of a hexagon, anticlockwise."""


STABLE = -1
"""In place of a direction: every slope of the cell stands."""


BARRED = -(1 << 62)
"""Code of a neighbour to which sand may not slide: it sorts below every other."""


DOWNSLOPE, UPSLOPE, SHUFFLED = map(np.int64, range(3))
"""Rows of a table of neighbour orders: for a slab that slides down, for one that slides in from above, and
room for a random order of either. Kernels get them as numbers of one type: for whole numbers of Python the
compiler would translate a kernel once for each value."""


UP, DOWN = np.int64(1), np.int64(-1)
"""Signs of steps up and down a slope."""


AT_REST, SLIDING = np.bool_(True), np.bool_(False)
"""Whether the static limit holds for sand, or that of sand that slides."""


class Repose(NamedTuple):
    """Which slopes stand; heights in the surface's units."""

    slab: int
    face_limit: int
    """Largest stable step to one of the four neighbours that share a face."""
    corner_limit: int
    corner_weight: float
    """Weight of a step to a corner neighbour when the steepest step is chosen (a step to a face has 1)."""
    corners: bool
    """Whether the four corner neighbours count at all (Moore) or not (von Neumann)."""
    random_order: bool
    """Whether equally steep neighbours are checked in a random order, drawn each time."""
    downslope: bool
    """Whether a slab on a step that does not stand slides to a neighbour drawn in proportion to the steps."""
    stabilised_face_limit: int
    """Largest stable step to a face neighbour where plants hold the sand."""
    stabilised_corner_limit: int
    stabilised_below: int
    """Mobility up to which a cell is stabilised."""
    static_face: int
    """How far a step of sand at rest may exceed ``face_limit`` before the sand slides."""
    static_corner: int


def repose_rule(
    slab: int,
    limits: tuple[int, int],
    *,
    corners: bool = True,
    corner_weight: float = math.sqrt(0.5),
    random_order: bool = False,
    downslope: bool = False,
    stabilised: tuple[int, int] | None = None,
    stabilised_below: int = -1,
    static: tuple[int, int] | None = None,
) -> Repose:
    """Slope limits from whole slabs: each pair holds the limits towards faces and corners.

    Without ``stabilised`` limits no cell is stabilised, without ``static`` limits sand at rest slides at the
    same steps as moving sand.
    """
    stabilised, static = stabilised or limits, static or limits
    return Repose(
        slab=slab,
        face_limit=limits[0] * slab,
        corner_limit=limits[1] * slab,
        corner_weight=corner_weight,
        corners=corners,
        random_order=random_order,
        downslope=downslope,
        stabilised_face_limit=stabilised[0] * slab,
        stabilised_corner_limit=stabilised[1] * slab,
        stabilised_below=stabilised_below,
        static_face=(static[0] - limits[0]) * slab,
        static_corner=(static[1] - limits[1]) * slab,
    )


def neighbour_code(direction: int, place: int) -> int:
    """Code of the neighbour that is checked at ``place`` (0 to 7): earlier ones sort higher."""
    return (7 - place) << 3 | direction


def relaxation_orders(corners: bool, hexagonal: bool = False) -> NDArray[np.int64]:
    """Orders of neighbours: from each of four directions (of a hexagon six), clockwise and back."""
    if hexagonal:
        return _sixfold_orders()
    orders = np.full((8, 8), BARRED, np.int64)
    for order in range(8):
        for place in range(4):
            direction = (order + (place if order < 4 else -place)) % 4
            orders[order, direction] = neighbour_code(direction, place)
            if corners:
                orders[order, 4 + direction] = neighbour_code(4 + direction, 4 + place)
    return orders


def _sixfold_orders() -> NDArray[np.int64]:
    orders = np.full((12, 8), BARRED, np.int64)
    for order in range(12):
        for place in range(6):
            direction = SIXFOLD[(order + (place if order < 6 else -place)) % 6]
            orders[order, direction] = neighbour_code(direction, place)
    return orders
