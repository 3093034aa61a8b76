"""How steep bedforms are on their windward and lee sides."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.filters import Field, Periodic, gradient, smoothed


@dataclass(frozen=True)
class Slopes:
    """Mean streamwise slopes (degrees); NaN on a bed without relief."""

    windward: float
    lee: float

    def __repr__(self) -> str:
        return f"<Slopes windward {self.windward:.1f}°, lee {self.lee:.1f}°>"


def streamwise_slopes(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
    width: float = 1.0,
) -> Slopes:
    """Mean slopes that face a wind from ``direction`` (degrees) and that turn from it.

    Slopes of the surface smoothed over ``width`` cells, averaged with the slope itself as weight: exact
    for straight flanks, and level ground between bedforms does not count. All relief does: bedforms, hills
    and walls of the ground, and remains of single slabs after smoothing.
    """
    east, north = gradient(smoothed(elevation, width, periodic), cell_size, periodic)
    x, y = downwind(direction)
    rise = east * x + north * y
    return Slopes(_weighted(rise[rise > 0]), _weighted(-rise[rise < 0]))


def _weighted(slopes: Field) -> float:
    total = float(slopes.sum())
    return float(np.degrees(np.arctan(float((slopes**2).sum()) / total))) if total > 1e-12 else float("nan")
