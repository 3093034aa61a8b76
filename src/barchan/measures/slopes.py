"""How steep bedforms are on their windward and lee sides."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.filters import Field, Periodic, gradient, smoothed, without_trend


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

    Slopes of the surface without its trend towards open edges, smoothed over ``width`` cells, averaged with
    the slope itself as weight: exact for straight flanks, and level ground between bedforms does not count.
    Cells that are NaN are left out. All relief counts, also remains of single slabs after smoothing; that of
    uneven ground is removed beforehand, by ``bedform_surface``.
    """
    surface = smoothed(without_trend(elevation, periodic), width, periodic)
    east, north = gradient(surface, cell_size, periodic)
    x, y = downwind(direction)
    rise = east * x + north * y
    return Slopes(_weighted(rise[rise > 0]), _weighted(-rise[rise < 0]))


def slope_shares(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    edges: NDArray,
    periodic: Periodic = (True, True),
    width: float = 1.0,
) -> Field:
    """Shares of the field whose surface rises downwind by angles (degrees) between neighbouring ``edges``.

    Slopes that fall downwind, those of lee sides, are negative. The surface is smoothed over ``width`` cells;
    a trend is not removed. Cells that are NaN are left out; the sum is below 1 where slopes lie beyond the
    edges.
    """
    east, north = gradient(smoothed(elevation, width, periodic), cell_size, periodic)
    x, y = downwind(direction)
    rise = np.degrees(np.arctan(east * x + north * y))
    known = rise[np.isfinite(rise)]
    counts, _ = np.histogram(known, edges)
    return counts / max(known.size, 1)


SHARE = 0.95
"""Share of the fall of lee sides that slip faces are as steep as, or steeper than all of."""


def slip_face_angle(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
    width: float = 0.5,
) -> float:
    """The 95th percentile (degrees) of the slopes of lee sides in a wind from ``direction`` (degrees).

    Lee cells are those on which the surface, smoothed over ``width`` cells, falls downwind; their slope is
    the dip, in whatever direction they face, to the horizontal: a trend is not removed, nor the relief of the
    ground. Each cell counts by its slope, so that level floors and roughness count little. Cells that are NaN
    are left out. NaN where nothing falls downwind.
    """
    east, north = gradient(smoothed(elevation, width, periodic), cell_size, periodic)
    x, y = downwind(direction)
    dip = np.sort(np.hypot(east, north)[east * x + north * y < -1e-12])
    if not dip.size:
        return float("nan")
    fall = np.cumsum(dip)
    return float(np.degrees(np.arctan(dip[np.searchsorted(fall, SHARE * fall[-1])])))


def _weighted(slopes: Field) -> float:
    total = float(slopes.sum())
    return float(np.degrees(np.arctan(float((slopes**2).sum()) / total))) if total > 1e-12 else float("nan")
