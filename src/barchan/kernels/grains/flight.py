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
def _find_near(count, near, cell, slowed):
    """Put the friction velocity near the bed at each grain of a block into ``slowed``, if it has places."""
    if near is not None:
        for j in range(count):
            slowed[j] = near[np.uint64(cell[j])]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _slow_wind(count, near, above, cell, slowed, value):
    """Make wind speeds of those for a friction velocity of 1 m/s near the bed, if it has places."""
    if near is not None:
        for j in range(count):
            value[j] = slowed[j] * value[j] + above.values[np.uint64(cell[j])]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _speed_up(start, count, grains, gain, aside, cols, wind, cell, turn):
    """Speed the wind up where it is faster, and find how fast it blows to the left, if it does."""
    if gain is not None:
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            wind[j] *= gain[np.uint64(cell[j])]
            turn[j] = aside[np.uint64(cell[j])] * wind[j]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _find_climb(start, count, grains, rise, cols, wind, cell, climb):
    """Find how fast the air rises at each grain of a block, if it follows the bed."""
    if rise is not None:
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            climb[j] = rise[np.uint64(cell[j])] * wind[j]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _shift(count, numbers, part, by):
    for j in range(count):
        numbers[j] += part * by[j]


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _enter_stream(start, count, rise, aside, air, grains, climb, turn):
    """Make velocities of a block of grains those relative to air that rises and turns, where it does."""
    end = start + count
    if rise is not None:
        _shift(count, grains.w[start:end], _MINUS, climb)
    if aside is not None:
        _shift(count, grains.u[start:end], air.wind_y, turn)
        _shift(count, grains.v[start:end], -air.wind_x, turn)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _leave_stream(start, count, rise, aside, air, grains, climb, turn):
    """Make them velocities over ground again, and carry the grains along with the air."""
    end = start + count
    if rise is not None:
        _shift(count, grains.z[start:end], air.rise_before + air.rise_after, climb)
        _shift(count, grains.w[start:end], _PLUS, climb)
    if aside is not None:
        length = air.before + air.after
        _shift(count, grains.x[start:end], -length * air.wind_y, turn)
        _shift(count, grains.y[start:end], length * air.wind_x, turn)
        _shift(count, grains.u[start:end], -air.wind_y, turn)
        _shift(count, grains.v[start:end], air.wind_x, turn)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _take_wind(start, count, grains, taken, cols, cell, value):
    """Take off the wind what plants below each grain of a block take, at most all of it."""
    if taken is not None:
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            value[j] -= min(taken[np.uint64(cell[j])], max(value[j], _ZERO))


@njit(cache=True, nogil=True, error_model="numpy")
def _find_wind(start, count, grains, air, ground, cols, cell, value, slowed):
    """Put the wind speed at each grain of a block into ``value``."""
    base = ground.base
    first, last = air.wind.first, air.wind.last
    z, w = grains.z[start : start + count], grains.w[start : start + count]
    ahead = air.rise_before
    _find_mesh(start, count, grains, cols, cell)
    for j in range(count):
        value[j] = base[np.uint64(cell[j])]
    _find_near(count, ground.near, cell, slowed)
    for j in range(count):
        cell[j] = entry(z[j] + ahead * w[j] - value[j], first, last)
    for j in range(count):
        value[j] = air.wind.values[np.uint64(cell[j])]
    _slow_wind(count, ground.near, air.above, cell, slowed, value)
    _take_wind(start, count, grains, ground.taken, cols, cell, value)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _turn_to_sizes(start, count, kinds, size, cell):
    """Move the entries ``cell`` of the first of several tables to those of each grain's size."""
    if kinds is not None:
        kinds = kinds[start : start + count]
        for j in range(count):
            cell[j] += kinds[j] * size


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
    _turn_to_sizes(start, count, grains.kind, last + np.int32(1), cell)
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
    """The same upwards."""
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
    """What a thread needs to move grains block by block."""
    cell = np.empty(BLOCK, np.int32)
    wind = np.empty(BLOCK, np.float32)
    share = np.empty(BLOCK, np.float32)
    climb = np.empty(BLOCK, np.float32)
    turn = np.empty(BLOCK, np.float32)
    return cell, wind, share, climb, turn


@njit(cache=True, nogil=True, error_model="numpy")
def move_blocks(first, last, grains, air, grid, ground, near, work):
    """Let the slots from ``first`` to before ``last`` fly for one time step.

    Writes those that left the field or lie below the highest corner of their mesh cell into ``near``, from
    ``first`` on, and returns how many they are. The rest is for ``land``.
    """
    cell, wind, share, climb, turn = work
    found = first
    for start in range(first, last, BLOCK):
        count = min(last - start, BLOCK)
        _find_wind(start, count, grains, air, ground, grid.cols, cell, wind, share)
        _speed_up(start, count, grains, ground.gain, ground.aside, grid.cols, wind, cell, turn)
        _find_climb(start, count, grains, ground.rise, grid.cols, wind, cell, climb)
        _enter_stream(start, count, ground.rise, ground.aside, air, grains, climb, turn)
        _find_drag(start, count, grains, air, wind, cell, share)
        _push(start, count, grains, air, wind, share)
        _leave_stream(start, count, ground.rise, ground.aside, air, grains, climb, turn)
        _find_low(start, count, grains, grid, ground.top, cell, share)
        for j in range(count):
            # written whether it counts or not: a branch here would be foretold wrongly again and again
            near[found] = start + j
            found += cell[j]
    return found - first


@njit(cache=True, nogil=True, error_model="numpy")
def move(first, last, grains, air, grid, ground, near):
    """The same with work space of its own."""
    grains, air, ground, near = lent((grains, air, ground, near))
    return move_blocks(first, last, grains, air, grid, ground, near, work_space())
