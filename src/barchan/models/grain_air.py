"""The air as grains meet it: the law of the wall, drag, and the tables that flight reads."""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.wind.flux import KARMAN

REFERENCE_HEIGHT = 10.0
"""Height (m) at which wind speeds are stated."""

_PER_DOUBLING = 64
"""Entries of a table from a number to its double, as the kernels read them."""

HEIGHTS = -20, 7
"""Doublings of 1 m that the table of the wind covers: a thousandth of a millimetre to 128 m."""

SQUARED_SPEEDS = -24, 14
"""Doublings of 1 m²/s² that the table of the drag covers: 0.2 mm/s to 128 m/s."""

_KEPT = 8
"""Winds whose tables are kept: they are asked for again and again."""


def table(of: Callable[[NDArray], NDArray], doublings: tuple[int, int]) -> Any:
    """A kernel's table of a function of a positive number within ``doublings`` of 1.

    An entry holds the value in the middle of the numbers that share its leading bits; below the table
    the first value holds, above it the last.
    """
    from barchan.kernels.grain_flight import TABLE_SHIFT
    from barchan.kernels.grain_state import Table

    first, last = doublings
    begin = int(np.float32(2.0**first).view(np.int32))
    bits = np.arange((last - first) * _PER_DOUBLING, dtype=np.int64) << TABLE_SHIFT
    middle = (bits + begin + (1 << (TABLE_SHIFT - 1))).astype(np.int32).view(np.float32)
    return Table(of(middle.astype(np.float64)).astype(np.float32), np.int32(begin), np.int32(middle.size - 1))


def log_wind(height: NDArray, friction: float, roughness: float, displacement: float = 0.0) -> NDArray:
    """Wind speed (m/s) at heights (m) above the surface: the law of the wall, calm below the roughness."""
    ratio = np.maximum((height - displacement) / roughness, 1.0)
    return friction / KARMAN * np.log(ratio)


def unstable_wind(
    height: NDArray, friction: float, roughness: float, displacement: float, stability: float
) -> NDArray:
    """The same, where it blows faster by ``stability`` (m/s)."""
    speed = log_wind(height, friction, roughness, displacement)
    return speed + np.where(speed > 0.0, stability, 0.0)


def focused_wind(
    height: NDArray, friction: float, least: float, roughness: float, focus: float, displacement: float
) -> NDArray:
    """Wind speed (m/s) in a layer of grains: below ``focus`` (m) that of the friction velocity ``least``.

    The grains take up what the wind exceeds the impact threshold by, so near the bed all winds are alike and
    their profiles meet at the focus (Bagnold 1941; Ungar & Haff 1987).
    """
    near = log_wind(height, min(least, friction), roughness, displacement)
    at_focus = float(log_wind(np.array(focus), min(least, friction), roughness, displacement))
    return np.where(
        height < focus, near, at_focus + above_focus(height, friction, roughness, focus, displacement)
    )


def above_focus(
    height: NDArray, friction: float, roughness: float, focus: float, displacement: float
) -> NDArray:
    """What the wind speed (m/s) gains above the focus (m)."""
    ratio = np.maximum((height - displacement) / max(focus - displacement, roughness), 1.0)
    return friction / KARMAN * np.log(ratio)


@lru_cache(_KEPT)
def log_table(friction: float, roughness: float, displacement: float, stability: float) -> Any:
    """The table of a wind by the law of the wall, which ``stability`` (m/s) speeds up where it blows."""
    return table(lambda height: unstable_wind(height, friction, roughness, displacement, stability), HEIGHTS)


@lru_cache(_KEPT)
def tables_about_focus(
    friction: float, roughness: float, focus: float, displacement: float
) -> tuple[Any, Any]:
    """Those of a wind in a layer of grains: its shape below the focus, and what comes to it above.

    The shape is for a friction velocity of 1 m/s near the bed.
    """
    about = roughness, focus, displacement
    return (
        table(
            lambda height: focused_wind(height, 1.0, 1.0, *about) - above_focus(height, 1.0, *about), HEIGHTS
        ),
        table(lambda height: above_focus(height, friction, *about), HEIGHTS),
    )


def natural_drag(speed: NDArray, diameter: float, viscosity: float) -> NDArray:
    """Drag coefficient of natural sand, ((32 / Re)^(2/3) + 1)^1.5 (Cheng 1997, J. Hydraul. Eng. 123, 149)."""
    reynolds = np.maximum(speed * diameter / viscosity, 1e-12)
    return ((32.0 / reynolds) ** (2.0 / 3.0) + 1.0) ** 1.5


def drag_rate(
    speed: NDArray, coefficient: NDArray | float, diameter: float, density: float, air_density: float
) -> NDArray:
    """Rate (1/s) at which drag takes a velocity difference ``speed`` (m/s) away, A |ΔV| / m of eq. 4.9."""
    return 0.75 * air_density / (density * diameter) * coefficient * speed


def settling_speed(rate: Callable[[NDArray], NDArray], gravity: float) -> float:
    """Speed (m/s) of steady fall in still air, where drag at that ``rate`` bears the weight."""
    low, high = 1e-6, 1e3
    for _ in range(100):
        middle = math.sqrt(low * high)
        falls_faster = float(rate(np.array(middle))) * middle < gravity
        low, high = (middle, high) if falls_faster else (low, middle)
    return low
