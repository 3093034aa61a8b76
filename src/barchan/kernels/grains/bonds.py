"""What bonds between grains of snow withstand. None in place of bonds is sand: all of it is loose."""

import numpy as np

from barchan.kernels.bed.loose import change_loose, loose_at
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import draw


@internal(error_model="numpy", forceinline=True)
def note_change(bonds, cell, parcels):
    """Note parcels that came to rest on a cell, or that left it (negative)."""
    if bonds is not None:
        change_loose(bonds.loose, cell, parcels)


@internal(error_model="numpy", forceinline=True)
def loose_of(bonds):
    """Loose parcels by cell and age; None where nothing bonds."""
    if bonds is None:
        return None
    return bonds.loose


@internal(error_model="numpy", forceinline=True)
def movable(bonds, sand, cell, breaks):
    """Parcels of a cell that can leave it: all if what takes them ``breaks`` bonds, or the loose ones."""
    if bonds is None:
        return np.int64(sand[cell])
    return np.int64(sand[cell]) if breaks else loose_at(bonds.loose, cell)


@internal(error_model="numpy", forceinline=True)
def wind_breaks(bonds):
    """Whether the wind lifts bonded parcels too."""
    if bonds is None:
        return True
    return bonds.yields


@internal(error_model="numpy", forceinline=True)
def impact_breaks(bonds, start, number):
    """Whether what an impact sets in motion may be a bonded parcel, by draw ``number`` of the impact."""
    if bonds is None:
        return True
    return draw(start, number) < bonds.hardness


@internal(error_model="numpy", forceinline=True)
def restitution_at(bonds, cell, least, restitution):
    """Restitution of rebounds off a cell; it is bonded where fewer than ``least`` parcels are loose."""
    if bonds is None:
        return restitution
    return bonds.restitution if loose_at(bonds.loose, cell) < least else restitution
