"""The air as grains meet it: the tables of wind and drag that flight reads."""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.wall import above_focus, focused_wind, unstable_wind
from barchan.kernels.grains.state import TABLE_SHIFT, Table

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
    first, last = doublings
    begin = int(np.float32(2.0**first).view(np.int32))
    bits = np.arange((last - first) * _PER_DOUBLING, dtype=np.int64) << TABLE_SHIFT
    middle = (bits + begin + (1 << (TABLE_SHIFT - 1))).astype(np.int32).view(np.float32)
    return Table(of(middle.astype(np.float64)).astype(np.float32), np.int32(begin), np.int32(middle.size - 1))


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


def settling_speed(rate: Callable[[NDArray], NDArray], gravity: float) -> float:
    """Speed (m/s) of steady fall in still air, where drag at that ``rate`` bears the weight."""
    low, high = 1e-6, 1e3
    for _ in range(100):
        middle = math.sqrt(low * high)
        falls_faster = float(rate(np.array(middle))) * middle < gravity
        low, high = (middle, high) if falls_faster else (low, middle)
    return low
