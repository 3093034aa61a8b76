"""Creep: grains too heavy to be thrown out are pushed along the bed by impacts, a short step at a time."""

import math
from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.grain_bed import COUNTS, LEFT, MOVED, TRAVEL_X, TRAVEL_Y, lay_down, take_up
from barchan.kernels.grain_state import TRAVEL_UNIT, draw
from barchan.kernels.grain_surface import surface_at
from barchan.kernels.mixture import amount

MOST_PUSHES = 8
"""Parcels of one size that an impact pushes at most."""

CREEP_DRAWS, DRAWS_PER_SIZE = 80, 32
"""Where in a slot's sequence the draws of creep begin, and how many each size may take."""


class Creep(NamedTuple):
    """How sizes that do not fly are pushed."""

    number: np.ndarray
    """By size: parcels pushed on by a cell for each m/s of an impact on such sand alone; 0: it flies."""
    friction: float
    """Slope (rise over run) that brings a pushed grain to a stop at once."""


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _step(place, way, size, wrap):
    """The row or column one step along ``way``, and whether that is within the field."""
    there = place + way
    if 0 <= there < size:
        return there, True
    return (there + size if there < 0 else there - size), wrap


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _whole(part, chance):
    """1 in the direction of ``part`` with a probability as large as that, up to 1; else 0."""
    if chance >= abs(part):
        return 0
    return 1 if part > 0.0 else -1


@njit(cache=True, nogil=True, error_model="numpy")
def _move(cell, kind, way_x, way_y, ground, scale, grid, counts):
    """Move a grain's sand to the next cell, or out of the field, where there is enough of its size."""
    row, inside_y = _step(cell // grid.cols, way_y, grid.rows, grid.wrap_across)
    col, inside_x = _step(cell % grid.cols, way_x, grid.cols, grid.wrap_along)
    if not take_up(cell, kind, ground, scale, grid):
        return
    counts[MOVED] += 1
    counts[TRAVEL_X] += way_x * TRAVEL_UNIT
    counts[TRAVEL_Y] += way_y * TRAVEL_UNIT
    if inside_x and inside_y:
        lay_down(row * grid.cols + col, kind, ground, scale, grid)
    else:
        counts[LEFT] += 1
        counts[COUNTS + kind] += 1


@njit(cache=True, nogil=True, error_model="numpy")
def push(creep, k, cell, ground, scale, grid, events, counts):
    """Push sand that creeps where the impact of entry ``k`` hit the bed: along its way, and downslope."""
    if creep is not None:
        u, v, start = events.u[k], events.v[k], events.start[k]
        length = math.sqrt(u * u + v * v)
        if length == 0.0:
            return
        _, east, north = surface_at(events.x[k], events.y[k], ground.height, scale.cell_size, grid)
        part_x, part_y = u / length - east / creep.friction, v / length - north / creep.friction
        for kind in range(creep.number.size):
            held = amount(ground.mixture.layer, cell)
            if creep.number[kind] == 0.0 or held == 0:
                continue
            at = CREEP_DRAWS + kind * DRAWS_PER_SIZE
            share = ground.mixture.layer[kind, cell] / held
            number = creep.number[kind] * events.impact[k] * share + draw(start, at)
            for one in range(min(np.int64(number), MOST_PUSHES)):
                way_x = _whole(part_x, draw(start, at + 1 + 2 * one))
                way_y = _whole(part_y, draw(start, at + 2 + 2 * one))
                if way_x != 0 or way_y != 0:
                    _move(cell, kind, way_x, way_y, ground, scale, grid, counts)
