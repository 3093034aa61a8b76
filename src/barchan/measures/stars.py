"""Star dunes: summits, the arms that lead up to them, and how steep they are at the top and at the foot."""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.measures.filters import Field, Periodic, gradient, smoothed

REACH = 5.0
"""How far from a summit its arms are looked for, over its height above the mean surface; ours."""

NEAREST = 2.0
"""Cells within which no arm can be seen."""

DIRECTIONS = 72
"""Directions about a summit that are looked at."""

PROMINENCE = 0.1
"""An arm rises above the hollows beside it by this share of its summit's height at least; ours."""


@dataclass(frozen=True)
class Summit:
    """A place higher than all around it."""

    row: int
    column: int
    height: float
    """Height (m) above the mean surface."""
    arms: int
    """Ridges that lead away from it: 2 on a straight ridge, 3 and more for a star dune."""
    top_slope: float
    """Mean slope (degrees) of the upper third of its relief."""
    foot_slope: float
    """Mean slope (degrees) of the lowest third of its relief."""


def summits(
    elevation: NDArray, cell_size: float, periodic: Periodic = (True, True), width: float = 2.0
) -> list[Summit]:
    """The summits of a surface smoothed over ``width`` cells, the highest first.

    A summit is the highest within five times its height above the mean surface; it stands above the mean by
    the surface's standard deviation or more. Arms are maxima of the mean elevation along rays from a half to
    the whole of that distance. Summits whose surroundings go beyond an open edge or hold
    a cell of NaN, or are nearer than two cells, are left out.
    """
    surface = smoothed(elevation, width, periodic)
    known = np.isfinite(surface)
    if not known.any():
        return []
    surface -= surface.mean(where=known)
    east, north = gradient(smoothed(elevation, 1.0, periodic), cell_size, periodic)
    slope = np.hypot(east, north)
    least = float(surface.std(where=known))
    surface = np.where(known, surface, -np.inf)
    found: list[Summit] = []
    peaks = (surface >= scipy.ndimage.maximum_filter(surface, 3, mode="wrap")) & (surface > max(least, 1e-9))
    for row, column in sorted(np.argwhere(peaks).tolist(), key=lambda at: -surface[at[0], at[1]]):
        height = float(surface[row, column])
        reach = REACH * height / cell_size
        if reach < NEAREST:
            continue
        disc = _disc(surface.shape, row, column, reach, periodic)
        if disc is not None and np.isfinite(slope[disc]).all() and height >= surface[disc].max():
            arms = _arms(surface, row, column, reach, height)
            found.append(Summit(row, column, height, arms, *_slopes(surface[disc], slope[disc])))
    return found


def _disc(
    shape: tuple[int, ...], row: int, column: int, reach: float, periodic: Periodic
) -> tuple[NDArray[np.int64], NDArray[np.int64]] | None:
    """Cells within a distance (cells); None where they lie beyond an open edge or meet themselves."""
    size = int(np.ceil(reach))
    for at, cells, joined in zip((row, column), shape, periodic, strict=True):
        if 2 * size >= cells or not (joined or size <= at < cells - size):
            return None
    rows, columns = np.mgrid[-size : size + 1, -size : size + 1]
    near = np.hypot(rows, columns) <= reach
    return (rows[near] + row) % shape[0], (columns[near] + column) % shape[1]


def _arms(surface: Field, row: int, column: int, reach: float, height: float) -> int:
    """How many ridges lead away from a summit."""
    angle = np.arange(DIRECTIONS) * (2 * np.pi / DIRECTIONS)
    distance = np.linspace(reach / 2, reach, max(int(reach), 2))
    places = np.stack([row + np.outer(np.sin(angle), distance), column + np.outer(np.cos(angle), distance)])
    mean = scipy.ndimage.map_coordinates(surface, places, order=1, mode="grid-wrap").mean(axis=1)
    from scipy.signal import find_peaks  # takes a second to load

    turned = np.roll(mean, -int(np.argmin(mean)))
    return len(find_peaks(np.append(turned, turned[0]), prominence=PROMINENCE * height)[0])


def _slopes(surface: Field, slope: Field) -> tuple[float, float]:
    """Mean slopes (degrees) of the upper and of the lowest third of a relief."""
    low, high = surface.min(), surface.max()
    share = (surface - low) / (high - low)
    top, foot = slope[share > 2 / 3].mean(), slope[share < 1 / 3].mean()
    return float(np.degrees(np.arctan(top))), float(np.degrees(np.arctan(foot)))
