"""Grains in flight: gravity and drag in a wind that is looked up, many grains at a time.

All grains take the same time step. A pass over a block of grains does one thing, so that the compiler
turns it into vector instructions; wind and drag are read from tables by the leading bits of a number,
so that no logarithm and no root is taken in flight.
"""

import numpy as np
from numba import njit

from barchan.kernels.grain_state import mesh_cell

BLOCK = 256
"""Grains that pass through the loops together: their work space stays in the fastest cache."""

TABLE_SHIFT = 17
"""Bits of a 32-bit float below those that choose a table's entry: 64 entries for each doubling."""

_SHIFT = np.int32(TABLE_SHIFT)
_NONE = np.int32(0)
OUTSIDE = np.int32(-1)
_ZERO = np.float32(0.0)


@njit(cache=True, nogil=True, error_model="numpy")
def entry(number, first, last):
    """The table's entry for a number: its leading bits, within the table."""
    return min(max((np.float32(number).view(np.int32) - first) >> _SHIFT, _NONE), last)


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
def _take_wind(start, count, grains, taken, cols, cell, value):
    """Take off the wind what plants below each grain of a block take, at most all of it."""
    if taken is not None:
        x, y = grains.x, grains.y
        for j in range(count):
            cell[j] = mesh_cell(x[start + j], y[start + j], cols)
        for j in range(count):
            value[j] -= min(taken[np.uint64(cell[j])], max(value[j], _ZERO))


@njit(cache=True, nogil=True, error_model="numpy")
def _find_wind(start, count, grains, air, ground, cols, cell, value, slowed):
    """Put the wind speed at each grain of a block into ``value``."""
    base = ground.base
    first, last = air.wind.first, air.wind.last
    x, y, z, w = grains.x, grains.y, grains.z, grains.w
    ahead = air.rise_before
    for j in range(count):
        cell[j] = mesh_cell(x[start + j], y[start + j], cols)
    for j in range(count):
        value[j] = base[np.uint64(cell[j])]
    _find_near(count, ground.near, cell, slowed)
    for j in range(count):
        cell[j] = entry(z[start + j] + ahead * w[start + j] - value[j], first, last)
    for j in range(count):
        value[j] = air.wind.values[np.uint64(cell[j])]
    _slow_wind(count, ground.near, air.above, cell, slowed, value)
    _take_wind(start, count, grains, ground.taken, cols, cell, value)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _turn_to_sizes(start, count, kinds, size, cell):
    """Move the entries ``cell`` of the first of several tables to those of each grain's size."""
    if kinds is not None:
        for j in range(count):
            cell[j] += kinds[start + j] * size


@njit(cache=True, nogil=True, error_model="numpy")
def _find_drag(start, count, grains, air, wind, cell, share):
    """Put the share of the velocity difference that drag takes away into ``share``."""
    first, last = air.drag.first, air.drag.last
    u, v, w = grains.u, grains.v, grains.w
    wind_x, wind_y, early_fall = air.wind_x, air.wind_y, air.early_fall
    for j in range(count):
        lag_x = wind[j] * wind_x - u[start + j]
        lag_y = wind[j] * wind_y - v[start + j]
        fall = w[start + j] - early_fall
        cell[j] = entry(lag_x * lag_x + lag_y * lag_y + fall * fall, first, last)
    _turn_to_sizes(start, count, grains.kind, last + np.int32(1), cell)
    for j in range(count):
        share[j] = air.drag.values[np.uint64(cell[j])]


@njit(cache=True, nogil=True, error_model="numpy")
def _push(start, count, grains, air, wind, share):
    """Move a block of grains by one time step."""
    x, y, z, u, v, w = grains.x, grains.y, grains.z, grains.u, grains.v, grains.w
    wind_x, wind_y, fall, early_fall = air.wind_x, air.wind_y, air.fall, air.early_fall
    before, after, rise_before, rise_after = air.before, air.after, air.rise_before, air.rise_after
    for j in range(count):
        i = start + j
        east = u[i] + share[j] * (wind[j] * wind_x - u[i])
        north = v[i] + share[j] * (wind[j] * wind_y - v[i])
        up = w[i] - share[j] * (w[i] - early_fall) - fall
        x[i] += before * u[i] + after * east
        y[i] += before * v[i] + after * north
        z[i] += rise_before * w[i] + rise_after * up
        u[i] = east
        v[i] = north
        w[i] = up


@njit(cache=True, nogil=True, error_model="numpy")
def _find_cells(start, count, grains, grid, cell):
    """Put the mesh cell below each grain into ``cell``, or that it is outside the field."""
    x, y = grains.x, grains.y
    east, north = np.float32(grid.cols), np.float32(grid.rows)
    for j in range(count):
        there_x, there_y = x[start + j], y[start + j]
        inside = (there_x >= _ZERO) & (there_x < east) & (there_y >= _ZERO) & (there_y < north)
        cell[j] = mesh_cell(there_x, there_y, grid.cols) if inside else OUTSIDE


@njit(cache=True, nogil=True, error_model="numpy")
def move(first, last, grains, air, grid, ground, near):
    """Let the slots from ``first`` to before ``last`` fly for one time step.

    Writes those that left the field or lie below the highest corner of their mesh cell into ``near``, from
    ``first`` on, and returns how many they are. The rest is for ``land``.
    """
    cell = np.empty(BLOCK, np.int32)
    wind = np.empty(BLOCK, np.float32)
    share = np.empty(BLOCK, np.float32)
    found = first
    for start in range(first, last, BLOCK):
        count = min(last - start, BLOCK)
        _find_wind(start, count, grains, air, ground, grid.cols, cell, wind, share)
        _find_drag(start, count, grains, air, wind, cell, share)
        _push(start, count, grains, air, wind, share)
        _find_cells(start, count, grains, grid, cell)
        for j in range(count):
            if cell[j] == OUTSIDE or grains.z[start + j] < ground.top[np.uint64(cell[j])]:
                near[found] = start + j
                found += 1
    return found - first
