"""From a slab model's parameters to the numbers and tables that the kernels read."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Lattice
from barchan.models.slab_parameters import SlabTransport
from barchan.models.wind_frame import WindFrame

FRACTION_BITS = 20
"""Binary places of a height below one slab, over ground that is not flat."""

_FAR = 1 << 30
"""A fall (slabs) that no shadow line survives."""

_DIRECTIONS = ((0, 1), (1, 0), (0, -1), (-1, 0), (1, 1), (1, -1), (-1, -1), (-1, 1))
"""(across, along) steps of the kernels' eight directions."""


@dataclass(frozen=True)
class SlabTables:
    """A slab model's rules for one wind, as the kernels take them."""

    grid: Any
    wind: Any
    repose: Any
    axis: Any
    ray: Any
    turns: NDArray[np.int64]
    memory: tuple[NDArray, ...]
    """The arrays whose addresses ``axis`` and ``ray`` hold."""


def build(
    parameters: SlabTransport, lattice: Lattice, frame: WindFrame, hop: float, flat: bool
) -> SlabTables:
    """The tables for a wind in ``frame`` with hops of ``hop`` cells, over flat ground or not."""
    from barchan.kernels.avalanche import Repose
    from barchan.kernels.shadow import Grid
    from barchan.kernels.transport import CELL, Wind

    rows, cols = reversed(lattice.shape) if frame.crossed else lattice.shape
    wraps = lattice.boundary_x == "periodic", lattice.boundary_y == "periodic"
    along, across = reversed(wraps) if frame.crossed else wraps
    grid = Grid(rows, cols, along, across)
    one = 1 if flat else 1 << FRACTION_BITS
    moore = parameters.neighbourhood == "moore"
    repose = Repose(
        slab=one,
        face_limit=parameters.face_limit(lattice) * one,
        corner_limit=parameters.corner_step_limit(lattice) * one,
        corner_weight=1.0 if parameters.corner_limit == "face" else math.sqrt(0.5),
        corners=moore,
        random_order=parameters.neighbour_order == "random",
    )
    wind = Wind(
        lee_erosion=parameters.lee_erosion,
        hop_along=round(hop * math.cos(frame.angle) * CELL),
        hop_across=round(hop * math.sin(frame.angle) * CELL),
        settle_on_sand=np.uint64(round(parameters.p_s * 2**32)),
        settle_on_ground=np.uint64(round(parameters.p_ns * 2**32)),
        max_hops=parameters.max_hops,
    )
    turns = turn_table(frame.angle, moore, parameters.upwind_avalanches)
    fall = math.tan(math.radians(parameters.shadow_angle)) / lattice.aspect
    start = 0.5 if parameters.shadow_from == "edge" else 0.0
    if frame.angle == 0.0:
        axis, memory = _axis_shadow(cols, fall, start, flat)
        return SlabTables(grid, wind, repose, axis, None, turns, memory)
    ray, memory = _ray_shadow(grid, frame.angle, fall, start, flat)
    return SlabTables(grid, wind, repose, None, ray, turns, memory)


def turn_table(angle: float, moore: bool, upwind: bool) -> NDArray[np.int64]:
    """Codes of the neighbours, in the order in which a wind at ``angle`` has them checked.

    A slab slides downwind first, one falls in from upwind first, faces before corners; of two that lie
    alike to the wind the one on its left comes first. Without ``upwind`` nothing moves against the wind.
    """
    from barchan.kernels.avalanche import CLOSED, FEED, SLIDE, turn_code

    downwind = [c * math.cos(angle) + a * math.sin(angle) for a, c in _DIRECTIONS]
    left = [a * math.cos(angle) - c * math.sin(angle) for a, c in _DIRECTIONS]
    turns = np.full((3, 8), CLOSED, np.int64)
    for table, sign in ((SLIDE, 1), (FEED, -1)):
        for faces in (range(4), range(4, 8) if moore else ()):
            order = sorted(faces, key=lambda d: (-round(sign * downwind[d], 9), -round(left[d], 9)))
            for place, direction in enumerate(order, start=min(faces, default=0)):
                if upwind or sign * downwind[direction] > -1e-9:
                    turns[table, direction] = turn_code(direction, place)
    return turns


def _axis_shadow(cols: int, fall: float, start: float, flat: bool) -> tuple[Any, tuple[NDArray, ...]]:
    from barchan.kernels.lanes import LANES
    from barchan.kernels.shadow import AxisShadow

    shift = 0 if flat else FRACTION_BITS
    size = -(-cols // LANES) * LANES + LANES
    distance = np.arange(1, size + 1) - start
    falls = np.full(size + LANES, _FAR << shift, np.int32 if flat else np.int64)
    falls[LANES:] = np.minimum(np.floor(distance * fall * 2.0**shift), _FAR << shift)[::-1]
    reach = math.ceil(2**16 / fall)
    address = falls.ctypes.data + LANES * falls.itemsize
    return AxisShadow(address, size, shift, reach, falls.itemsize), (falls,)


def _ray_shadow(
    grid: Any, angle: float, fall: float, start: float, flat: bool
) -> tuple[Any, tuple[NDArray, ...]]:
    from barchan.kernels.shadow import RayShadow

    columns = np.arange(1, grid.cols + 1)
    offset = -columns * math.tan(angle)
    lower = np.floor(offset + 1e-9)
    weights = np.maximum(offset - lower, 0.0)
    rows = lower.astype(np.int64)
    if grid.wrap_across:
        rows %= grid.rows
    falls = (columns / math.cos(angle) - start) * fall * (1.0 if flat else 2.0**FRACTION_BITS)
    width = 4 if flat else 8
    ray = RayShadow(rows.ctypes.data, weights.ctypes.data, falls.ctypes.data, grid.cols, width)
    return ray, (rows, weights, falls)
