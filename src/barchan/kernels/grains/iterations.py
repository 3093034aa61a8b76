"""A spell of iterations: all grains fly, land, change the bed and start, again and again, in one call.

Several threads may make it together, one of which leads (``board``). They share pieces of the slots, let them
fly and land; the exchange of sand, in the order of slots, is the leader's; then they share the ejecta to be
launched and the rows of the mesh to be renewed. No piece depends on another one of its round or on who does
it, so the bits are the same for any number of threads.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import shuffle_anew
from barchan.kernels.core import work_queue
from barchan.kernels.core.borrow import lent
from barchan.kernels.core.random import derive
from barchan.kernels.core.work_queue import NOTHING, await_done, await_last, offer, report, take_first
from barchan.kernels.grains.exchange import exchange
from barchan.kernels.grains.flight import move_blocks, work_space
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
    """What threads that share iterations agree on."""

    key: np.uint64
    slots: int
    piece: int
    board: np.ndarray
    found: np.ndarray
    """Events of each piece."""
    now: np.ndarray
    """How far they have come: see ``ITERATION``."""


ITERATION, TURN, OFFERED, THROWN = range(4)
"""What ``now`` holds: the iteration, the round (even: flight, odd: what follows), pieces offered so far, and
parcels thrown out in this iteration."""


def plan_of(key: int, slots: int, first: int) -> Plan:
    """A plan for some slots under a stream's key, from iteration ``first`` on."""
    piece = PIECE
    while slots > piece * work_queue.MOST_PIECES:
        piece *= 2
    found, now = np.zeros(-(-slots // piece), np.int64), np.array([first - 1, -1, 0, 0])
    return Plan(np.uint64(key), slots, piece, work_queue.new_board(), found, now)


@njit(inline="always")
def _fly(number, plan, scene, work):
    """Let the slots of a piece fly and land."""
    first = number * plan.piece
    last = min(first + plan.piece, plan.slots)
    about = scene.grains, scene.air, scene.grid, scene.ground
    count = move_blocks(first, last, *about, scene.events.near, work)
    rules = scene.scale, scene.rules, scene.splash, scene.events
    plan.found[number] = land(first, count, derive(plan.key, plan.now[ITERATION]), *about, *rules)


@njit(inline="always")
def _exchange(plan, scene):
    """Let the sand change places, of grains that flew and of ejecta."""
    about = scene.grains, scene.ground, scene.scale, scene.grid
    shuffle_anew(scene.ground.mixture, derive(derive(plan.key, plan.now[ITERATION]), plan.slots))
    for number in range(plan.found.size):
        exchange(number * plan.piece, plan.found[number], *about, scene.events, scene.counts)
    about_splash = scene.splash, scene.events, scene.ejecta, scene.counts
    plan.now[THROWN] = eject(plan.found, plan.piece, *about, *about_splash)
    scene.counts[FLOWN] += plan.slots


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
    thrown, rows = plan.now[THROWN], _rows(scene.grid)
    others = _pieces(thrown, _EJECTA)
    if number < others:
        last = min((number + 1) * _EJECTA, thrown)
        throw(number * _EJECTA, last, scene.grains, scene.splash, scene.events, scene.ejecta)
    else:
        first = (number - others) * rows
        renew_stale(first, min(first + rows, scene.grid.rows), scene.ground, scene.grid)


@njit(inline="always")
def _next_round(plan, scene, end):
    """Once this round is done, offer the next one; its number, or ``NOTHING`` before iteration ``end``."""
    turn = plan.now[TURN]
    await_done(plan.board, plan.now[OFFERED])
    if turn % 2 == 1 and plan.now[ITERATION] + 1 == end:
        return NOTHING
    plan.now[TURN] = turn + 1
    if turn % 2 == 1:
        plan.now[ITERATION] += 1
        pieces = plan.found.size
    else:
        _exchange(plan, scene)
        pieces = _pieces(plan.now[THROWN], _EJECTA) + _pieces(scene.grid.rows, _rows(scene.grid))
    plan.now[OFFERED] += pieces
    offer(plan.board, turn + 1, pieces)
    return turn + 1


@njit(cache=True, nogil=True, error_model="numpy")
def spell(leads, plan, scene, end):
    """Make iterations up to before ``end``; or, as a thread that does not lead, help until the board closes.

    There is one place where pieces are done, whoever does them, and functions that it calls are made part of
    it: code that is called through several others would be compiled again for each of them.
    """
    plan, scene, work = lent((plan, scene, work_space()))
    while True:
        if leads:
            turn, number = plan.now[TURN], take_first(plan.board)
            if number == NOTHING:
                if _next_round(plan, scene, end) == NOTHING:
                    return
                continue
        else:
            turn, number = await_last(plan.board)
            if number == NOTHING:
                return
        if turn % 2 == 0:
            _fly(number, plan, scene, work)
        else:
            _finish(number, plan, scene)
        report(plan.board)
