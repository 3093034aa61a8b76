"""Splash: a grain that hits the bed rebounds or stays, and throws others out of it.

Rebound with a probability that grows with speed, rebound speed in proportion to it, and a number of low, slow
ejecta in proportion to it too (Anderson & Haff 1991; Kok & Renno 2009). Of sand of several sizes each throws
out parcels of each. Impacts also push grains along the bed (``grain_creep``).
"""

import math

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import amount, kind_of, set_kind
from barchan.kernels.core.borrow import lent
from barchan.kernels.core.random import draw
from barchan.kernels.grains.creep import push
from barchan.kernels.grains.exchange import take_up
from barchan.kernels.grains.slots import launch
from barchan.kernels.grains.state import FREE, LANDED, LOST, MOVED
from barchan.kernels.grains.surface import nearest_cell, surface_at

MOST_EJECTA = 8
"""Ejecta of one impact at most."""

REBOUND_DRAWS, EJECTA_DRAWS, DRAWS_PER_EJECTUM, KIND_DRAWS = 10, 20, 3, 60
"""Where in a slot's sequence the draws of an impact begin."""

_QUARTER_TURN = math.pi / 2


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def exponential(part, mean, most):
    """A number up to ``most`` of an exponential distribution cut off there, from a part of 1."""
    return -mean * math.log(1.0 - part * (1.0 - math.exp(-most / mean)))


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def thrown(u, v, azimuth, angle, speed, east, north):
    """Velocity of a grain thrown at an ``angle`` to a surface with slopes, turned from (u, v)."""
    length = math.sqrt(u * u + v * v)
    x, y = (u / length, v / length) if length > 0.0 else (1.0, 0.0)
    x, y = x * math.cos(azimuth) - y * math.sin(azimuth), x * math.sin(azimuth) + y * math.cos(azimuth)
    rise = x * east + y * north
    along = speed * math.cos(angle) / math.sqrt(1.0 + rise * rise)
    across = speed * math.sin(angle) / math.sqrt(1.0 + east * east + north * north)
    return along * x - across * east, along * y - across * north, along * rise + across


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def rebound(slot, start, surface, east, north, grains, rule):
    """Throw a grain back off the surface, or leave it where it is; its speed of impact."""
    u, v, w = np.float64(grains.u[slot]), np.float64(grains.v[slot]), np.float64(grains.w[slot])
    speed = math.sqrt(u * u + v * v + w * w)
    grains.z[slot] = np.float32(surface)
    chance = rule.rebound_most * (1.0 - math.exp(-rule.rebound_rate * speed))
    if draw(start, REBOUND_DRAWS) >= chance or grains.bounces[slot] >= rule.most:
        grains.held[slot] = LANDED
        return speed
    angle = exponential(draw(start, REBOUND_DRAWS + 1), rule.rebound_angle, _QUARTER_TURN)
    azimuth = rule.spread * (2.0 * draw(start, REBOUND_DRAWS + 2) - 1.0)
    u, v, w = thrown(u, v, azimuth, angle, rule.restitution * speed, east, north)
    grains.u[slot], grains.v[slot], grains.w[slot] = np.float32(u), np.float32(v), np.float32(w)
    grains.bounces[slot] += 1
    return speed


@njit(cache=True, nogil=True, error_model="numpy")
def _plenty(sorting, kind, cell, mixture):
    """Ejecta of a cell's sand over those of sand that is all alike."""
    if sorting is None:
        return 1.0
    held = amount(mixture.layer, cell)
    weight = 0.0
    for other in range(sorting.number.shape[1]):
        weight += sorting.number[kind, other] * mixture.layer[other, cell]
    return weight / held if held > 0 else 0.0


@njit(cache=True, nogil=True, error_model="numpy")
def _thrown_kind(sorting, kind, cell, mixture, part):
    """The size of the next ejectum, -1 where none can be thrown out any more."""
    if sorting is None:
        return 0
    rest = part * _plenty(sorting, kind, cell, mixture) * amount(mixture.layer, cell)
    found = -1
    for other in range(sorting.number.shape[1]):
        weight = sorting.number[kind, other] * mixture.layer[other, cell]
        if weight > 0.0 and rest >= 0.0:
            found = other
            rest -= weight
    return found


@njit(cache=True, nogil=True, error_model="numpy")
def _pace(sorting, kind, other):
    """Mean speed of ejecta of another size over that of sand that is all alike."""
    if sorting is None:
        return 1.0
    return sorting.speed[kind, other]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _note_lost(lost, cell, places, counts):
    counts[LOST] += lost
    if places is not None:
        places[cell] += lost


@njit(cache=True, nogil=True, error_model="numpy")
def _gather(found, piece, grains, events, ejecta):
    """List impacts and free slots of the events of all pieces; how many there are of each."""
    hits = free = 0
    for number in range(found.size):
        for k in range(number * piece, number * piece + found[number]):
            ejecta.hits[hits] = k
            hits += events.impact[k] != 0.0
            slot = events.slot[k]
            ejecta.free[free] = slot
            free += slot >= 0 and grains.held[slot] == FREE
    return hits, free


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _dig(k, cell, number, free, taken, grains, ground, scale, grid, rule, events, ejecta):
    """Take the parcels of ``number`` ejecta of entry ``k``; how many of the ``free`` slots are taken then."""
    x, y, start = events.x[k], events.y[k], events.start[k]
    hitting = kind_of(events.kind, k)
    for one in range(number):
        if taken == free:
            break
        surface, east, north = surface_at(x, y, ground.height, scale.cell_size, grid)
        part = draw(start, KIND_DRAWS + one)
        kind = _thrown_kind(rule.sorting, hitting, cell, ground.mixture, part)
        if kind < 0 or not take_up(cell, kind, ground, scale, grid):
            continue
        slot = ejecta.free[taken]
        ejecta.entry[taken], ejecta.number[taken], ejecta.slot[taken] = k, one, slot
        ejecta.surface[taken], ejecta.east[taken], ejecta.north[taken] = surface, east, north
        set_kind(grains.kind, slot, kind)
        taken += 1
    return taken


@njit(cache=True, nogil=True, error_model="numpy")
def eject(found, piece, grains, ground, scale, grid, rule, events, ejecta, counts):
    """Take the sand of what impacts throw out, impact by impact; how many. Launching is for ``throw``.

    Of each piece, of as many slots, there are as many events as ``found``. Where no slot is free any more the
    air carries all it can, and nothing more is thrown out. Without a ``rule`` nothing ever is.
    """
    if rule is None:
        return 0
    found, grains, ground, rule = lent((found, grains, ground, rule))
    events, ejecta, counts = lent((events, ejecta, counts))
    hits, free = _gather(found, piece, grains, events, ejecta)
    taken = 0
    for at in range(hits):
        k = ejecta.hits[at]
        cell = nearest_cell(events.x[k], events.y[k], grid)
        _note_lost(events.lost[k], cell, ground.lost, counts)
        plenty = _plenty(rule.sorting, kind_of(events.kind, k), cell, ground.mixture)
        most = rule.number * events.impact[k] * plenty + draw(events.start[k], EJECTA_DRAWS)
        number = min(np.int64(most), MOST_EJECTA)
        if number > 0:
            about = grains, ground, scale, grid, rule, events, ejecta
            taken = _dig(k, cell, number, free, taken, *about)
        push(rule.creep, k, cell, ground, scale, grid, events, counts)
    counts[MOVED] += taken
    return taken


@njit(cache=True, nogil=True, error_model="numpy")
def throw(first, last, grains, rule, events, ejecta):
    """Launch some of the ejecta whose sand was taken. Each has a slot of its own: threads may share them."""
    if rule is None:
        return
    grains, rule, events, ejecta = lent((grains, rule, events, ejecta))
    for at in range(first, last):
        k, one, slot = ejecta.entry[at], ejecta.number[at], ejecta.slot[at]
        speed, start = events.impact[k], events.start[k]
        draws = EJECTA_DRAWS + 1 + one * DRAWS_PER_EJECTUM
        angle = exponential(draw(start, draws), rule.eject_angle, _QUARTER_TURN)
        azimuth = rule.spread * (2.0 * draw(start, draws + 1) - 1.0)
        mean = rule.fastest * (1.0 - math.exp(-speed / rule.scale))
        pace = _pace(rule.sorting, kind_of(events.kind, k), kind_of(grains.kind, slot))
        fast = exponential(draw(start, draws + 2), mean * pace, speed)
        u, v, w = thrown(events.u[k], events.v[k], azimuth, angle, fast, ejecta.east[at], ejecta.north[at])
        u, v, w = np.float32(u), np.float32(v), np.float32(w)
        launch(slot, events.x[k], events.y[k], np.float32(ejecta.surface[at]), u, v, w, grains)
