"""Grains that may have landed: they bounce, splash, come to rest or leave, and free slots entrain others."""

import numpy as np

from barchan.kernels.bed.active_layer import class_at, set_class
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal, woven
from barchan.kernels.core.random import derive
from barchan.kernels.grains.bonds import restitution_at
from barchan.kernels.grains.bounce import bounce
from barchan.kernels.grains.entrainment import entrain
from barchan.kernels.grains.exchange import MIDDLE
from barchan.kernels.grains.pool import record_end
from barchan.kernels.grains.splash import rebound
from barchan.kernels.grains.state import FLYING, GONE, LOSS_UNIT, NOWHERE
from barchan.kernels.grains.surface import height_at, nearest_cell, surface_at

_ZERO = np.float32(0.0)

_FARTHEST = np.float32(2.0**30)
"""Distance (cells) in a time step beyond which laps round a field are not counted: the grain is gone."""


@internal(error_model="numpy", forceinline=True)
def _over_edge(slot, place, wraps, size, wrap, grains):
    """Bring a coordinate that left the field in again from the other side, or take the grain out.

    A time step may carry a grain over more than one width of a narrow field.
    """
    end = np.float32(size)
    p = place[slot]
    if p >= _ZERO and p < end:
        return
    if not wrap or not abs(p) < _FARTHEST:
        grains.status[slot] = GONE
        return
    laps = np.int64(np.floor(np.float64(p) / size))
    p -= np.float32(laps * size)
    wraps[slot] += np.int32(laps)
    if p >= end:  # a tiny negative number, rounded
        p -= end
        wraps[slot] += 1
    place[slot] = p


@internal(error_model="numpy", forceinline=True)
def _inside(x, y, grid):
    return x >= _ZERO and x < np.float32(grid.cols) and y >= _ZERO and y < np.float32(grid.rows)


@internal(error_model="numpy")
def _come_in(slot, grains, grid):
    """Bring a grain in over the edges it crossed, or take it out."""
    _over_edge(slot, grains.x, grains.wraps_x, grid.cols, grid.wrap_along, grains)
    _over_edge(slot, grains.y, grains.wraps_y, grid.rows, grid.wrap_across, grains)


@internal(error_model="numpy", forceinline=True)
def _restitution(splash, x, y, ground):
    """Restitution of rebounds where a grain hits the bed: snow is bonded where it cannot fill a footprint."""
    least = 1 if ground.scale.carried == 1 else MIDDLE
    return restitution_at(ground.bonds, nearest_cell(x, y, ground.grid), least, splash.restitution)


@woven(error_model="numpy")
def _splash(k, slot, start, place, grains, air, ground, splash, most, landings):
    """Rebound a grain or leave it where it is, and write the impact into entry ``k``."""
    x, y, surface, east, north = place
    u, v = grains.u[slot], grains.v[slot]
    landings.x[k], landings.y[k], landings.u[k], landings.v[k] = x, y, u, v
    landings.start[k] = start
    set_class(landings.size_class, k, class_at(grains.size_class, slot))
    restitution = _restitution(splash, x, y, ground)
    landings.impact_speed[k] = rebound(slot, start, (surface, east, north), grains, splash, restitution, most)
    if grains.status[slot] == FLYING:
        u, v = u - grains.u[slot], v - grains.v[slot]
    loss = np.float64(u) * air.wind_x + np.float64(v) * air.wind_y
    landings.momentum_loss[k] = np.int64(np.rint(loss * LOSS_UNIT))


@internal(error_model="numpy", forceinline=True)
def _hit(k, slot, key, place, grains, air, ground, splash, bounce_rule, landings):
    """Let a grain bounce or splash; whether that is an impact to be written into entry ``k``.

    ``place`` is where the grain hit the bed (cells), and the surface there: height (m) and slopes.
    """
    if splash is None:
        bounce(slot, place[2], place[3], place[4], grains, bounce_rule)
        return False
    _splash(k, slot, derive(key, slot), place, grains, air, ground, splash, bounce_rule.most, landings)
    return True


@internal(error_model="numpy")
def land(first, count, key, grains, air, ground, rules, landings):
    """Handle the ``count`` slots in ``landings.candidates`` from ``first`` on.

    Grains that hit the bed bounce or, with a splash, rebound. Slots that were free, or whose grain came to
    rest or left the field, may entrain a grain from elsewhere. Each gets an entry of ``landings``, from
    ``first`` on; returns the number of entries. The bed is only read: ``exchange`` changes it. So slots may
    be shared among threads.
    """
    grains, air, ground, rules, landings = borrowed((grains, air, ground, rules, landings))
    grid = ground.grid
    found = first
    for k in range(first, first + count):
        slot = landings.candidates[k]
        hits = False
        if grains.status[slot] == FLYING and not _inside(grains.x[slot], grains.y[slot], grid):
            _come_in(slot, grains, grid)
        if grains.status[slot] == FLYING:
            x, y = grains.x[slot], grains.y[slot]
            if grains.z[slot] >= height_at(x, y, ground):
                continue
            surface, east, north = surface_at(x, y, ground)
            place = x, y, surface, east, north
            hits = _hit(found, slot, key, place, grains, air, ground, rules.splash, rules.bounce, landings)
        if grains.status[slot] != FLYING:
            if not hits:
                landings.impact_speed[found] = 0.0
            record_end(found, slot, rules.bounce.most, grains, grid, landings)
            landings.lift_cell[found] = entrain(slot, derive(key, slot), grains, ground, rules.entrainment)
            found += 1
        elif hits:
            landings.slot[found] = landings.deposit_cell[found] = landings.lift_cell[found] = NOWHERE
            found += 1
    return found - first
