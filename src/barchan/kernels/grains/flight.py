"""Grains in flight: gravity and drag in a wind, many grains at a time.

All grains take the same time step. A pass over a block of grains does one thing, so that the compiler
turns it into vector instructions; wind and drag are read from tables by the leading bits of a number,
so that no logarithm and no root is taken in flight. Loops go over slices of a block: of a sum of two numbers
the compiler does not know that it is not negative, and an index that may count from the end it reads alone.
"""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal
from barchan.kernels.grains.surface import mesh_cell
from barchan.kernels.grains.wind import enter_stream, entry, find_climb, find_wind, leave_stream, speed_up

BLOCK = 256
"""Grains that pass through the loops together: their work space stays in the fastest cache."""


_NONE = np.int32(0)
OUTSIDE = np.int32(-1)
_ZERO = np.float32(0.0)


@internal(error_model="numpy", forceinline=True)
def _to_class_tables(start, count, size_class, size, cell):
    """Move entries ``cell`` of the first of several tables to the table of each grain's size class."""
    if size_class is not None:
        part = size_class[start : start + count]
        for j in range(count):
            cell[j] += part[j] * size


@internal(error_model="numpy")
def _find_drag(start, count, grains, air, wind, cell, share):
    """Put the share of the velocity difference that drag takes away into ``share``."""
    end = start + count
    first, last = air.drag.first, air.drag.last
    u, v, w = grains.u[start:end], grains.v[start:end], grains.w[start:end]
    wind_x, wind_y, early_fall = air.wind_x, air.wind_y, air.early_fall
    for j in range(count):
        lag_x = wind[j] * wind_x - u[j]
        lag_y = wind[j] * wind_y - v[j]
        fall = w[j] - early_fall
        cell[j] = entry(lag_x * lag_x + lag_y * lag_y + fall * fall, first, last)
    _to_class_tables(start, count, grains.size_class, last + np.int32(1), cell)
    for j in range(count):
        share[j] = air.drag.values[np.uint64(cell[j])]


@internal(error_model="numpy", forceinline=True)
def _push_along(count, place, velocity, part, wind, share, air):
    """Move a block of grains by one time step along one axis, of which the wind has its ``part``."""
    before, after = air.before, air.after
    for j in range(count):
        old = velocity[j]
        new = old + share[j] * (wind[j] * part - old)
        place[j] += before * old + after * new
        velocity[j] = new


@internal(error_model="numpy", forceinline=True)
def _push_up(count, z, w, share, air):
    """Move a block of grains by one time step upwards."""
    fall, early_fall = air.fall, air.early_fall
    before, after = air.rise_before, air.rise_after
    for j in range(count):
        old = w[j]
        new = old - share[j] * (old - early_fall) - fall
        z[j] += before * old + after * new
        w[j] = new


@internal(error_model="numpy")
def _push(start, count, grains, air, wind, share):
    """Move a block of grains by one time step.

    One axis after the other: a loop that writes to more arrays would not become vector instructions, for
    the compiler asks first whether any two of them overlap, and asks only so often.
    """
    end = start + count
    _push_along(count, grains.x[start:end], grains.u[start:end], air.wind_x, wind, share, air)
    _push_along(count, grains.y[start:end], grains.v[start:end], air.wind_y, wind, share, air)
    _push_up(count, grains.z[start:end], grains.w[start:end], share, air)


@internal(error_model="numpy")
def _find_low(start, count, grains, grid, top, cell, value):
    """Put into ``cell`` whether (1 or 0) a grain is outside the field or below the top of its mesh cell."""
    end = start + count
    x, y, z = grains.x[start:end], grains.y[start:end], grains.z[start:end]
    east, north = np.float32(grid.cols), np.float32(grid.rows)
    for j in range(count):
        inside = (x[j] >= _ZERO) & (x[j] < east) & (y[j] >= _ZERO) & (y[j] < north)
        cell[j] = mesh_cell(x[j], y[j], grid.cols) if inside else OUTSIDE
    for j in range(count):
        value[j] = top[np.uint64(max(cell[j], _NONE))]
    for j in range(count):
        cell[j] = (cell[j] == OUTSIDE) | (z[j] < value[j])


@njit(cache=True, nogil=True, error_model="numpy")
def work_space():
    """Work space of a thread that moves grains block by block."""
    cell = np.empty(BLOCK, np.int32)
    wind = np.empty(BLOCK, np.float32)
    share = np.empty(BLOCK, np.float32)
    climb = np.empty(BLOCK, np.float32)
    sideways = np.empty(BLOCK, np.float32)
    return cell, wind, share, climb, sideways


@internal(error_model="numpy")
def move_blocks(first, last, grains, air, ground, candidates, work):
    """Move the slots from ``first`` to before ``last`` by one time step.

    Writes those that left the field or lie below the highest corner of their mesh cell into ``candidates``,
    from ``first`` on, and returns their number. ``land`` handles them.
    """
    cell, wind, share, climb, sideways = work
    cols, flow = ground.grid.cols, ground.flow
    found = first
    for start in range(first, last, BLOCK):
        count = min(last - start, BLOCK)
        block = start, count
        find_wind(start, count, grains, air, ground, cell, wind, share)
        speed_up(block, grains, flow, cols, wind, cell, sideways)
        find_climb(block, grains, flow, cols, wind, cell, climb)
        enter_stream(block, flow, air, grains, climb, sideways)
        _find_drag(start, count, grains, air, wind, cell, share)
        _push(start, count, grains, air, wind, share)
        leave_stream(block, flow, air, grains, climb, sideways)
        _find_low(start, count, grains, ground.grid, ground.top, cell, share)
        for j in range(count):
            # written whether it counts or not: the processor would mispredict a branch here again and again
            candidates[found] = start + j
            found += cell[j]
    return found - first


@njit(cache=True, nogil=True, error_model="numpy")
def move(first, last, grains, air, ground, candidates):
    """Move slots by one time step with work space of its own; see ``move_blocks``."""
    grains, air, ground, candidates = borrowed((grains, air, ground, candidates))
    return move_blocks(first, last, grains, air, ground, candidates, work_space())
