"""Creep: impacts push grains along the bed, a short step at a time.

A pushed grain comes to rest where the bed, and its weight on a rising face, have taken the speed that it
started with. The wind along the bed helps it, the more the nearer it is to one that keeps grains going by
itself. Where it is as strong as that a grain goes on until it comes to where the wind is weaker.
"""

import math

import numpy as np

from barchan.kernels.bed.active_layer import parcels_of
from barchan.kernels.core.internal import internal, woven
from barchan.kernels.core.random import draw
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.grains.bonds import impact_breaks
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
"""Draws between those of one cell of a displacement and the next."""

_BOND_DRAW = (FARTHEST + 1) * STRIDE
"""Draw, from those of a push on, that decides whether it breaks bonds."""

_LEAST = 1e-9
"""Displacements shorter than this (cells) are treated as zero."""


@internal(error_model="numpy", forceinline=True)
def place_beside(place, step, size, wrap):
    """The row or column a ``step`` away, and whether that is within the field."""
    there = place + step
    if 0 <= there < size:
        return there, True
    return (there + size if there < 0 else there - size), wrap


@internal(error_model="numpy", forceinline=True)
def _whole(part, chance):
    """1 in the direction of ``part`` with a probability as large as that, up to 1; else 0."""
    if chance >= abs(part):
        return 0
    return 1 if part > 0.0 else -1


@internal(error_model="numpy", forceinline=True)
def wind_along_bed(creep, cell, ground):
    """Friction velocity (m/s) of the wind along the bed at a cell: none in shelter."""
    if ground.shelter_surface[cell] > ground.height[cell] + creep.shelter:
        return 0.0
    return ground.bed_stress.ustar[cell]


@internal(error_model="numpy", forceinline=True)
def along_stress(creep, cell, ground):
    """Direction of the stress on the bed at a cell: 1 along the wind, and a part to the left."""
    left = ground.bed_stress.deflection[cell]
    return creep.wind_x - left * creep.wind_y, creep.wind_y + left * creep.wind_x


@internal(error_model="numpy", forceinline=True)
def displacement(toward, slope, friction, help_x, help_y, reach):
    """Displacement (cells) of a grain pushed ``toward`` a unit vector, until bed, slope and wind stop it.

    Slopes and the wind's ``help`` are shares of the grain's weight; force across its path turns it.
    """
    x, y = toward
    force_x, force_y = help_x - slope[0], help_y - slope[1]
    along = x * force_x + y * force_y
    stopping = max(friction - along, reach)
    length = reach / stopping
    return length * (x + (force_x - along * x) / stopping), length * (y + (force_y - along * y) / stopping)


@woven(error_model="numpy")
def _move(row, col, size_class, step, draws, creep, ground, counts):
    """Move a grain's sand on until it stops, or out of the field, if the cell has enough of its size.

    ``step`` is the first step (columns, rows); ``draws`` are the start of the impact's random numbers and
    the number of the first of this grain.
    """
    grid, start, at = ground.grid, draws[0], draws[1]
    if not take_up(row, col, size_class, ground, impact_breaks(ground.bonds, start, at + _BOND_DRAW)):
        return
    step_x, step_y = step
    counts[MOVED] += 1
    for count in range(1, FARTHEST + 1):
        row, inside_y = place_beside(row, step_y, grid.rows, grid.wrap_across)
        col, inside_x = place_beside(col, step_x, grid.cols, grid.wrap_along)
        counts[TRAVEL_X] += step_x * TRAVEL_UNIT
        counts[TRAVEL_Y] += step_y * TRAVEL_UNIT
        if not (inside_x and inside_y):
            counts[LEFT] += 1
            counts[COUNTS + size_class] += 1
            return
        cell = row * grid.cols + col
        if wind_along_bed(creep, cell, ground) <= creep.threshold[size_class]:
            break
        x, y = along_stress(creep, cell, ground)
        longest = max(abs(x), abs(y))
        step_x = _whole(x / longest, draw(start, at + count * STRIDE))
        step_y = _whole(y / longest, draw(start, at + count * STRIDE + 1))
    lay_down(row, col, size_class, ground)


@internal(error_model="numpy", forceinline=True)
def _share(layer, size_class, cell):
    """Share of a size class in the active layer of a cell; 0 where there is no sand."""
    if layer is None:
        return 1.0
    held = parcels_of(layer.surface, cell)
    return layer.surface[size_class, cell] / held if held > 0 else 0.0


@internal(error_model="numpy", forceinline=True)
def push(creep, k, row, col, ground, landings, counts):
    """Push sand along where the impact of entry ``k`` hit the bed; nothing without ``creep``.

    Sand moves by whole cells, so there are fewer pushes than grains, by the factor by which displacements
    are shorter than a cell.
    """
    if creep is None:
        return
    cell = row * ground.grid.cols + col
    u, v, start = landings.u[k], landings.v[k], landings.start[k]
    speed = math.sqrt(u * u + v * v)
    if speed == 0.0:
        return
    _, east, north = surface_at(landings.x[k], landings.y[k], ground)
    wind = wind_along_bed(creep, cell, ground)
    wind_x, wind_y = along_stress(creep, cell, ground)
    toward, slope, friction = (u / speed, v / speed), (east, north), creep.friction
    for size_class in range(creep.number.size):
        carried = min(wind / creep.threshold[size_class], 1.0)
        helped = friction * carried * carried
        reach = creep.reach[size_class]
        x, y = displacement(toward, slope, friction, helped * wind_x, helped * wind_y, reach)
        longest = max(min(max(abs(x), abs(y)), 1.0), _LEAST)
        at = CREEP_DRAWS + size_class * DRAWS_PER_SIZE
        share = _share(ground.active_layer, size_class, cell)
        number = creep.number[size_class] * landings.impact_speed[k] * share * longest
        for one in range(min(np.int64(number + draw(start, at)), MOST_PUSHES)):
            draws = at + 1 + 2 * one
            step_x = _whole(x / longest, draw(start, draws))
            step_y = _whole(y / longest, draw(start, draws + 1))
            if step_x != 0 or step_y != 0:
                _move(row, col, size_class, (step_x, step_y), (start, draws), creep, ground, counts)
