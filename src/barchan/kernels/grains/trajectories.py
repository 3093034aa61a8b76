"""Grains followed one at a time from lift-off to rest (seed 000, Alg. 8)."""

import numpy as np
from numba import njit

from barchan.kernels.core.random import derive
from barchan.kernels.grains.entrainment import lift
from barchan.kernels.grains.exchange import exchange, settle_about
from barchan.kernels.grains.landing import fly
from barchan.kernels.grains.state import FLOWN, FLYING, NOWHERE
from barchan.kernels.grains.surface import renew_stale


@njit(cache=True, nogil=True, error_model="numpy")
def _exchange_one(grains, ground, scale, grid, events, counts):
    """Exchange the sand of the only entry, and let the mesh follow at once."""
    exchange(0, 1, grains, ground, scale, grid, events, counts)
    renew_stale(0, grid.rows, ground, grid)


@njit(cache=True, nogil=True, error_model="numpy")
def trajectories(count, key, grains, air, ground, scale, grid, rules, splash, slopes, events, counts):
    """``count`` complete trajectories, one after the other, in the first slot; the bed relaxes after each.

    ``rules`` are those of lift-off and those of ``fly``, without lift-off; ``slopes`` are the order of
    neighbours, the limits, and the work space of ``settle_steep``.
    """
    lift_rule, in_flight = rules
    sequences, repose, queue, waiting = slopes
    for number in range(count):
        start = derive(key, number)
        source = lift(0, start, grains, ground, scale, grid, lift_rule)
        if source == NOWHERE:
            continue
        events.slot[0], events.rest[0], events.source[0] = 0, NOWHERE, source
        _exchange_one(grains, ground, scale, grid, events, counts)
        while grains.held[0] == FLYING:
            counts[FLOWN] += 1
            if fly(0, 1, start, grains, air, grid, ground, scale, in_flight, splash, events):
                _exchange_one(grains, ground, scale, grid, events, counts)
        end = events.rest[0] if events.rest[0] >= 0 else source
        settle_about(source, end, ground, scale, sequences, start, grid, repose, queue, waiting)


@njit(cache=True, nogil=True, error_model="numpy")
def trace(key, grains, air, ground, scale, grid, rules, splash, events, path):
    """Follow one grain from lift-off to rest over a bed that stays as it is; how many places were written.

    ``path`` takes, for each time step, place (cells; laps round the field added), height (m), velocity (m/s)
    and bounces so far. The flight ends where it is when ``path`` is full. No place: nothing was lifted.
    """
    lift_rule, in_flight = rules
    if lift(0, key, grains, ground, scale, grid, lift_rule) == NOWHERE:
        return 0
    for k in range(path.shape[0]):
        path[k, 0] = np.float64(grains.x[0]) + np.float64(grains.laps_x[0]) * grid.cols
        path[k, 1] = np.float64(grains.y[0]) + np.float64(grains.laps_y[0]) * grid.rows
        path[k, 2], path[k, 3], path[k, 4] = grains.z[0], grains.u[0], grains.v[0]
        path[k, 5], path[k, 6] = grains.w[0], grains.bounces[0]
        if fly(0, 1, derive(key, k), grains, air, grid, ground, scale, in_flight, splash, events):
            return k + 1
    return path.shape[0]
