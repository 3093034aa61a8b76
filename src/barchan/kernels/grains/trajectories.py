"""Grains followed one at a time from lift-off to rest (Prague thesis, Alg. 8)."""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import derive
from barchan.kernels.grains.bonds import wind_breaks
from barchan.kernels.grains.collapse import settle_about
from barchan.kernels.grains.entrainment import entrain
from barchan.kernels.grains.exchange import deposit, end_travel, lift
from barchan.kernels.grains.flight import move_blocks, work_space
from barchan.kernels.grains.landing import land
from barchan.kernels.grains.state import FLOWN, FLYING, NOWHERE, OUT, SUNK
from barchan.kernels.grains.surface import renew_stale, stack_at

LONGEST_FLIGHT = 1_000_000
"""Time steps after which a grain of a single trajectory is put down where it is."""


@internal(error_model="numpy")
def _exchange_one(scene):
    """Exchange the sand of the only entry, and recompute the mesh at once."""
    grains, ground, landings, counts = scene.grains, scene.ground, scene.landings, scene.counts
    if landings.deposit_cell[0] == OUT:
        end_travel(0, landings, counts)
    if landings.deposit_cell[0] >= 0:
        row, col = stack_at(landings.deposit_cell[0], ground.grid)
        deposit(0, row, col, ground, landings, counts)
    if landings.lift_cell[0] != NOWHERE:
        row, col = stack_at(landings.lift_cell[0], ground.grid)
        lift(0, row, col, wind_breaks(ground.bonds), grains, ground, landings, counts)
    renew_stale(0, scene.ground.grid.rows, scene.ground)


@njit(inline="always")
def _fly_one(key, scene, work):
    """Move the grain in the first slot by one time step; the number of entries.

    Made part of its callers: a call for each time step would hand over the whole scene.
    """
    grains, air, ground, landings = scene.grains, scene.air, scene.ground, scene.landings
    count = move_blocks(0, 1, grains, air, ground, landings.candidates, work)
    if count > 0:
        count = land(0, count, key, grains, air, ground, scene.rules, landings)
    return count


@njit(cache=True, nogil=True, error_model="numpy")
def trajectories(first, count, key, scene, lifting, slopes):
    """``count`` complete trajectories, one after the other, from number ``first`` on; then the bed relaxes.

    All fly in the first slot; a grain that does not land for ``LONGEST_FLIGHT`` time steps is put down.
    ``lifting`` is the entrainment that starts a trajectory; that of the scene's rules has no chance.
    """
    scene, slopes = borrowed((scene, slopes))
    work = work_space()
    landings, counts, ground = scene.landings, scene.counts, scene.ground
    for number in range(first, first + count):
        start = derive(key, number)
        source = entrain(0, start, scene.grains, ground, lifting)
        if source == NOWHERE:
            continue
        landings.slot[0], landings.deposit_cell[0], landings.lift_cell[0] = 0, NOWHERE, source
        _exchange_one(scene)
        aloft = 0
        while scene.grains.status[0] == FLYING:
            counts[FLOWN] += 1
            aloft += 1
            if aloft > LONGEST_FLIGHT:
                scene.grains.z[0] = SUNK
                scene.grains.bounces[0] = max(scene.grains.bounces[0], scene.rules.bounce.most)
            if _fly_one(start, scene, work):
                _exchange_one(scene)
        end = landings.deposit_cell[0] if landings.deposit_cell[0] >= 0 else source
        settle_about(source, end, ground, slopes, start)


@njit(cache=True, nogil=True, error_model="numpy")
def trace(key, scene, lifting, path):
    """Follow one grain from lift-off to rest over a bed that stays as it is; the number of rows of ``path``.

    A row of ``path`` holds, for one time step, place (cells; laps round the field added), height (m),
    velocity (m/s) and bounces since lift-off. The flight ends where it is when ``path`` is full. 0: nothing
    was lifted.
    """
    scene = borrowed(scene)
    grains, grid, work = scene.grains, scene.ground.grid, work_space()
    if entrain(0, key, grains, scene.ground, lifting) == NOWHERE:
        return 0
    for k in range(path.shape[0]):
        path[k, 0] = np.float64(grains.x[0]) + np.float64(grains.wraps_x[0]) * grid.cols
        path[k, 1] = np.float64(grains.y[0]) + np.float64(grains.wraps_y[0]) * grid.rows
        path[k, 2], path[k, 3], path[k, 4] = grains.z[0], grains.u[0], grains.v[0]
        path[k, 5], path[k, 6] = grains.w[0], grains.bounces[0]
        if _fly_one(derive(key, k), scene, work):
            return k + 1
    return path.shape[0]
