"""Aerodynamic entrainment: the wind lifts grains from anywhere on the bed (Szabó 2019, listing 5.2)."""

import math

import numpy as np

from barchan.kernels.bed.active_layer import class_of_parcel, parcels_of, set_class
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import draw
from barchan.kernels.grains.bonds import movable, wind_breaks
from barchan.kernels.grains.pool import launch
from barchan.kernels.grains.state import NOWHERE
from barchan.kernels.grains.surface import nearest_cell, surface_at


@internal(error_model="numpy", forceinline=True)
def place(part, size):
    """A coordinate (cells, float32) within the field from a number from 0 to below 1."""
    coordinate = np.float32(part * size)
    return coordinate if coordinate < np.float32(size) else np.float32(size - 0.5)


@internal(error_model="numpy")
def _random_class(layer, cell, part, creeps):
    """Size class of a random parcel of a cell's active layer; -1: too heavy."""
    if layer is None:
        return 0
    size_class = class_of_parcel(layer.surface, cell, np.int64(part * parcels_of(layer.surface, cell)))
    return -1 if creeps[size_class] else size_class


@internal(error_model="numpy", forceinline=True)
def entrain(slot, start, grains, ground, rule):
    """Launch a grain in a slot from a random cell, if that can give a parcel; the cell, or ``NOWHERE``."""
    if draw(start, 1) >= rule.probability:
        return NOWHERE
    grid = ground.grid
    x, y = place(draw(start, 2), grid.cols), place(draw(start, 3), grid.rows)
    cell = nearest_cell(x, y, grid)
    if movable(ground.bonds, ground.sand, cell, wind_breaks(ground.bonds)) == 0:
        return NOWHERE
    if ground.shelter_surface[cell] > ground.height[cell]:
        return NOWHERE
    size_class = _random_class(ground.active_layer, cell, draw(start, 6), rule.creeps)
    if size_class < 0:
        return NOWHERE
    surface, east, north = surface_at(x, y, ground)
    if not rule.from_lee and east * rule.wind_x + north * rule.wind_y < 0.0:
        return NOWHERE
    angle = rule.min_angle + draw(start, 4) * (rule.max_angle - rule.min_angle)
    up = rule.min_speed + draw(start, 5) * (rule.max_speed - rule.min_speed)
    along = up / math.tan(angle)
    velocity = np.float32(along * rule.wind_x), np.float32(along * rule.wind_y), np.float32(up)
    launch(slot, x, y, np.float32(surface), velocity, grains)
    set_class(grains.size_class, slot, size_class)
    return cell
