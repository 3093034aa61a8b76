"""Lift-off from anywhere on the bed (Wang & Hu; seed 003, listing 5.2)."""

import math

import numpy as np
from numba import njit

from barchan.kernels.bed.active_layer import amount, nth, set_kind
from barchan.kernels.core.random import draw
from barchan.kernels.grains.slots import launch
from barchan.kernels.grains.state import NOWHERE
from barchan.kernels.grains.surface import nearest_cell, surface_at


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def place(part, size):
    """A coordinate (cells, float32) within the field from a number from 0 to below 1."""
    coordinate = np.float32(part * size)
    return coordinate if coordinate < np.float32(size) else np.float32(size - 0.5)


@njit(cache=True, nogil=True, error_model="numpy")
def _kind_at(mixture, cell, part, creeps):
    """The size of a parcel drawn from a cell's active layer; -1: too heavy."""
    if mixture is None:
        return 0
    kind = nth(mixture.layer, cell, np.int64(part * amount(mixture.layer, cell)))
    return -1 if creeps[kind] else kind


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def lift(slot, start, grains, ground, scale, grid, rule):
    """Let a slot start from a cell drawn at random, if that can give a parcel; the cell, or ``NOWHERE``."""
    if draw(start, 1) >= rule.chance:
        return NOWHERE
    x, y = place(draw(start, 2), grid.cols), place(draw(start, 3), grid.rows)
    cell = nearest_cell(x, y, grid)
    if ground.sand[cell] == 0 or ground.lid[cell] > ground.height[cell]:
        return NOWHERE
    kind = _kind_at(ground.mixture, cell, draw(start, 6), rule.creeps)
    if kind < 0:
        return NOWHERE
    surface, east, north = surface_at(x, y, ground.height, scale.cell_size, grid)
    if not rule.from_lee and east * rule.wind_x + north * rule.wind_y < 0.0:
        return NOWHERE
    angle = rule.flattest + draw(start, 4) * (rule.steepest - rule.flattest)
    up = rule.slowest + draw(start, 5) * (rule.fastest - rule.slowest)
    along = up / math.tan(angle)
    u, v = np.float32(along * rule.wind_x), np.float32(along * rule.wind_y)
    launch(slot, x, y, np.float32(surface), u, v, np.float32(up), grains)
    set_kind(grains.kind, slot, kind)
    return cell
