"""Splash: a grain that hits the bed rebounds or stays, and throws others out of it.

The probability of a rebound grows with impact speed; the speed of rebounds and the number of low, slow ejecta
are in proportion to it (Anderson & Haff 1991; Kok & Renno 2009). In sand of several sizes each class throws
out parcels of each. Impacts also push grains along the bed (``creep``).
"""

import math

import numpy as np

from barchan.kernels.bed.active_layer import class_at, parcels_of
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal, woven
from barchan.kernels.core.random import draw
from barchan.kernels.grains.bonds import impact_breaks
from barchan.kernels.grains.creep import push
from barchan.kernels.grains.exchange import take_up
from barchan.kernels.grains.pool import launch
from barchan.kernels.grains.state import LANDED, LOSS, MOVED
from barchan.kernels.grains.surface import surface_at

MOST_EJECTA = 8
"""Ejecta of one impact at most."""

REBOUND_DRAWS, EJECTA_DRAWS, DRAWS_PER_EJECTUM, CLASS_DRAWS, BOND_DRAWS = 10, 20, 3, 60, 70
"""Where in a slot's sequence the draws of an impact begin."""

_QUARTER_TURN = math.pi / 2


@internal(error_model="numpy", forceinline=True)
def exponential(part, mean, most):
    """A number of an exponential distribution cut off at ``most``, from a random ``part`` of 1."""
    return -mean * math.log(1.0 - part * (1.0 - math.exp(-most / mean)))


@internal(error_model="numpy", forceinline=True)
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


@internal(error_model="numpy", forceinline=True)
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


@internal(error_model="numpy")
def _abundance(by_size, size_class, cell, layer):
    """Ejecta of an impact by a size class on a cell over those of sand of one size."""
    if by_size is None:
        return 1.0
    held = parcels_of(layer.surface, cell)
    weight = 0.0
    for other in range(by_size.number.shape[1]):
        weight += by_size.number[size_class, other] * layer.surface[other, cell]
    return weight / held if held > 0 else 0.0


@internal(error_model="numpy")
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


@internal(error_model="numpy")
def _relative_speed(by_size, size_class, other):
    """Mean speed of ejecta of size class ``other`` over that of sand of one size."""
    if by_size is None:
        return 1.0
    return by_size.speed[size_class, other]


@internal(error_model="numpy", forceinline=True)
def _note_loss(loss, cell, feedback, counts):
    """Add the speed that an impact took to the counts, and to its cell where the near-bed wind varies."""
    counts[LOSS] += loss
    if feedback is not None:
        feedback.momentum_loss[cell] += loss


@internal(error_model="numpy", forceinline=True)
def ejecta_of(k, abundance, rule, landings):
    """Number of parcels that the impact of entry ``k`` is to throw out."""
    most = rule.number * landings.impact_speed[k] * abundance + draw(landings.start[k], EJECTA_DRAWS)
    return min(np.int64(most), MOST_EJECTA)


@woven(error_model="numpy")
def _dig(k, one, row, col, ground, by_size, landings, ejecta, place):
    """Take the parcel of ejectum ``one`` of entry ``k``, noted in a ``place``; False: it is not there."""
    start, cell = landings.start[k], row * ground.grid.cols + col
    surface, east, north = surface_at(landings.x[k], landings.y[k], ground)
    hitting, part = class_at(landings.size_class, k), draw(start, CLASS_DRAWS + one)
    size_class = _random_class(by_size, hitting, cell, ground.active_layer, part)
    breaks = impact_breaks(ground.bonds, start, BOND_DRAWS + one)
    if size_class < 0 or not take_up(row, col, size_class, ground, breaks):
        return False
    ejecta.entry[place], ejecta.number[place], ejecta.size_class[place] = k, one, size_class
    ejecta.surface[place], ejecta.east[place], ejecta.north[place] = surface, east, north
    return True


@woven(error_model="numpy")
def impact(k, row, col, places, ground, rule, landings, ejecta, counts):
    """Take the sand that the impact of entry ``k`` on a cell throws out, and push grains; see ``throw``.

    Ejecta are noted one after the other within the ``places``, from the first to before the last; where no
    place is left the air carries all it can, and nothing more is thrown out. Returns the first that is left.
    """
    cell = row * ground.grid.cols + col
    _note_loss(landings.momentum_loss[k], cell, ground.feedback, counts)
    hitting = class_at(landings.size_class, k)
    abundance = _abundance(rule.by_size, hitting, cell, ground.active_layer)
    place, end = places
    for one in range(ejecta_of(k, abundance, rule, landings)):
        if place == end:
            break
        if _dig(k, one, row, col, ground, rule.by_size, landings, ejecta, place):
            counts[MOVED] += 1
            place += 1
    push(rule.creep, k, row, col, ground, landings, counts)
    return place


@internal(error_model="numpy")
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
