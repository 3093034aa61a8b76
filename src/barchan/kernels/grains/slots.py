"""Slots of grains: freed, started from, and read out when a flight ends."""

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import kind_of, set_kind
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.grains.state import FLYING, FREE, GONE, NOWHERE, OUT, SUNK
from barchan.kernels.grains.surface import nearest_cell

_ZERO = np.float32(0.0)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def free_slot(slot, grains):
    """Take the grain out of a slot; the slot stays below the ground until it is used again."""
    grains.held[slot] = FREE
    grains.x[slot] = grains.y[slot] = _ZERO
    grains.z[slot] = SUNK
    grains.u[slot] = grains.v[slot] = grains.w[slot] = _ZERO


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def launch(slot, x, y, z, u, v, w, grains):
    """Let a grain start from a slot at a place (cells, m) with a velocity (m/s)."""
    grains.x[slot] = grains.from_x[slot] = x
    grains.y[slot] = grains.from_y[slot] = y
    grains.z[slot] = z
    grains.u[slot] = u
    grains.v[slot] = v
    grains.w[slot] = w
    grains.laps_x[slot] = grains.laps_y[slot] = 0
    grains.bounces[slot] = 0
    grains.held[slot] = FLYING


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _way(there, start, laps, size):
    way = np.float64(there) - np.float64(start) + np.float64(laps) * size
    return np.int64(np.rint(way * TRAVEL_UNIT))


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def record_end(k, slot, most, grains, grid, events):
    """Put into entry ``k`` how the flight of a slot ended, if there was one, and free the slot."""
    events.slot[k] = slot
    events.source[k] = events.rest[k] = NOWHERE
    events.capped[k] = False
    set_kind(events.kind, k, kind_of(grains.kind, slot))
    if grains.held[slot] != FREE:
        gone = grains.held[slot] == GONE
        events.rest[k] = OUT if gone else nearest_cell(grains.x[slot], grains.y[slot], grid)
        events.capped[k] = grains.bounces[slot] >= most and not gone
        events.way_x[k] = _way(grains.x[slot], grains.from_x[slot], grains.laps_x[slot], grid.cols)
        events.way_y[k] = _way(grains.y[slot], grains.from_y[slot], grains.laps_y[slot], grid.rows)
    free_slot(slot, grains)
