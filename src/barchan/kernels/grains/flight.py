"""Grains in flight: gravity and drag in a wind that is looked up, many grains at a time.

All grains take the same time step. A pass over a block of grains does one thing, so that the compiler
turns it into vector instructions; wind and drag are read from tables by the leading bits of a number,
so that no logarithm and no root is taken in flight. Loops go over slices of a block: of a sum of two numbers
the compiler does not know that it is not negative, and an index that may count from the end it reads alone.
"""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import lent
from barchan.kernels.grains.state import TABLE_SHIFT
from barchan.kernels.grains.surface import mesh_cell

BLOCK = 256
"""Grains that pass through the loops together: their work space stays in the fastest cache."""


_SHIFT = np.int32(TABLE_SHIFT)
_NONE = np.int32(0)
OUTSIDE = np.int32(-1)
_ZERO = np.float32(0.0)
_PLUS, _MINUS = np.float32(1.0), np.float32(-1.0)


@njit(cache=True, nogil=True, error_model="numpy")
def entry(number, first, last):
    """The table's entry for a number: its leading bits, within the table."""
    return min(max((np.float32(number).view(np.int32) - first) >> _SHIFT, _NONE), last)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _find_mesh(start, count, grains, cols, cell):
    """Put the mesh cell below each grain of a block into ``cell``."""
    x, y = grains.x[start : start + count], grains.y[start : start + count]
    for j in range(count):
        cell[j] = mesh_cell(x[j], y[j], cols)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _find_near_bed(count, feedback, cell, ustar):
    """Put the near-bed friction velocity at each grain of a block into ``ustar``, if it varies in space."""
    if feedback is not None:
        near_bed = feedback.near_bed_ustar
        for j in range(count):
            ustar[j] = near_bed[np.uint64(cell[j])]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _slow_wind(count, feedback, above, cell, ustar, value):
    """Make wind speeds of those for a near-bed friction velocity of 1 m/s, if it varies in space."""
    if feedback is not None:
        for j in range(count):
            value[j] = ustar[j] * value[j] + above.values[np.uint64(cell[j])]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _speed_up_by(speedup, block, grains, cols, wind, cell, sideways):
    if speedup is not None:
        start, count = block
        factor, crosswind_ratio = speedup.factor, speedup.crosswind_ratio
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            wind[j] *= factor[np.uint64(cell[j])]
            sideways[j] = crosswind_ratio[np.uint64(cell[j])] * wind[j]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _speed_up(block, grains, flow, cols, wind, cell, sideways):
    """Speed the wind up over waves, and find how fast it blows to the left, if it does."""
    if flow is not None:
        _speed_up_by(flow.speedup, block, grains, cols, wind, cell, sideways)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _find_climb(block, grains, flow, cols, wind, cell, climb):
    """Find how fast the air rises at each grain of a block, if it follows the bed."""
    if flow is not None:
        start, count = block
        slope = flow.streamline_slope
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            climb[j] = slope[np.uint64(cell[j])] * wind[j]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _shift(count, numbers, part, by):
    for j in range(count):
        numbers[j] += part * by[j]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _enter_crosswind(block, speedup, air, grains, sideways):
    if speedup is not None:
        start, count = block
        end = start + count
        _shift(count, grains.u[start:end], air.wind_y, sideways)
        _shift(count, grains.v[start:end], -air.wind_x, sideways)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _enter_stream(block, flow, air, grains, climb, sideways):
    """Make velocities of a block of grains those relative to air that rises and turns, where it does."""
    if flow is not None:
        start, count = block
        _shift(count, grains.w[start : start + count], _MINUS, climb)
        _enter_crosswind(block, flow.speedup, air, grains, sideways)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _leave_crosswind(block, speedup, air, grains, sideways):
    if speedup is not None:
        start, count = block
        end = start + count
        length = air.before + air.after
        _shift(count, grains.x[start:end], -length * air.wind_y, sideways)
        _shift(count, grains.y[start:end], length * air.wind_x, sideways)
        _shift(count, grains.u[start:end], -air.wind_y, sideways)
        _shift(count, grains.v[start:end], air.wind_x, sideways)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _leave_stream(block, flow, air, grains, climb, sideways):
    """Make velocities those over ground again, and carry the grains along with the air."""
    if flow is not None:
        start, count = block
        end = start + count
        _shift(count, grains.z[start:end], air.rise_before + air.rise_after, climb)
        _shift(count, grains.w[start:end], _PLUS, climb)
        _leave_crosswind(block, flow.speedup, air, grains, sideways)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _take_deficit(block, grains, canopy, cols, cell, value):
    """Reduce the wind by the speed deficit over plants below each grain of a block, to 0 at least."""
    if canopy is not None:
        start, count = block
        deficit = canopy.speed_deficit
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            value[j] -= min(deficit[np.uint64(cell[j])], max(value[j], _ZERO))


@njit(cache=True, nogil=True, error_model="numpy")
def find_wind(start, count, grains, air, ground, cell, value, ustar):
    """Put the wind speed (m/s) at each grain of a block into ``value``."""
    base, cols = ground.base, ground.grid.cols
    first, last = air.wind.first, air.wind.last
    z, w = grains.z[start : start + count], grains.w[start : start + count]
    ahead = air.rise_before
    _find_mesh(start, count, grains, cols, cell)
    for j in range(count):
        value[j] = base[np.uint64(cell[j])]
    _find_near_bed(count, ground.feedback, cell, ustar)
    for j in range(count):
        cell[j] = entry(z[j] + ahead * w[j] - value[j], first, last)
    for j in range(count):
        value[j] = air.wind.values[np.uint64(cell[j])]
    _slow_wind(count, ground.feedback, air.above, cell, ustar, value)
    _take_deficit((start, count), grains, ground.canopy, cols, cell, value)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _to_class_tables(start, count, size_class, size, cell):
    """Move entries ``cell`` of the first of several tables to the table of each grain's size class."""
    if size_class is not None:
        part = size_class[start : start + count]
        for j in range(count):
            cell[j] += part[j] * size


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _push_along(count, place, velocity, part, wind, share, air):
    """Move a block of grains by one time step along one axis, of which the wind has its ``part``."""
    before, after = air.before, air.after
    for j in range(count):
        old = velocity[j]
        new = old + share[j] * (wind[j] * part - old)
        place[j] += before * old + after * new
        velocity[j] = new


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _push_up(count, z, w, share, air):
    """Move a block of grains by one time step upwards."""
    fall, early_fall = air.fall, air.early_fall
    before, after = air.rise_before, air.rise_after
    for j in range(count):
        old = w[j]
        new = old - share[j] * (old - early_fall) - fall
        z[j] += before * old + after * new
        w[j] = new


@njit(cache=True, nogil=True, error_model="numpy")
def _push(start, count, grains, air, wind, share):
    """Move a block of grains by one time step.

    One axis after the other: a loop that writes to more arrays would not become vector instructions, for
    the compiler asks first whether any two of them overlap, and asks only so often.
    """
    end = start + count
    _push_along(count, grains.x[start:end], grains.u[start:end], air.wind_x, wind, share, air)
    _push_along(count, grains.y[start:end], grains.v[start:end], air.wind_y, wind, share, air)
    _push_up(count, grains.z[start:end], grains.w[start:end], share, air)


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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
        _speed_up(block, grains, flow, cols, wind, cell, sideways)
        _find_climb(block, grains, flow, cols, wind, cell, climb)
        _enter_stream(block, flow, air, grains, climb, sideways)
        _find_drag(start, count, grains, air, wind, cell, share)
        _push(start, count, grains, air, wind, share)
        _leave_stream(block, flow, air, grains, climb, sideways)
        _find_low(start, count, grains, ground.grid, ground.top, cell, share)
        for j in range(count):
            # written whether it counts or not: the processor would mispredict a branch here again and again
            candidates[found] = start + j
            found += cell[j]
    return found - first


@njit(cache=True, nogil=True, error_model="numpy")
def move(first, last, grains, air, ground, candidates):
    """Move slots by one time step with work space of its own; see ``move_blocks``."""
    grains, air, ground, candidates = lent((grains, air, ground, candidates))
    return move_blocks(first, last, grains, air, ground, candidates, work_space())
