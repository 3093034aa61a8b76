"""From a slab model's parameters to the numbers and tables that the kernels read."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.heights import FRACTION_BITS
from barchan.kernels.bed.state import (
    CLOSED,
    FEED,
    LEVEL_BITS,
    SLIDE,
    Grid,
    Repose,
    settling_sequences,
    turn_code,
)
from barchan.kernels.core.state import LANES
from barchan.kernels.slabs.state import CELL, MOBILE, AxisShadow, Path, RayShadow, Speedup, Wind
from barchan.lattice import Lattice
from barchan.slabs.parameters import SlabTransport
from barchan.slabs.rules import Giving, HopRule, Rules
from barchan.wind.frame import WindFrame

_FAR = 1 << 30
"""A fall (slabs) that no shadow line survives."""

_DIRECTIONS = ((0, 1), (1, 0), (0, -1), (-1, 0), (1, 1), (1, -1), (-1, -1), (-1, 1))
"""(across, along) steps of the kernels' eight directions."""


@dataclass(frozen=True)
class SlabTables:
    """A slab model's rules for one wind, as the kernels take them."""

    grid: Any
    wind: Any
    speedup: Any
    path: Any
    repose: Any
    axis: Any
    ray: Any
    turns: NDArray[np.int64]
    sequences: NDArray[np.int64]
    """Orders in which neighbours are checked by avalanches that run until all holds."""
    memory: tuple[NDArray, ...]
    """The arrays whose addresses ``axis`` and ``ray`` hold."""


def build(
    parameters: SlabTransport, rules: Rules, lattice: Lattice, frame: WindFrame, hop: float, flat: bool
) -> SlabTables:
    """The tables for a wind in ``frame`` with hops of ``hop`` cells, over flat ground or not."""
    rows, cols = reversed(lattice.shape) if frame.crossed else lattice.shape
    across, along = reversed(lattice.periodic) if frame.crossed else lattice.periodic
    grid = Grid(rows, cols, along, across)
    moore = parameters.neighbourhood == "moore"
    turns = turn_table(frame.angle, moore, parameters.upwind_avalanches)
    passes = parameters.path_test == "off" or (parameters.path_test == "hard" and flat)
    fall = math.tan(math.radians(parameters.shadow_angle)) / lattice.aspect
    start = 0.5 if parameters.shadow_from == "edge" else 0.0
    repose = _repose(parameters, rules, lattice, 1 if flat else 1 << FRACTION_BITS)
    axis, ray = None, None
    if frame.angle == 0.0:
        axis, memory = _axis_shadow(cols, fall, start, flat)
    else:
        ray, memory = _ray_shadow(grid, frame.angle, fall, start, flat)
    return SlabTables(
        grid=grid,
        wind=_wind(parameters, rules.giving, frame, hop),
        speedup=rules.hop and _speedup(rules.hop, grid, hop, flat),
        path=None if passes else _path(parameters, repose, flat),
        repose=repose,
        axis=axis,
        ray=ray,
        turns=turns,
        sequences=_sequences(parameters, turns),
        memory=memory,
    )


def _wind(parameters: SlabTransport, giving: Giving, frame: WindFrame, hop: float) -> Any:

    unit = math.cos(frame.angle) * CELL, math.sin(frame.angle) * CELL
    return Wind(
        lee_erosion=parameters.lee_erosion,
        hop_along=round(hop * unit[0]),
        hop_across=round(hop * unit[1]),
        unit_along=unit[0],
        unit_across=unit[1],
        settle_on_sand=np.uint64(round(parameters.p_s * 2**32)),
        settle_on_ground=np.uint64(round(parameters.p_ns * 2**32)),
        give_share=round(giving.share * 2**32),
        give_shift=round(giving.shift * 2**32),
        max_hops=parameters.max_hops,
    )


def _speedup(rule: HopRule, grid: Any, hop: float, flat: bool) -> Any:

    return Speedup(
        linear=rule.linear,
        quadratic=rule.quadratic,
        base=float(hop),
        longest=float(grid.cols),
        slabs=1.0 if flat else 2.0**-FRACTION_BITS,
        shift=LEVEL_BITS if flat else LEVEL_BITS - FRACTION_BITS,
        share=0.5 / (grid.rows * grid.cols) if rule.follows_relief else 0.0,
        whole=rule.whole,
        every_hop=rule.every_hop,
    )


def _path(parameters: SlabTransport, repose: Any, flat: bool) -> Any:

    height = np.dtype(np.int32 if flat else np.int64)
    return Path(parameters.path_test == "surface", height.type(repose.face_limit), height.itemsize)


def _repose(parameters: SlabTransport, rules: Rules, lattice: Lattice, one: int) -> Any:

    face, corner = parameters.limits(lattice)
    firm_face, firm_corner = parameters.limits(lattice, rules.firm_angle)
    let_face, let_corner = parameters.limits(lattice, parameters.release_angle)
    return Repose(
        slab=one,
        face_limit=face * one,
        corner_limit=corner * one,
        corner_weight=1.0 if parameters.corner_limit == "face" else math.sqrt(0.5),
        corners=parameters.neighbourhood == "moore",
        random_order=parameters.neighbour_order == "random",
        firm_face_limit=firm_face * one,
        firm_corner_limit=firm_corner * one,
        firm_below=round(rules.firm_mobility * MOBILE),
        release_face=(let_face - face) * one,
        release_corner=(let_corner - corner) * one,
    )


def _sequences(parameters: SlabTransport, turns: NDArray[np.int64]) -> NDArray[np.int64]:
    """The wind's own order, or a choice of orders to draw from."""
    if parameters.neighbour_order == "wind":
        return turns[SLIDE : SLIDE + 1].copy()

    drawn = settling_sequences(parameters.neighbourhood == "moore")
    return np.where(turns[SLIDE] < 0, turns[SLIDE], drawn)


def turn_table(angle: float, moore: bool, upwind: bool) -> NDArray[np.int64]:
    """Codes of the neighbours, in the order in which a wind at ``angle`` has them checked.

    A slab slides downwind first, one falls in from upwind first, faces before corners; of two that lie
    alike to the wind the one on its left comes first. Without ``upwind`` nothing moves against the wind.
    """
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
