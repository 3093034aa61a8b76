"""Slabs that an oblique wind carries far from the band of their poll: they land when the round ends."""

import numpy as np

from barchan.kernels.core.atomics import add
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.slabs.state import NO_SLAB


@internal(forceinline=True)
def address_of(before, surface):
    """Address of the surface as it was, or (None) of the surface."""
    if before is None:
        return surface
    return before.ctypes.data


@internal()
def put_aside(flights, band, slab):
    """Keep a slab of a band (position, hop, random state, hops) in mid-flight; whether there was room."""
    never_inline()
    if flights is None:
        return True
    place = add(flights.used, 0, 1)
    if place >= flights.slabs.shape[0]:
        return False
    flights.slabs[place, 0] = NO_SLAB
    for k in range(6):
        flights.slabs[place, 1 + k] = np.int64(slab[k])
    if flights.first[band] == NO_SLAB:
        flights.first[band] = place
    else:
        flights.slabs[flights.last[band], 0] = place
    flights.last[band] = place
    return True


@internal()
def forget_flights(flights):
    """Make room for the slabs of another round."""
    if flights is not None:
        flights.first[:] = NO_SLAB
        flights.used[0] = 0
