"""A batch of iterations: all grains fly, land, change the bed and start, again and again, in one call.

Several threads may make it together, one of which leads (``board``). They share pieces of the slots, let them
fly and land; the exchange of sand, in the order of slots, is the leader's; then they share the ejecta to be
launched and the rows of the mesh to be renewed. No piece depends on another one of its round or on who does
it, so the bits are the same for any number of threads.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import reseed
from barchan.kernels.core import work_queue
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.random import derive
from barchan.kernels.core.work_queue import NOTHING, await_done, pop_front, publish, task_done, wait_pop_back
from barchan.kernels.grains.exchange import exchange
from barchan.kernels.grains.flight import move_blocks
from barchan.kernels.grains.landing import land
from barchan.kernels.grains.splash import eject, throw
from barchan.kernels.grains.state import FLOWN
from barchan.kernels.grains.surface import renew_stale

PIECE = 1024
"""Slots of a piece: work for some 10 µs. Where there are too many pieces they are larger."""


_EJECTA = 128
_CELLS = 4096
"""Ejecta, and cells of the mesh, of a piece of the second round."""


class Plan(NamedTuple):
    """The division of iterations among threads."""

    key: np.uint64
    slots: int
    piece: int
    board: np.ndarray
    found: np.ndarray
    """Entries of each piece."""
    progress: np.ndarray
    """See ``ITERATION``."""


ITERATION, ROUND, OFFERED, THROWN = range(4)
"""Entries of the progress: the iteration, the round (even: flight, odd: the exchange of sand and what follows
it), pieces offered since the start, and parcels thrown out in this iteration."""


def plan_of(key: int, slots: int, first: int) -> Plan:
    """A plan for some slots under a stream's key, from iteration ``first`` on."""
    piece = PIECE
    while slots > piece * work_queue.MOST_PIECES:
        piece *= 2
    found, progress = np.zeros(-(-slots // piece), np.int64), np.array([first - 1, -1, 0, 0])
    return Plan(np.uint64(key), slots, piece, work_queue.new_board(), found, progress)


@njit(inline="always")
def _fly(number, plan, scene, work):
    """Move the slots of a piece by one time step, and handle those that may have landed."""
    first = number * plan.piece
    last = min(first + plan.piece, plan.slots)
    grains, air, ground, landings = scene.grains, scene.air, scene.ground, scene.landings
    count = move_blocks(first, last, grains, air, ground, landings.candidates, work)
    key = derive(plan.key, plan.progress[ITERATION])
    plan.found[number] = land(first, count, key, grains, air, ground, scene.rules, landings)


@njit(inline="always")
def _exchange(plan, scene):
    """Exchange the sand of grains that flew and of ejecta."""
    grains, ground, landings, counts = scene.grains, scene.ground, scene.landings, scene.counts
    reseed(ground.active_layer, derive(derive(plan.key, plan.progress[ITERATION]), plan.slots))
    for number in range(plan.found.size):
        exchange(number * plan.piece, plan.found[number], grains, ground, landings, counts)
    splash, ejecta = scene.rules.splash, scene.ejecta
    thrown = eject(plan.found, plan.piece, grains, ground, splash, landings, ejecta, counts)
    plan.progress[THROWN] = thrown
    counts[FLOWN] += plan.slots


@njit(cache=True, nogil=True, error_model="numpy")
def _pieces(count, size):
    return (count + size - 1) // size


@njit(cache=True, nogil=True, error_model="numpy")
def _rows(grid):
    """Rows of the mesh in a piece."""
    return max(1, _CELLS // grid.cols)


@njit(inline="always")
def _finish(number, plan, scene):
    """Launch a piece of the ejecta, or after those renew a piece of the mesh."""
    thrown, rows = plan.progress[THROWN], _rows(scene.ground.grid)
    others = _pieces(thrown, _EJECTA)
    if number < others:
        last = min((number + 1) * _EJECTA, thrown)
        throw(number * _EJECTA, last, scene.grains, scene.rules.splash, scene.landings, scene.ejecta)
    else:
        first = (number - others) * rows
        renew_stale(first, min(first + rows, scene.ground.grid.rows), scene.ground)


@njit(inline="always")
def _next_round(plan, scene, end):
    """Once this round is done, publish the next one; its number, or ``NOTHING`` before iteration ``end``."""
    done = plan.progress[ROUND]
    await_done(plan.board, plan.progress[OFFERED])
    if done % 2 == 1 and plan.progress[ITERATION] + 1 == end:
        return NOTHING
    plan.progress[ROUND] = done + 1
    if done % 2 == 1:
        plan.progress[ITERATION] += 1
        pieces = plan.found.size
    else:
        _exchange(plan, scene)
        pieces = _pieces(plan.progress[THROWN], _EJECTA) + _pieces(
            scene.ground.grid.rows, _rows(scene.ground.grid)
        )
    plan.progress[OFFERED] += pieces
    publish(plan.board, done + 1, pieces)
    return done + 1


@njit(cache=True, nogil=True, error_model="numpy")
def run_iterations(leads, plan, scene, work, end):
    """Make iterations up to before ``end``; or, as a thread that does not lead, help until the board closes.

    ``work`` is the thread's own ``work_space``.

    There is one place where pieces are done, whoever does them, and functions that it calls are made part of
    it: code that is called through several others would be compiled again for each of them.
    """
    plan, scene, work = borrowed((plan, scene, work))
    while True:
        if leads:
            this_round, number = plan.progress[ROUND], pop_front(plan.board)
            if number == NOTHING:
                if _next_round(plan, scene, end) == NOTHING:
                    return
                continue
        else:
            this_round, number = wait_pop_back(plan.board)
            if number == NOTHING:
                return
        if this_round % 2 == 0:
            _fly(number, plan, scene, work)
        else:
            _finish(number, plan, scene)
        task_done(plan.board)
