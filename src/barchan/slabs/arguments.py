"""From a slab model's parameters to the structs that its kernels read."""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from barchan.heights import FRACTION_BITS
from barchan.kernels.bed.state import (
    DOWNSLOPE,
    LEVEL_BITS,
    Grid,
    Levels,
    Repose,
    new_levels,
    relaxation_orders,
    repose_rule,
    unstable_cells,
)
from barchan.kernels.core.interruption import new_interruption
from barchan.kernels.core.state import SIMD_WIDTH
from barchan.kernels.slabs.shadow_lines import AxisShadow, RayShadow
from barchan.kernels.slabs.state import (
    CELL,
    MOBILE,
    ObstacleRule,
    Schedule,
    SlabRules,
    Speedup,
    Wind,
    Work,
    prepared_polls,
)
from barchan.lattice import HEX_ROWS, Lattice
from barchan.slabs.boxes import box_shadow
from barchan.slabs.neighbours import neighbour_groups, order_table
from barchan.slabs.parameters import ActingRules, OrderRule, SlabParameters
from barchan.slabs.rays import ray_shadow
from barchan.slabs.rules import ErosionChance, HopRule, Rules
from barchan.wind.frame import WindFrame

_FAR = 1 << 30
"""A fall (slabs) that no shadow line survives."""


@dataclass(frozen=True)
class SlabArguments:
    """A slab model's rules for one wind, as the kernels take them."""

    rules: SlabRules
    memory: tuple[NDArray, ...]
    """The arrays whose addresses the shadow structs hold."""


@lru_cache(maxsize=64)
def build(
    parameters: SlabParameters,
    rules: Rules,
    lattice: Lattice,
    frame: WindFrame,
    hop: float,
    flat: bool,
    acting: ActingRules,
) -> SlabArguments:
    """The structs for a wind in ``frame`` with hops of ``hop`` cells, over flat ground or not.

    ``acting`` is what acts of the rules that depend on the winds, whatever the parameters say.
    """
    rows, cols = reversed(lattice.shape) if frame.crossed else lattice.shape
    across, along = reversed(lattice.periodic) if frame.crossed else lattice.periodic
    grid = Grid(rows, cols, along, across, lattice.hexagonal)
    orders = order_table(frame.angle, neighbour_groups(parameters, lattice), parameters.upwind_avalanches)
    passes = parameters.path_test == "off" or (parameters.path_test == "hard" and flat)
    fall = math.tan(math.radians(parameters.shadow_angle)) / lattice.aspect
    shadow = acting.shadow
    start = 0.5 if shadow == "edge" else 0.0
    repose = _repose(parameters, rules, lattice, acting.order, 1 if flat else 1 << FRACTION_BITS)
    axis: AxisShadow | None = None
    ray: RayShadow | None = None
    fall_of_units, width = fall * (1.0 if flat else 2.0**FRACTION_BITS), 4 if flat else 8
    steepest = float(repose.face_limit) if parameters.stack_tops == "sloping" else None
    if frame.angle == 0.0:
        axis, memory = _axis_shadow(cols, fall, start, flat)
    else:
        ray, memory = ray_shadow(grid, frame.angle, fall_of_units, start, width)
    found = SlabRules(
        grid=grid,
        wind=_wind(parameters, rules.erosion, frame, hop, lattice),
        speedup=None if rules.hop is None else _speedup(rules.hop, grid, hop, flat),
        obstacles=None if passes else _obstacles(parameters, repose, flat),
        repose=repose,
        axis=axis,
        ray=ray,
        box=box_shadow(grid, frame.angle, fall_of_units, width, steepest) if shadow == "place" else None,
        orders=orders,
        relaxation_orders=_relaxation_orders(parameters, lattice, acting.order, orders),
        interruption=new_interruption(),
    )
    return SlabArguments(found, memory)


def levels_over(flat: bool) -> Levels:
    """Room for the mean height of the surface, over flat ground or not."""
    return new_levels(LEVEL_BITS if flat else LEVEL_BITS - FRACTION_BITS)


def work_space(rules: SlabRules, schedule: Schedule) -> Work:
    """Work space of the kernel for these rules."""
    grid, repose = rules.grid, rules.repose
    avalanches = repose.static_face or repose.static_corner
    unstable = unstable_cells(grid.rows * grid.cols) if avalanches else None
    return Work(prepared_polls(grid.rows, grid.cols, schedule), unstable)


def _wind(
    parameters: SlabParameters, erosion: ErosionChance, frame: WindFrame, hop: float, lattice: Lattice
) -> Wind:
    heights = HEX_ROWS if lattice.hexagonal else 1.0
    unit = math.cos(frame.angle) * CELL, math.sin(frame.angle) * heights * CELL
    return Wind(
        lee_erosion=parameters.lee_erosion,
        hop_along=round(hop * unit[0]),
        hop_across=round(hop * unit[1]),
        unit_along=unit[0],
        unit_across=unit[1],
        deposit_on_sand=np.uint64(round(parameters.p_s * 2**32)),
        deposit_on_ground=np.uint64(round(parameters.p_ns * 2**32)),
        erosion_factor=round(erosion.factor * 2**32),
        erosion_offset=round(erosion.offset * 2**32),
        max_hops=parameters.max_hops,
    )


def _speedup(rule: HopRule, grid: Grid, hop: float, flat: bool) -> Speedup:
    return Speedup(
        linear=rule.linear,
        quadratic=rule.quadratic,
        base=float(hop),
        longest=float(grid.cols),
        slabs=1.0 if flat else 2.0**-FRACTION_BITS,
        deviation_weight=0.5 / (grid.rows * grid.cols) if rule.follows_relief else 0.0,
        whole=rule.whole,
        every_hop=rule.every_hop,
    )


def _obstacles(parameters: SlabParameters, repose: Repose, flat: bool) -> ObstacleRule:
    height = np.dtype(np.int32 if flat else np.int64)
    return ObstacleRule(parameters.path_test == "surface", height.type(repose.face_limit), height.itemsize)


def _repose(parameters: SlabParameters, rules: Rules, lattice: Lattice, order: OrderRule, one: int) -> Repose:
    return repose_rule(
        one,
        parameters.limits(lattice),
        corners=parameters.neighbourhood == "moore" and not lattice.hexagonal,
        corner_weight=1.0 if parameters.corner_limit == "face" else math.sqrt(0.5),
        random_order=order == "random",
        downslope=order == "downslope",
        stabilised=parameters.limits(lattice, rules.stabilised_angle),
        stabilised_below=round(rules.stabilised_mobility * MOBILE),
        static=parameters.limits(lattice, parameters.static_repose_angle),
    )


def _relaxation_orders(
    parameters: SlabParameters, lattice: Lattice, order: OrderRule, orders: NDArray[np.int64]
) -> NDArray[np.int64]:
    """The wind's own order, or several orders to draw from."""
    if order != "random":
        return orders[DOWNSLOPE : DOWNSLOPE + 1].copy()
    drawn = relaxation_orders(parameters.neighbourhood == "moore", lattice.hexagonal)
    return np.where(orders[DOWNSLOPE] < 0, orders[DOWNSLOPE], drawn)


def _axis_shadow(cols: int, fall: float, start: float, flat: bool) -> tuple[AxisShadow, tuple[NDArray, ...]]:
    shift = 0 if flat else FRACTION_BITS
    size = -(-cols // SIMD_WIDTH) * SIMD_WIDTH + SIMD_WIDTH
    distance = np.arange(1, size + 1) - start
    falls = np.full(size + SIMD_WIDTH, _FAR << shift, np.int32 if flat else np.int64)
    falls[SIMD_WIDTH:] = np.minimum(np.floor(distance * fall * 2.0**shift), _FAR << shift)[::-1]
    reach = math.ceil(2**16 / fall)
    address = falls.ctypes.data + SIMD_WIDTH * falls.itemsize
    return AxisShadow(address, size, shift, reach, falls.itemsize), (falls,)
