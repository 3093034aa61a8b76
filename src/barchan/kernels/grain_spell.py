"""A spell of iterations: all grains fly, land, change the bed and start, again and again, in one call.

Several threads may make it together, one of which leads (``board``). They share pieces of the slots, let them
fly and land; the exchange of sand, in the order of slots, is the leader's; then they share the ejecta to be
launched and the rows of the mesh to be renewed. No piece depends on another one of its round or on who does
it, so the bits are the same for any number of threads.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels import board
from barchan.kernels.board import NOTHING, await_done, await_last, count_done, offer, report, take_first
from barchan.kernels.grain_bed import FLOWN, exchange
from barchan.kernels.grain_flight import move_blocks, work_space
from barchan.kernels.grain_landing import land
from barchan.kernels.grain_splash import eject, gather, throw
from barchan.kernels.grain_state import Air, Bounce, Ejecta, Events, Grains, Ground, LiftOff, Scale
from barchan.kernels.grain_surface import renew_stale
from barchan.kernels.lending import lent
from barchan.kernels.mixture import shuffle_anew
from barchan.kernels.random import derive
from barchan.kernels.shadow import Grid

PIECE = 1024
"""Slots of a piece: work for some 10 µs. Where there are too many pieces they are larger."""

MOST_ITERATIONS = 256
"""Of a spell: so long an interruption waits."""

_EJECTA = 128
_CELLS = 4096
"""Ejecta, and cells of the mesh, of a piece of the second round."""


class Scene(NamedTuple):
    """What takes part in an iteration."""

    grains: Grains
    air: Air
    grid: Grid
    ground: Ground
    scale: Scale
    rules: tuple[Bounce, LiftOff]
    splash: object
    """What impacts throw out; None: nothing, grains bounce."""
    events: Events
    ejecta: Ejecta
    counts: np.ndarray


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


ITERATION, TURN, THROWN = range(3)
"""What ``now`` holds: the iteration, rounds so far, parcels thrown out in this iteration."""


def plan_of(key: int, slots: int) -> Plan:
    """A plan for some slots under a stream's key."""
    piece = PIECE
    while slots > piece * board.MOST_PIECES:
        piece *= 2
    found, now = np.zeros(-(-slots // piece), np.int64), np.zeros(3, np.int64)
    return Plan(np.uint64(key), slots, piece, board.new_board(), found, now)


@njit(cache=True, nogil=True, error_model="numpy")
def _fly(number, plan, scene, work):
    """Let the slots of a piece fly and land."""
    plan, scene, work = lent((plan, scene, work))
    key = derive(plan.key, plan.now[ITERATION])
    first = number * plan.piece
    last = min(first + plan.piece, plan.slots)
    about = scene.grains, scene.air, scene.grid, scene.ground
    count = move_blocks(first, last, *about, scene.events.near, work)
    rules = scene.scale, scene.rules, scene.splash, scene.events
    plan.found[number] = land(first, count, key, *about, *rules)


@njit(cache=True, nogil=True, error_model="numpy")
def _eject(splash, plan, scene):
    """Take the sand of ejecta; how many parcels."""
    if splash is None:
        return 0
    splash, plan, scene = lent((splash, plan, scene))
    hits = free = 0
    for number in range(plan.found.size):
        first, count = number * plan.piece, plan.found[number]
        hits, free = gather(first, count, scene.grains, scene.events, scene.ejecta, hits, free)
    about = scene.grains, scene.ground, scene.scale, scene.grid, splash
    return eject(hits, free, *about, scene.events, scene.ejecta, scene.counts)


@njit(cache=True, nogil=True, error_model="numpy")
def _exchange(plan, scene):
    """Let the sand change places; returns how many pieces the second round has."""
    plan, scene = lent((plan, scene))
    shuffle_anew(scene.ground.mixture, derive(derive(plan.key, plan.now[ITERATION]), plan.slots))
    about = scene.grains, scene.ground, scene.scale, scene.grid, scene.events, scene.counts
    for number in range(plan.found.size):
        exchange(number * plan.piece, plan.found[number], *about)
    plan.now[THROWN] = _eject(scene.splash, plan, scene)
    scene.counts[FLOWN] += plan.slots
    return _pieces(plan.now[THROWN], _EJECTA) + _pieces(scene.grid.rows, _rows(scene.grid))


@njit(cache=True, nogil=True, error_model="numpy")
def _pieces(count, size):
    return (count + size - 1) // size


@njit(cache=True, nogil=True, error_model="numpy")
def _rows(grid):
    """Rows of the mesh in a piece."""
    return max(1, _CELLS // grid.cols)


@njit(cache=True, nogil=True, error_model="numpy")
def _throw(splash, first, last, scene):
    if splash is not None:
        splash, scene = lent((splash, scene))
        throw(first, last, scene.grains, splash, scene.events, scene.ejecta)


@njit(cache=True, nogil=True, error_model="numpy")
def _finish(number, plan, scene):
    """Launch a piece of the ejecta, or after those renew a piece of the mesh."""
    plan, scene = lent((plan, scene))
    thrown, rows = plan.now[THROWN], _rows(scene.grid)
    others = _pieces(thrown, _EJECTA)
    if number < others:
        _throw(scene.splash, number * _EJECTA, min((number + 1) * _EJECTA, thrown), scene)
    else:
        first = (number - others) * rows
        renew_stale(first, min(first + rows, scene.grid.rows), scene.ground, scene.grid)


@njit(cache=True, nogil=True, error_model="numpy")
def _do(turn, number, plan, scene, work):
    """A piece of a round: of the first or the second one of an iteration."""
    plan, scene, work = lent((plan, scene, work))
    if turn % 2 == 0:
        _fly(number, plan, scene, work)
    else:
        _finish(number, plan, scene)
    report(plan.board)


@njit(cache=True, nogil=True, error_model="numpy")
def _share(pieces, plan, scene, work):
    """Offer a round, and take part in it until all of it is done."""
    plan, scene, work = lent((plan, scene, work))
    turn, done = plan.now[TURN], count_done(plan.board) + pieces
    offer(plan.board, turn, pieces)
    number = take_first(plan.board)
    while number != NOTHING:
        _do(turn, number, plan, scene, work)
        number = take_first(plan.board)
    await_done(plan.board, done)
    plan.now[TURN] = turn + 1


@njit(cache=True, nogil=True, error_model="numpy")
def _help(plan, scene, work):
    plan, scene, work = lent((plan, scene, work))
    turn, number = await_last(plan.board)
    while number != NOTHING:
        _do(turn, number, plan, scene, work)
        turn, number = await_last(plan.board)


@njit(cache=True, nogil=True, error_model="numpy")
def spell(leads, plan, scene, first, iterations):
    """Make iterations from ``first`` on; or, as a thread that does not lead, help until the board closes."""
    plan, scene, work = lent((plan, scene, work_space()))
    if not leads:
        _help(plan, scene, work)
        return
    for iteration in range(first, first + iterations):
        plan.now[ITERATION] = iteration
        _share(plan.found.size, plan, scene, work)
        _share(_exchange(plan, scene), plan, scene, work)
