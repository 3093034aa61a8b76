"""A batch of iterations: all grains fly, land, change the bed and start, again and again, in one call.

Several threads may make it together, one of which leads (``board``). They share pieces of the slots, let them
fly and land; then the exchange of sand, each in a territory, of which one thread does the rest; then the
ejecta to be launched and the rows of the mesh to be renewed. No piece depends on another one of its round or
on who does it, so the bits are the same for any number of threads.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import reseed
from barchan.kernels.core import work_queue
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import derive
from barchan.kernels.core.work_queue import NOTHING, await_done, pop_front, publish, task_done, wait_pop_back
from barchan.kernels.grains.entries import count_free, exchange, give_places, launch_from_free, list_impacts
from barchan.kernels.grains.flight import move_blocks
from barchan.kernels.grains.landing import land
from barchan.kernels.grains.reach import Ways, find_reach
from barchan.kernels.grains.splash import throw
from barchan.kernels.grains.state import FLOWN, Scene
from barchan.kernels.grains.surface import renew_stale
from barchan.kernels.grains.territories import ALONE, PUT_OFF, Territories, forget_put_off, territories_of

MOST_BEYOND = 0.1
"""Share of impacts that may reach beyond a territory, up to which territories pay: later ones that meet those
are put off too."""

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
    first: int
    """The first iteration."""
    board: np.ndarray
    found: np.ndarray
    """Entries of each piece."""
    progress: np.ndarray
    """See ``ITERATION``."""
    territories: Territories


ITERATION, ROUND, OFFERED, THROWN, HITS, SHARED = range(6)
"""Entries of the progress: the iteration; the round since the start; pieces offered since then; places of
ejecta, then ejecta, of this iteration; its impacts; and whether territories share its exchange of sand."""

FLIGHT, EXCHANGE, REST, FINISH = range(4)
"""The rounds of an iteration: flight, the exchange of sand, what territories put off, and what follows."""

ROUNDS = 4


def plan_of(key: int, slots: int, first: int, territories: Territories) -> Plan:
    """A plan for some slots under a stream's key, from iteration ``first`` on."""
    piece = PIECE
    while slots > piece * work_queue.MOST_PIECES:
        piece *= 2
    found, progress = np.zeros(-(-slots // piece), np.int64), np.array([first - 1, -1, 0, 0, 0, 0])
    return Plan(np.uint64(key), slots, piece, first, work_queue.new_board(), found, progress, territories)


def divided(scene: Scene, threads: int) -> Territories:
    """The territories in which threads exchange a scene's sand.

    There is only one where impacts reach so far that too many would have to be put off.
    """
    grid, splash = scene.ground.grid, scene.rules.splash
    slots, counts = scene.landings.slot.size, scene.counts.size
    territories = territories_of(grid, threads, slots, counts)
    if splash is None or not territories.reach.size:
        return territories
    ways = Ways(*np.zeros((len(Ways._fields), territories.reach.size), np.uint8))
    find_reach(splash.creep, scene.ground, ways, territories.reach)
    width = max(grid.rows, grid.cols) / territories.marks.shape[0]
    beyond = 2.0 * float(territories.reach.mean()) / width
    return territories if beyond <= MOST_BEYOND else territories_of(grid, 1, slots, counts)


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
def _exchange(number, rest, plan, scene):
    """Exchange the sand of a territory, or of all; or do the ``rest`` that territories put off."""
    part = ALONE
    if plan.progress[SHARED]:
        part = plan.territories.marks.shape[0] if rest else number
    hits, stamp = plan.progress[HITS], np.int32(plan.progress[ITERATION] - plan.first + 1)
    places = exchange(part, stamp, plan.found, plan.piece, hits, scene.rules.splash, scene, plan.territories)
    if part == ALONE:
        plan.progress[THROWN] = places


@internal(error_model="numpy")
def _open_exchange(plan, scene):
    """Prepare the exchange of sand; the number of its pieces."""
    grains, landings, ejecta, progress = scene.grains, scene.landings, scene.ejecta, plan.progress
    layer, splash, parts = scene.ground.active_layer, scene.rules.splash, plan.territories.marks.shape[0]
    reseed(layer, derive(derive(plan.key, progress[ITERATION]), plan.slots))
    progress[HITS] = list_impacts(plan.found, plan.piece, landings, ejecta)
    progress[SHARED] = 0
    if parts > 1 and layer is None:
        free = count_free(plan.found, plan.piece, landings.slot, grains.status)
        places = give_places(progress[HITS], free, splash, landings, ejecta)
        progress[SHARED], progress[THROWN] = places >= 0, places
    if not progress[SHARED]:
        return 1
    for number in range(plan.found.size):
        forget_put_off(number * plan.piece, plan.found[number], plan.territories)
    return parts


@internal(error_model="numpy")
def _rest(plan):
    """The number of pieces of what territories put off: one, if there is anything."""
    return min(plan.territories.marks[:, PUT_OFF].sum(), 1) if plan.progress[SHARED] else 0


@internal(error_model="numpy")
def _close_exchange(plan, scene):
    """Give ejecta their slots and add up counts; the number of pieces of what follows."""
    counts, by_part = scene.counts, plan.territories.counts
    for part in range(by_part.shape[0]):
        for at in range(counts.size):
            counts[at] += by_part[part, at]
        by_part[part] = 0
    counts[FLOWN] += plan.slots
    thrown = launch_from_free(
        plan.found, plan.piece, plan.progress[THROWN], scene.grains, scene.landings, scene.ejecta
    )
    plan.progress[THROWN] = thrown
    grid = scene.ground.grid
    return _pieces(thrown, _EJECTA) + _pieces(grid.rows, _rows(grid))


@internal(error_model="numpy")
def _pieces(count, size):
    return (count + size - 1) // size


@internal(error_model="numpy")
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
    following = (done + 1) % ROUNDS
    if following == FLIGHT:
        if plan.progress[ITERATION] + 1 == end:
            return NOTHING
        plan.progress[ITERATION] += 1
        pieces = plan.found.size
    elif following == EXCHANGE:
        pieces = _open_exchange(plan, scene)
    elif following == REST:
        pieces = _rest(plan)
    else:
        pieces = _close_exchange(plan, scene)
    plan.progress[ROUND] = done + 1
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
        kind = this_round % ROUNDS
        if kind == FLIGHT:
            _fly(number, plan, scene, work)
        elif kind == FINISH:
            _finish(number, plan, scene)
        else:
            _exchange(number, kind == REST, plan, scene)
        task_done(plan.board)
