"""The surface that bedforms make, without the relief of the ground under them."""

import math

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.measures.dunes import bodies_of
from barchan.measures.filters import Field, Periodic

ROCK = math.tan(math.radians(15.0))
"""Bare ground that rises more steeply than this from the nearest sand is rock that stands in it; ours."""

REACH = 32
"""Cells over joined edges within which the nearest sand is looked for."""


def bedform_surface(
    ground: NDArray, depth: NDArray, cell_size: float, periodic: Periodic = (True, True)
) -> Field:
    """Elevation (m) of the bedforms on a ground (m) that is covered by a ``depth`` (m) of sand.

    On level ground it is the elevation. On uneven ground it is the depth of the sand where that varies no
    more than the elevation does, from one cell with sand to another: sand that drapes the ground. Where the
    elevation varies less, the sand has filled the ground's hollows, and it is the elevation.

    Rock is NaN: cells without sand that rise more steeply than 15 degrees from the nearest sand, and all of a
    bare body most of whose cells do. So are cells of unknown ground.
    """
    level, height = np.asarray(ground, float), np.asarray(depth, float)
    if is_level(level):
        return level + height
    elevation, sandy = level + height, height > 0.0
    if not sandy.any():
        return np.where(np.isfinite(level), 0.0, np.nan)
    known = sandy & np.isfinite(level)
    drapes = not known.any() or height[known].var() <= elevation[known].var()
    surface = height + 0.0 * level if drapes else elevation
    return np.where(_rock(level, elevation, sandy, cell_size, periodic), np.nan, surface)


def is_level(ground: NDArray) -> bool:
    """Whether all of the ground is known and as high everywhere."""
    return bool(np.isfinite(ground).all() and np.ptp(ground) <= 1e-9 * max(1.0, float(np.abs(ground).max())))


def is_steep(ground: NDArray, cell_size: float) -> bool:
    """Whether the ground rises anywhere as steeply as rock does from sand, so that it can hold sand."""
    steps = (np.abs(np.diff(np.asarray(ground, float), axis=axis)) for axis in (0, 1))
    return any(bool((step > ROCK * cell_size).any()) for step in steps)


def _rock(
    ground: Field, elevation: Field, sandy: NDArray[np.bool_], cell_size: float, periodic: Periodic
) -> NDArray[np.bool_]:
    """Bare cells that rise steeply from the nearest cell with sand, and bodies of mostly such cells."""
    if sandy.all():
        return np.zeros(sandy.shape, bool)
    margins = [
        (min(REACH, size),) * 2 if p else (0, 0) for size, p in zip(sandy.shape, periodic, strict=True)
    ]
    wide = np.pad(sandy, margins, mode="wrap")
    distance, nearest = scipy.ndimage.distance_transform_edt(~wide, return_indices=True)
    inside = tuple(slice(first, first + size) for (first, _), size in zip(margins, sandy.shape, strict=True))
    rows, columns = (
        (at[inside] - first) % size
        for at, (first, _), size in zip(nearest, margins, sandy.shape, strict=True)
    )
    steep = ~sandy & (ground - elevation[rows, columns] > ROCK * cell_size * distance[inside])
    bodies = bodies_of(~sandy, periodic)
    cells = np.bincount(bodies.ravel())
    mostly = np.bincount(bodies.ravel(), steep.ravel()) > 0.5 * cells
    return np.asarray(steep | (~sandy & mostly[bodies]))
