"""The wind at grains in flight: read from a table, slowed near the bed and by plants, and bent over waves.

A pass over a block of grains does one thing, so that the compiler turns it into vector instructions.
"""

import numpy as np

from barchan.kernels.core.internal import internal
from barchan.kernels.grains.air_state import TABLE_SHIFT
from barchan.kernels.grains.surface import mesh_cell

_SHIFT = np.int32(TABLE_SHIFT)
_NONE = np.int32(0)
_ZERO = np.float32(0.0)
_PLUS, _MINUS = np.float32(1.0), np.float32(-1.0)


@internal(error_model="numpy")
def entry(number, first, last):
    """The table's entry for a number: its leading bits, within the table."""
    return min(max((np.float32(number).view(np.int32) - first) >> _SHIFT, _NONE), last)


@internal(error_model="numpy", forceinline=True)
def _find_mesh(start, count, grains, cols, cell):
    """Put the mesh cell below each grain of a block into ``cell``."""
    x, y = grains.x[start : start + count], grains.y[start : start + count]
    for j in range(count):
        cell[j] = mesh_cell(x[j], y[j], cols)


@internal(error_model="numpy", forceinline=True)
def _find_near_bed(count, feedback, cell, ustar):
    """Put the near-bed friction velocity at each grain of a block into ``ustar``, if it varies in space."""
    if feedback is not None:
        near_bed = feedback.near_bed_ustar
        for j in range(count):
            ustar[j] = near_bed[np.uint64(cell[j])]


@internal(error_model="numpy", forceinline=True)
def _slow_wind(count, feedback, above, cell, ustar, value):
    """Make wind speeds of those for a near-bed friction velocity of 1 m/s, if it varies in space."""
    if feedback is not None:
        for j in range(count):
            value[j] = ustar[j] * value[j] + above.values[np.uint64(cell[j])]


@internal(error_model="numpy", forceinline=True)
def _speed_up_by(speedup, block, grains, cols, wind, cell, sideways):
    if speedup is not None:
        start, count = block
        factor, crosswind_ratio = speedup.factor, speedup.crosswind_ratio
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            wind[j] *= factor[np.uint64(cell[j])]
            sideways[j] = crosswind_ratio[np.uint64(cell[j])] * wind[j]


@internal(error_model="numpy", forceinline=True)
def speed_up(block, grains, flow, cols, wind, cell, sideways):
    """Speed the wind up over waves, and find how fast it blows to the left, if it does."""
    if flow is not None:
        _speed_up_by(flow.speedup, block, grains, cols, wind, cell, sideways)


@internal(error_model="numpy", forceinline=True)
def find_climb(block, grains, flow, cols, wind, cell, climb):
    """Find how fast the air rises at each grain of a block, if it follows the bed."""
    if flow is not None:
        start, count = block
        slope = flow.streamline_slope
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            climb[j] = slope[np.uint64(cell[j])] * wind[j]


@internal(error_model="numpy", forceinline=True)
def _shift(count, numbers, part, by):
    for j in range(count):
        numbers[j] += part * by[j]


@internal(error_model="numpy", forceinline=True)
def _enter_crosswind(block, speedup, air, grains, sideways):
    if speedup is not None:
        start, count = block
        end = start + count
        _shift(count, grains.u[start:end], air.wind_y, sideways)
        _shift(count, grains.v[start:end], -air.wind_x, sideways)


@internal(error_model="numpy", forceinline=True)
def enter_stream(block, flow, air, grains, climb, sideways):
    """Make velocities of a block of grains those relative to air that rises and turns, where it does."""
    if flow is not None:
        start, count = block
        _shift(count, grains.w[start : start + count], _MINUS, climb)
        _enter_crosswind(block, flow.speedup, air, grains, sideways)


@internal(error_model="numpy", forceinline=True)
def _leave_crosswind(block, speedup, air, grains, sideways):
    if speedup is not None:
        start, count = block
        end = start + count
        length = air.before + air.after
        _shift(count, grains.x[start:end], -length * air.wind_y, sideways)
        _shift(count, grains.y[start:end], length * air.wind_x, sideways)
        _shift(count, grains.u[start:end], -air.wind_y, sideways)
        _shift(count, grains.v[start:end], air.wind_x, sideways)


@internal(error_model="numpy", forceinline=True)
def leave_stream(block, flow, air, grains, climb, sideways):
    """Make velocities those over ground again, and carry the grains along with the air."""
    if flow is not None:
        start, count = block
        end = start + count
        _shift(count, grains.z[start:end], air.rise_before + air.rise_after, climb)
        _shift(count, grains.w[start:end], _PLUS, climb)
        _leave_crosswind(block, flow.speedup, air, grains, sideways)


@internal(error_model="numpy", forceinline=True)
def _take_deficit(block, grains, canopy, cols, cell, value):
    """Reduce the wind by the speed deficit over plants below each grain of a block, to 0 at least."""
    if canopy is not None:
        start, count = block
        deficit = canopy.speed_deficit
        _find_mesh(start, count, grains, cols, cell)
        for j in range(count):
            value[j] -= min(deficit[np.uint64(cell[j])], max(value[j], _ZERO))


@internal(error_model="numpy")
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
