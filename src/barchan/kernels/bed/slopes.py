"""Avalanches: sand that has become too steep slides down, slab by slab, until it rests.

Taking a slab from a cell lets a slab fall in from the steepest neighbour that now stands too high, and so
on up the slope; laying one down lets it slide to the steepest neighbour that lies too low, and so on down
(Werner 1995). Only the two ends of such a chain change, so a chain is a search for the cell that changes.
"""

from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.bed.state import (
    CLOSED,
    DRAWN,
    EAST,
    NORTH,
    NORTHEAST,
    NORTHWEST,
    SOUTH,
    SOUTHEAST,
    SOUTHWEST,
    STABLE,
    WEST,
)
from barchan.kernels.core.random import below, derive, high


class Hold(NamedTuple):
    """Which steps of one kind hold, on bare and on firm cells."""

    limit: int
    firm_limit: int
    firm_below: int


@njit(cache=True, forceinline=True)
def has_sand(surface, sand, cell):
    """Whether a cell has a slab to give; over flat ground (``sand`` None) the surface counts the slabs."""
    if sand is None:
        return surface[cell] > 0
    return sand[cell] > 0


@njit(cache=True, forceinline=True)
def _sorting_key(surface, sand, mobility, cell, here, sign, code, hold):
    """A number that sorts neighbours by their step from ``here`` and, at equal steps, by their turn."""
    step = (np.int64(surface[cell]) - here) * sign
    if sand is not None:
        if sign > 0 and sand[cell] == 0:
            code = np.int64(CLOSED)
    if mobility is not None:
        if sign > 0 and step <= (hold.firm_limit if mobility[cell] <= hold.firm_below else hold.limit):
            code = np.int64(CLOSED)
    return (step << 6) + code


@njit(cache=True, forceinline=True)
def steepest(surface, sand, mobility, turns, turn, row, col, here, sign, at_rest, grid, repose):
    """The way of the steepest step up (``sign`` 1) or down (-1) from ``here`` that does not hold.

    ``turns[turn]`` holds the neighbours' codes; of equally steep ways the first in turn is taken, a face
    before a corner. The higher cell's limit decides; a step ``at_rest`` must exceed it by the release.
    Returns ``STABLE`` where every step holds.
    """
    face_limit = repose.face_limit + at_rest * repose.release_face
    corner_limit = repose.corner_limit + at_rest * repose.release_corner
    firm_face_limit = repose.firm_face_limit + at_rest * repose.release_face
    firm_corner_limit = repose.firm_corner_limit + at_rest * repose.release_corner
    face_hold = Hold(face_limit, firm_face_limit, repose.firm_below)
    corner_hold = Hold(corner_limit, firm_corner_limit, repose.firm_below)
    if mobility is not None:
        if sign > 0:
            face_limit = min(face_limit, firm_face_limit)
            corner_limit = min(corner_limit, firm_corner_limit)
        elif mobility[np.uint64(row * grid.cols + col)] <= repose.firm_below:
            face_limit = firm_face_limit
            corner_limit = firm_corner_limit
    north = row + 1
    if north == grid.rows:
        north = 0 if grid.wrap_across else row
    south = row - 1
    if south < 0:
        south = grid.rows - 1 if grid.wrap_across else row
    east = col + 1
    if east == grid.cols:
        east = 0 if grid.wrap_along else col
    west = col - 1
    if west < 0:
        west = grid.cols - 1 if grid.wrap_along else col
    n = np.uint64(north * grid.cols)
    s = np.uint64(south * grid.cols)
    level = np.uint64(row * grid.cols)
    e = np.uint64(east)
    w = np.uint64(west)
    c = np.uint64(col)
    face = max(
        max(
            _sorting_key(surface, sand, mobility, n + c, here, sign, turns[turn, NORTH], face_hold),
            _sorting_key(surface, sand, mobility, s + c, here, sign, turns[turn, SOUTH], face_hold),
        ),
        max(
            _sorting_key(surface, sand, mobility, level + e, here, sign, turns[turn, EAST], face_hold),
            _sorting_key(surface, sand, mobility, level + w, here, sign, turns[turn, WEST], face_hold),
        ),
    )
    steep = (face >> 6) > face_limit
    if not repose.corners:
        return face & 7 if steep else STABLE
    itself = level + c
    no_north = row + 1 == grid.rows and not grid.wrap_across
    no_south = row == 0 and not grid.wrap_across
    no_east = col + 1 == grid.cols and not grid.wrap_along
    no_west = col == 0 and not grid.wrap_along
    ne = itself if no_north or no_east else n + e
    nw = itself if no_north or no_west else n + w
    se = itself if no_south or no_east else s + e
    sw = itself if no_south or no_west else s + w
    corner = max(
        max(
            _sorting_key(surface, sand, mobility, ne, here, sign, turns[turn, NORTHEAST], corner_hold),
            _sorting_key(surface, sand, mobility, nw, here, sign, turns[turn, NORTHWEST], corner_hold),
        ),
        max(
            _sorting_key(surface, sand, mobility, se, here, sign, turns[turn, SOUTHEAST], corner_hold),
            _sorting_key(surface, sand, mobility, sw, here, sign, turns[turn, SOUTHWEST], corner_hold),
        ),
    )
    if (corner >> 6) > corner_limit:
        if not steep or (corner >> 6) * repose.corner_weight > (face >> 6):
            return corner & 7
    return face & 7 if steep else STABLE


@njit(cache=True)
def draw_turns(turns, turn, key):
    """Put a random checking sequence into ``turns[DRAWN]``: faces among themselves, corners likewise."""
    for first in range(0, 8, 4):
        for k in range(4):
            turns[DRAWN, first + k] = k
        for last in range(3, 0, -1):
            other = first + below(high(derive(key, first + last)), last + 1)
            mine = turns[DRAWN, first + last]
            turns[DRAWN, first + last] = turns[DRAWN, other]
            turns[DRAWN, other] = mine
        for k in range(first, first + 4):
            code = (7 - first - turns[DRAWN, k]) << 3 | k
            turns[DRAWN, k] = code if turns[turn, k] >= 0 else CLOSED
