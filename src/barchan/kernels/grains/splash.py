"""Splash: a grain that hits the bed rebounds or stays, and throws others out of it.

The probability of a rebound grows with impact speed; the speed of rebounds and the number of low, slow ejecta
are in proportion to it (Anderson & Haff 1991; Kok & Renno 2009). In sand of several sizes each class throws
out parcels of each. Impacts also push grains along the bed (``creep``).
"""

import math

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import class_at, parcels_of, set_class
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.random import draw
from barchan.kernels.grains.bonds import impact_breaks
from barchan.kernels.grains.creep import push
from barchan.kernels.grains.exchange import take_up
from barchan.kernels.grains.pool import launch
from barchan.kernels.grains.state import FREE, LANDED, LOSS, MOVED
from barchan.kernels.grains.surface import nearest_cell, surface_at

MOST_EJECTA = 8
"""Ejecta of one impact at most."""

REBOUND_DRAWS, EJECTA_DRAWS, DRAWS_PER_EJECTUM, CLASS_DRAWS, BOND_DRAWS = 10, 20, 3, 60, 70
"""Where in a slot's sequence the draws of an impact begin."""

_QUARTER_TURN = math.pi / 2


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def exponential(part, mean, most):
    """A number of an exponential distribution cut off at ``most``, from a random ``part`` of 1."""
    return -mean * math.log(1.0 - part * (1.0 - math.exp(-most / mean)))


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def thrown(u, v, angles, speed, east, north):
    """Velocity of a grain thrown off a surface with slopes, at an azimuth from (u, v) and an angle (rad)."""
    azimuth, angle = angles
    length = math.sqrt(u * u + v * v)
    x, y = (u / length, v / length) if length > 0.0 else (1.0, 0.0)
    x, y = x * math.cos(azimuth) - y * math.sin(azimuth), x * math.sin(azimuth) + y * math.cos(azimuth)
    rise = x * east + y * north
    along = speed * math.cos(angle) / math.sqrt(1.0 + rise * rise)
    across = speed * math.sin(angle) / math.sqrt(1.0 + east * east + north * north)
    return along * x - across * east, along * y - across * north, along * rise + across


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def rebound(slot, start, surface, grains, rule, restitution, most):
    """Throw a grain back off a ``surface`` (height and slopes), or leave it there; its impact speed (m/s).

    ``restitution`` is that of the surface.
    """
    height, east, north = surface
    u, v, w = np.float64(grains.u[slot]), np.float64(grains.v[slot]), np.float64(grains.w[slot])
    speed = math.sqrt(u * u + v * v + w * w)
    grains.z[slot] = np.float32(height)
    probability = rule.rebound_probability * (1.0 - math.exp(-rule.rebound_rate * speed))
    if draw(start, REBOUND_DRAWS) >= probability or grains.bounces[slot] >= most:
        grains.status[slot] = LANDED
        return speed
    angle = exponential(draw(start, REBOUND_DRAWS + 1), rule.rebound_angle, _QUARTER_TURN)
    azimuth = rule.spread * (2.0 * draw(start, REBOUND_DRAWS + 2) - 1.0)
    u, v, w = thrown(u, v, (azimuth, angle), restitution * speed, east, north)
    grains.u[slot], grains.v[slot], grains.w[slot] = np.float32(u), np.float32(v), np.float32(w)
    grains.bounces[slot] += 1
    return speed


@njit(cache=True, nogil=True, error_model="numpy")
def _abundance(by_size, size_class, cell, layer):
    """Ejecta of an impact by a size class on a cell over those of sand of one size."""
    if by_size is None:
        return 1.0
    held = parcels_of(layer.surface, cell)
    weight = 0.0
    for other in range(by_size.number.shape[1]):
        weight += by_size.number[size_class, other] * layer.surface[other, cell]
    return weight / held if held > 0 else 0.0


@njit(cache=True, nogil=True, error_model="numpy")
def _random_class(by_size, size_class, cell, layer, part):
    """Size class of the next ejectum; -1 where none can be thrown out any more."""
    if by_size is None:
        return np.int64(0)
    rest = part * _abundance(by_size, size_class, cell, layer) * parcels_of(layer.surface, cell)
    found = -1
    for other in range(by_size.number.shape[1]):
        weight = by_size.number[size_class, other] * layer.surface[other, cell]
        if weight > 0.0 and rest >= 0.0:
            found = other
            rest -= weight
    return found


@njit(cache=True, nogil=True, error_model="numpy")
def _relative_speed(by_size, size_class, other):
    """Mean speed of ejecta of size class ``other`` over that of sand of one size."""
    if by_size is None:
        return 1.0
    return by_size.speed[size_class, other]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _note_loss(loss, cell, feedback, counts):
    """Add the speed that an impact took to the counts, and to its cell where the near-bed wind varies."""
    counts[LOSS] += loss
    if feedback is not None:
        feedback.momentum_loss[cell] += loss


@njit(cache=True, nogil=True, error_model="numpy")
def _gather(found, piece, grains, landings, ejecta):
    """List impacts and free slots of the entries of all pieces; the number of each."""
    hits = free = 0
    for number in range(found.size):
        for k in range(number * piece, number * piece + found[number]):
            ejecta.hits[hits] = k
            hits += landings.impact_speed[k] != 0.0
            slot = landings.slot[k]
            ejecta.free[free] = slot
            free += slot >= 0 and grains.status[slot] == FREE
    return hits, free


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _dig(k, cell, number, slots, grains, ground, by_size, landings, ejecta):
    """Take the parcels of ``number`` ejecta of entry ``k``.

    ``slots`` are the number of free slots and of those that are taken; returns how many are taken then.
    """
    free, taken = slots
    x, y, start = landings.x[k], landings.y[k], landings.start[k]
    hitting = class_at(landings.size_class, k)
    for one in range(number):
        if taken == free:
            break
        surface, east, north = surface_at(x, y, ground)
        part = draw(start, CLASS_DRAWS + one)
        size_class = _random_class(by_size, hitting, cell, ground.active_layer, part)
        breaks = impact_breaks(ground.bonds, start, BOND_DRAWS + one)
        if size_class < 0 or not take_up(cell, size_class, ground, breaks):
            continue
        slot = ejecta.free[taken]
        ejecta.entry[taken], ejecta.number[taken], ejecta.slot[taken] = k, one, slot
        ejecta.surface[taken], ejecta.east[taken], ejecta.north[taken] = surface, east, north
        set_class(grains.size_class, slot, size_class)
        taken += 1
    return taken


@njit(cache=True, nogil=True, error_model="numpy")
def eject(found, piece, grains, ground, rule, landings, ejecta, counts):
    """Take the sand that impacts throw out, impact by impact; the number of ejecta. ``throw`` launches them.

    Of each piece of slots there are ``found`` entries. Where no slot is free any more the air carries all it
    can, and nothing more is thrown out. Without a ``rule`` nothing ever is.
    """
    if rule is None:
        return 0
    found, grains, ground, rule = borrowed((found, grains, ground, rule))
    landings, ejecta, counts = borrowed((landings, ejecta, counts))
    hits, free = _gather(found, piece, grains, landings, ejecta)
    taken = np.int64(0)
    for at in range(hits):
        k = ejecta.hits[at]
        cell = nearest_cell(landings.x[k], landings.y[k], ground.grid)
        _note_loss(landings.momentum_loss[k], cell, ground.feedback, counts)
        hitting = class_at(landings.size_class, k)
        abundance = _abundance(rule.by_size, hitting, cell, ground.active_layer)
        most = rule.number * landings.impact_speed[k] * abundance + draw(landings.start[k], EJECTA_DRAWS)
        number = min(np.int64(most), MOST_EJECTA)
        if number > 0:
            taken = _dig(k, cell, number, (free, taken), grains, ground, rule.by_size, landings, ejecta)
        push(rule.creep, k, cell, ground, landings, counts)
    counts[MOVED] += taken
    return taken


@njit(cache=True, nogil=True, error_model="numpy")
def throw(first, last, grains, rule, landings, ejecta):
    """Launch ejecta whose sand was taken. Each has a slot of its own, so threads may share them."""
    if rule is None:
        return
    grains, rule, landings, ejecta = borrowed((grains, rule, landings, ejecta))
    for at in range(first, last):
        k, one, slot = ejecta.entry[at], ejecta.number[at], ejecta.slot[at]
        speed, start = landings.impact_speed[k], landings.start[k]
        draws = EJECTA_DRAWS + 1 + one * DRAWS_PER_EJECTUM
        angle = exponential(draw(start, draws), rule.ejecta_angle, _QUARTER_TURN)
        azimuth = rule.spread * (2.0 * draw(start, draws + 1) - 1.0)
        mean = rule.fastest * (1.0 - math.exp(-speed / rule.scale))
        pace = _relative_speed(
            rule.by_size, class_at(landings.size_class, k), class_at(grains.size_class, slot)
        )
        fast = exponential(draw(start, draws + 2), mean * pace, speed)
        u, v = landings.u[k], landings.v[k]
        u, v, w = thrown(u, v, (azimuth, angle), fast, ejecta.east[at], ejecta.north[at])
        velocity = np.float32(u), np.float32(v), np.float32(w)
        launch(slot, landings.x[k], landings.y[k], np.float32(ejecta.surface[at]), velocity, grains)
