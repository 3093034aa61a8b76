"""Creep: impacts push grains along the bed, a short step at a time.

A pushed grain comes to rest where the bed, and its weight on a rising face, have taken the speed that it
started with. The wind along the bed helps it, the more the nearer it is to one that keeps grains going by
itself. Where it is as strong as that a grain goes on until it comes to where the wind is weaker.
"""

import math

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import amount
from barchan.kernels.core.random import draw
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.grains.exchange import lay_down, take_up
from barchan.kernels.grains.state import COUNTS, LEFT, MOVED, TRAVEL_X, TRAVEL_Y
from barchan.kernels.grains.surface import surface_at

MOST_PUSHES = 16
"""Parcels of one size that an impact pushes at most."""

FARTHEST = 16
"""Cells that the wind keeps a pushed grain going at most."""

CREEP_DRAWS, DRAWS_PER_SIZE = 80, 64
"""Where in a slot's sequence the draws of creep begin, and how many each size may take."""

STRIDE = 1024
"""Draws between those of a way's cells."""

_LEAST = 1e-9
"""Cells; below it a way is none."""


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


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def wind_along_bed(creep, cell, ground):
    """Friction velocity (m/s) of the wind along the bed at a cell: none in shelter."""
    return 0.0 if ground.lid[cell] > ground.height[cell] + creep.shelter else ground.bed_wind[cell]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def along_stress(creep, cell, ground):
    """Where the stress on the bed at a cell points: 1 along the wind, and a part to the left."""
    left = ground.bed_turn[cell]
    return creep.wind_x - left * creep.wind_y, creep.wind_y + left * creep.wind_x


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def pushed_way(x, y, east, north, friction, help_x, help_y, reach):
    """How far (cells) a push along (x, y) takes a grain: until the bed, slope and wind have stopped it.

    Slopes and the wind's ``help`` are shares of its weight; what is across its way turns it.
    """
    force_x, force_y = help_x - east, help_y - north
    along = x * force_x + y * force_y
    stopping = max(friction - along, reach)
    length = reach / stopping
    return length * (x + (force_x - along * x) / stopping), length * (y + (force_y - along * y) / stopping)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _move(cell, kind, way_x, way_y, start, at, creep, ground, scale, grid, counts):
    """Move a grain's sand on until the wind stops it, or out of the field, if there is enough of its size."""
    if not take_up(cell, kind, ground, scale, grid):
        return
    counts[MOVED] += 1
    for step in range(1, FARTHEST + 1):
        row, inside_y = _step(cell // grid.cols, way_y, grid.rows, grid.wrap_across)
        col, inside_x = _step(cell % grid.cols, way_x, grid.cols, grid.wrap_along)
        counts[TRAVEL_X] += way_x * TRAVEL_UNIT
        counts[TRAVEL_Y] += way_y * TRAVEL_UNIT
        if not (inside_x and inside_y):
            counts[LEFT] += 1
            counts[COUNTS + kind] += 1
            return
        cell = row * grid.cols + col
        if wind_along_bed(creep, cell, ground) <= creep.threshold[kind]:
            break
        x, y = along_stress(creep, cell, ground)
        longest = max(abs(x), abs(y))
        way_x = _whole(x / longest, draw(start, at + step * STRIDE))
        way_y = _whole(y / longest, draw(start, at + step * STRIDE + 1))
    lay_down(cell, kind, ground, scale, grid)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _share(mixture, kind, cell):
    """The part of the sand at the surface of a cell that is of a size; 0 where there is none."""
    if mixture is None:
        return 1.0
    held = amount(mixture.layer, cell)
    return mixture.layer[kind, cell] / held if held > 0 else 0.0


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def push(creep, k, cell, ground, scale, grid, events, counts):
    """Push sand along where the impact of entry ``k`` hit the bed.

    Sand moves by whole cells, so there are fewer pushes than grains, by as much as their way is shorter.
    """
    u, v, start = events.u[k], events.v[k], events.start[k]
    speed = math.sqrt(u * u + v * v)
    if speed == 0.0:
        return
    _, east, north = surface_at(events.x[k], events.y[k], ground.height, scale.cell_size, grid)
    wind = wind_along_bed(creep, cell, ground)
    wind_x, wind_y = along_stress(creep, cell, ground)
    for kind in range(creep.number.size):
        carried = min(wind / creep.threshold[kind], 1.0)
        helped = creep.friction * carried * carried
        way_x, way_y = pushed_way(
            *(u / speed, v / speed, east, north),
            *(creep.friction, helped * wind_x, helped * wind_y, creep.reach[kind]),
        )
        longest = max(min(max(abs(way_x), abs(way_y)), 1.0), _LEAST)
        at = CREEP_DRAWS + kind * DRAWS_PER_SIZE
        number = creep.number[kind] * events.impact[k] * _share(ground.mixture, kind, cell) * longest
        for one in range(min(np.int64(number + draw(start, at)), MOST_PUSHES)):
            draws = at + 1 + 2 * one
            step_x = _whole(way_x / longest, draw(start, draws))
            step_y = _whole(way_y / longest, draw(start, draws + 1))
            if step_x != 0 or step_y != 0:
                _move(cell, kind, step_x, step_y, start, draws, creep, ground, scale, grid, counts)
