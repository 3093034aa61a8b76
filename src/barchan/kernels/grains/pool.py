"""Slots of the pool of grains: freed, launched from, and read out when a flight ends."""

import numpy as np

from barchan.kernels.bed.active_layer import class_at, set_class
from barchan.kernels.core.internal import internal
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.grains.state import FLYING, FREE, GONE, NOWHERE, OUT, SUNK
from barchan.kernels.grains.surface import nearest_cell

_ZERO = np.float32(0.0)


@internal(error_model="numpy", forceinline=True)
def free_slot(slot, grains):
    """Take the grain out of a slot; the slot stays below the ground until it is used again."""
    grains.status[slot] = FREE
    grains.x[slot] = grains.y[slot] = _ZERO
    grains.z[slot] = SUNK
    grains.u[slot] = grains.v[slot] = grains.w[slot] = _ZERO


@internal(error_model="numpy", forceinline=True)
def launch(slot, x, y, z, velocity, grains):
    """Start a grain in a slot from a place (cells, m) with a velocity (m/s)."""
    grains.x[slot] = grains.from_x[slot] = x
    grains.y[slot] = grains.from_y[slot] = y
    grains.z[slot] = z
    grains.u[slot], grains.v[slot], grains.w[slot] = velocity
    grains.wraps_x[slot] = grains.wraps_y[slot] = 0
    grains.bounces[slot] = 0
    grains.status[slot] = FLYING


@internal(error_model="numpy", forceinline=True)
def _travel(there, start, wraps, size):
    travel = np.float64(there) - np.float64(start) + np.float64(wraps) * size
    return np.int64(np.rint(travel * TRAVEL_UNIT))


@internal(error_model="numpy", forceinline=True)
def record_end(k, slot, most, grains, grid, landings):
    """Write the end of the flight of a slot, if there was one, into entry ``k``, and free the slot."""
    landings.slot[k] = slot
    landings.lift_cell[k] = landings.deposit_cell[k] = NOWHERE
    landings.capped[k] = False
    set_class(landings.size_class, k, class_at(grains.size_class, slot))
    if grains.status[slot] != FREE:
        gone = grains.status[slot] == GONE
        landings.deposit_cell[k] = OUT if gone else nearest_cell(grains.x[slot], grains.y[slot], grid)
        landings.capped[k] = grains.bounces[slot] >= most and not gone
        x, y, wraps_x, wraps_y = grains.x[slot], grains.y[slot], grains.wraps_x[slot], grains.wraps_y[slot]
        landings.travel_x[k] = _travel(x, grains.from_x[slot], wraps_x, grid.cols)
        landings.travel_y[k] = _travel(y, grains.from_y[slot], wraps_y, grid.rows)
    free_slot(slot, grains)
