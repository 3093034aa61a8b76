"""Snow whose grains bond: how many parcels of each cell are still loose, by the time since they came to rest.

What comes to rest is loose and of the youngest age. What leaves is of the youngest age that there is, then of
the next one, and bonded last. None in place of the loose parcels is sand, which never bonds.
"""

import numpy as np
from numba import njit

from barchan.kernels.bed.state import AGES
from barchan.kernels.core.internal import internal


@internal(error_model="numpy")
def loose_at(loose, cell):
    """Loose parcels of a cell."""
    total = np.int64(0)
    for age in range(AGES):
        total += loose[cell, age]
    return total


@internal(error_model="numpy")
def take_loose(loose, cell, parcels):
    """Take parcels from the youngest age on; more than there are take all, for the rest is bonded."""
    for age in range(AGES):
        given = min(parcels, np.int64(loose[cell, age]))
        loose[cell, age] -= given
        parcels -= given


@njit(cache=True, nogil=True, error_model="numpy")
def change_loose(loose, cell, parcels):
    """Note parcels that came to rest on a cell, or that left it (negative)."""
    if loose is not None:
        if parcels > 0:
            loose[cell, 0] += parcels
        else:
            take_loose(loose, cell, -np.int64(parcels))


@njit(cache=True, nogil=True, error_model="numpy")
def slide_loose(loose, cell, other, parcels):
    """Note parcels that slid from one cell to another, where they are of the youngest age."""
    if loose is not None:
        take_loose(loose, cell, parcels)
        loose[other, 0] += parcels


@njit(cache=True, nogil=True, error_model="numpy")
def part_loose(loose, sand):
    """The parcels by cell that may slide; those that have bonded stay alone in ``sand`` until ``join``."""
    if loose is None:
        return sand
    free = np.empty(sand.size, np.int32)
    for cell in range(sand.size):
        free[cell] = loose_at(loose, cell)
        sand[cell] -= free[cell]
    return free


@njit(cache=True, nogil=True, error_model="numpy")
def join(loose, free, sand):
    """Bring loose parcels that ``part_loose`` took apart together with the bonded ones again."""
    if loose is not None:
        for cell in range(sand.size):
            sand[cell] += free[cell]


@njit(cache=True, nogil=True, error_model="numpy")
def follow(loose, bonded, sand):
    """Bring loose parcels up to date with snow that was laid or taken by a brush, as by the wind."""
    for cell in range(sand.size):
        change_loose(loose, cell, np.int64(sand[cell]) - bonded[cell] - loose_at(loose, cell))
