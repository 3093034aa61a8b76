"""What the entries of an iteration do with sand: deposits, lifts, impacts, in their order.

First all grains that came to rest lay down their sand and lifted ones take theirs, entry by entry; then
impacts throw out and push sand. Threads share both by territories.
"""

import numpy as np

from barchan.kernels.bed.active_layer import set_class
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal, woven
from barchan.kernels.grains import territories as territory
from barchan.kernels.grains.bonds import wind_breaks
from barchan.kernels.grains.exchange import deposit, end_travel, lift
from barchan.kernels.grains.splash import ejecta_of, impact
from barchan.kernels.grains.state import FREE, NOWHERE, OUT
from barchan.kernels.grains.surface import nearest_stack, stack_at
from barchan.kernels.grains.territories import ALONE, DEPOSIT, IMPACT, KINDS, LIFT, STEP_REACH, is_mine


@internal(error_model="numpy")
def count_free(found, piece, slots, status):
    """Free slots of the entries, whose ``slots`` have a status; of each piece there are ``found`` entries."""
    found, slots, status = borrowed((found, slots, status))
    free = 0
    for number in range(found.size):
        for k in range(number * piece, number * piece + found[number]):
            free += slots[k] >= 0 and status[slots[k]] == FREE
    return free


@internal(error_model="numpy")
def list_impacts(found, piece, landings, ejecta):
    """List the entries of all pieces that are impacts; their number."""
    found, landings, ejecta = borrowed((found, landings, ejecta))
    hits = 0
    for number in range(found.size):
        for k in range(number * piece, number * piece + found[number]):
            ejecta.hits[hits] = k
            hits += landings.impact_speed[k] != 0.0
    return hits


@internal(error_model="numpy")
def give_places(hits, free, rule, landings, ejecta):
    """Give each impact places for the ejecta that it may throw out; their number.

    -1 where there may be more than ``free`` slots for them: then which of them finds one is known only once
    all before it are thrown out. So it is in sand of several sizes, whose mixture says how many there are.
    Without a ``rule`` for splash there are none.
    """
    if rule is None:
        return 0
    if rule.by_size is not None:
        return -1
    rule, landings, ejecta = borrowed((rule, landings, ejecta))
    places = 0
    for at in range(hits):
        ejecta.place[at] = places
        places += ejecta_of(ejecta.hits[at], 1.0, rule, landings)
    ejecta.place[hits] = places
    return places if places <= free else -1


@internal(error_model="numpy")
def launch_from_free(found, piece, places, grains, landings, ejecta):
    """Move ejecta up to the first places and give them free slots, in the order of entries; their number."""
    found, grains, landings, ejecta = borrowed((found, grains, landings, ejecta))
    taken = at = 0
    for number in range(found.size):
        for k in range(number * piece, number * piece + found[number]):
            slot = landings.slot[k]
            if slot < 0 or grains.status[slot] != FREE:
                continue
            while at < places and ejecta.entry[at] == NOWHERE:
                at += 1
            if at == places:
                return taken
            ejecta.entry[taken], ejecta.number[taken] = ejecta.entry[at], ejecta.number[at]
            ejecta.surface[taken] = ejecta.surface[at]
            ejecta.east[taken], ejecta.north[taken] = ejecta.east[at], ejecta.north[at]
            ejecta.slot[taken] = slot
            set_class(grains.size_class, slot, ejecta.size_class[at])
            taken += 1
            at += 1
    return taken


@woven(error_model="numpy")
def _exchange_lifted(part, stamp, found, piece, scene, territories, counts):
    """Lay down the sand of grains that came to rest, and take that of those lifted, as far as is mine."""
    grains, ground, landings = scene.grains, scene.ground, scene.landings
    grid, breaks, reach = ground.grid, wind_breaks(ground.bonds), np.int64(STEP_REACH)
    for number in range(found.size):
        for k in range(number * piece, number * piece + found[number]):
            if landings.deposit_cell[k] == OUT and part <= 0:
                end_travel(k, landings, counts)
            if landings.deposit_cell[k] >= 0:
                row, col = stack_at(landings.deposit_cell[k], grid)
                if is_mine(k * KINDS + DEPOSIT, row, col, reach, part, stamp, grid, territories):
                    deposit(k, row, col, ground, landings, counts)
            if landings.lift_cell[k] != NOWHERE:
                row, col = stack_at(landings.lift_cell[k], grid)
                if is_mine(k * KINDS + LIFT, row, col, reach, part, stamp, grid, territories):
                    lift(k, row, col, breaks, grains, ground, landings, counts)


@woven(error_model="numpy")
def _splash(part, stamp, hits, free, rule, scene, territories, counts):
    """Throw out and push sand where impacts are mine; places of ejecta that are used alone.

    ``free`` is the number of slots left for them.
    """
    ground, landings, ejecta, grid = scene.ground, scene.landings, scene.ejecta, scene.ground.grid
    places = np.int64(0)
    for at in range(hits):
        k = ejecta.hits[at]
        row, col = nearest_stack(landings.x[k], landings.y[k], grid)
        mine = places, free
        if part != ALONE:
            reach = np.int64(territories.reach[row * grid.cols + col])
            if not is_mine(k * KINDS + IMPACT, row, col, reach, part, stamp, grid, territories):
                continue
            mine = ejecta.place[at], ejecta.place[at + 1]
        used = impact(k, row, col, mine, ground, rule, landings, ejecta, counts)
        if part == ALONE:
            places = used
        else:
            ejecta.entry[used : mine[1]] = NOWHERE
    return places


@internal(error_model="numpy")
def exchange(part, stamp, found, piece, hits, rule, scene, territories):
    """Do what the entries of all pieces do with sand, as far as it is a part's; see ``is_mine``.

    Returns the number of ejecta where that is ``ALONE``; else each has its place. Without a ``rule`` for
    splash there are none.
    """
    found, scene, territories = borrowed((found, scene, territories))
    counts = territories.counts[part]
    if ALONE < part < territories.marks.shape[0]:
        territory.enter(part, territories)
    _exchange_lifted(part, stamp, found, piece, scene, territories, counts)
    if rule is None:
        return np.int64(0)
    free = np.int64(0)
    if part == ALONE:
        free = count_free(found, piece, scene.landings.slot, scene.grains.status)
    return _splash(part, stamp, hits, free, rule, scene, territories, counts)
