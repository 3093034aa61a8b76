"""Grains that may have landed: they bounce, splash, come to rest or leave, and free slots start anew."""

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import kind_of, set_kind
from barchan.kernels.core.borrow import lent
from barchan.kernels.core.random import derive
from barchan.kernels.grains.bounce import bounce
from barchan.kernels.grains.entrainment import lift
from barchan.kernels.grains.flight import move
from barchan.kernels.grains.slots import record_end
from barchan.kernels.grains.splash import rebound
from barchan.kernels.grains.state import FLYING, GONE, LOST_UNIT, NOWHERE
from barchan.kernels.grains.surface import height_at, surface_at

_ZERO = np.float32(0.0)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _over_edge(slot, place, laps, size, wrap, grains):
    """Bring a coordinate that left the field in again from the other side, or take the grain out."""
    end = np.float32(size)
    p = place[slot]
    if wrap:
        if p < _ZERO:
            p += end
            laps[slot] -= 1
        if p >= end:
            p -= end
            laps[slot] += 1
    elif p < _ZERO or p >= end:
        grains.held[slot] = GONE
    place[slot] = p


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _inside(x, y, grid):
    return x >= _ZERO and x < np.float32(grid.cols) and y >= _ZERO and y < np.float32(grid.rows)


@njit(cache=True, nogil=True, error_model="numpy")
def _come_in(slot, grains, grid):
    """Bring a grain in over the edges it crossed, or take it out."""
    _over_edge(slot, grains.x, grains.laps_x, grid.cols, grid.wrap_along, grains)
    _over_edge(slot, grains.y, grains.laps_y, grid.rows, grid.wrap_across, grains)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _splash(k, slot, start, x, y, surface, east, north, grains, air, rule, events):
    """Let a grain rebound or stay, and put what the impact was like into entry ``k``."""
    u, v = grains.u[slot], grains.v[slot]
    events.x[k], events.y[k], events.u[k], events.v[k] = x, y, u, v
    events.start[k] = start
    set_kind(events.kind, k, kind_of(grains.kind, slot))
    events.impact[k] = rebound(slot, start, surface, east, north, grains, rule)
    if grains.held[slot] == FLYING:
        u, v = u - grains.u[slot], v - grains.v[slot]
    lost = np.float64(u) * air.wind_x + np.float64(v) * air.wind_y
    events.lost[k] = np.int64(np.rint(lost * LOST_UNIT))


@njit(cache=True, nogil=True, error_model="numpy")
def land(first, count, key, grains, air, grid, ground, scale, rules, splash, events):
    """Look after the ``count`` slots in ``events.near`` from ``first`` on.

    ``rules`` are those of bounces and of lift-off; with ``splash`` grains rebound by that instead. Slots that
    were free, or whose grain came to rest or left the field, may start anew from elsewhere. Each gets an
    entry of ``events``, from ``first`` on; returns how many. The bed is only read: what becomes of it is for
    ``exchange``. So slots may be shared among threads.
    """
    grains, air, ground, rules, events = lent((grains, air, ground, rules, events))
    bounce_rule, lift_rule = rules
    found = first
    for k in range(first, first + count):
        slot = events.near[k]
        hits = False
        if grains.held[slot] == FLYING and not _inside(grains.x[slot], grains.y[slot], grid):
            _come_in(slot, grains, grid)
        if grains.held[slot] == FLYING:
            x, y = grains.x[slot], grains.y[slot]
            if grains.z[slot] >= height_at(x, y, ground.height, grid):
                continue
            surface, east, north = surface_at(x, y, ground.height, scale.cell_size, grid)
            if splash is None:
                bounce(slot, surface, east, north, grains, bounce_rule)
            else:
                hits = True
                start = derive(key, slot)
                _splash(found, slot, start, x, y, surface, east, north, grains, air, splash, events)
        if grains.held[slot] != FLYING:
            if not hits:
                events.impact[found] = 0.0
            record_end(found, slot, bounce_rule.most, grains, grid, events)
            events.source[found] = lift(slot, derive(key, slot), grains, ground, scale, grid, lift_rule)
            found += 1
        elif hits:
            events.slot[found] = events.rest[found] = events.source[found] = NOWHERE
            found += 1
    return found - first


@njit(cache=True, nogil=True, error_model="numpy")
def fly(first, last, key, grains, air, grid, ground, scale, rules, splash, events):
    """Both at once: let slots fly for one time step, then look after those that may have landed."""
    count = move(first, last, grains, air, grid, ground, events.near)
    return land(first, count, key, grains, air, grid, ground, scale, rules, splash, events)
