"""How high dunes stand, from the crest to the toe of the lee side."""

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.filters import Field, Periodic, smoothed, without_trend


def crest_to_toe_height(
    elevation: NDArray, direction: float, periodic: Periodic = (True, True), width: float = 1.0
) -> float:
    """Height (m) of bedforms from crest to toe, along a wind from ``direction`` (degrees).

    The surface, without its trend towards open edges and smoothed over ``width`` cells, is cut into profiles
    along the wind, a cell apart. Each profile is cut where it rises through the mean surface; from one such
    place to the next lies one bedform, whose height is that of its highest over its lowest point. Heights are
    averaged with themselves as weights, so that ripples and single slabs beside dunes count little. Bedforms
    that meet cells of NaN or an open edge are left out. NaN where there is none.
    """
    surface = smoothed(without_trend(elevation, periodic), width, periodic)
    known = np.isfinite(surface)
    if not known.any():
        return float("nan")
    surface = surface - surface.mean(where=known)
    heights = _heights(profiles(surface, direction, periodic))
    rounding = 1e-9 * max(1.0, float(np.abs(np.asarray(elevation, float)[known]).max()))
    heights = heights[heights > rounding]
    return float((heights**2).sum() / heights.sum()) if heights.size else float("nan")


def profiles(field: Field, direction: float, periodic: Periodic) -> Field:
    """A field along lines downwind, a cell apart: [line, place]; NaN beyond edges that are not joined.

    Where the edges that the lines meet are joined they go through the field twice, so that every bedform lies
    whole on a line. Values between cells are linear.
    """
    rows, columns = field.shape
    x, y = downwind(direction)
    x, y = round(x, 12), round(y, 12)
    length = round(abs(x) * columns + abs(y) * rows)
    count = round(abs(x) * rows + abs(y) * columns)
    closed = all(joined or part == 0.0 for joined, part in zip(periodic, (y, x), strict=True))
    along = np.arange(2 * length if closed else length) - (length - 1) / 2
    across = np.arange(count) - (count - 1) / 2
    north = (rows - 1) / 2 + np.add.outer(across * x, along * y)
    east = (columns - 1) / 2 + np.add.outer(-across * y, along * x)
    places = np.stack([north, east])
    values = scipy.ndimage.map_coordinates(field, places, order=1, mode="grid-wrap")
    for at, size, joined in zip(places, field.shape, periodic, strict=True):
        if not joined:
            values[(at < -1e-9) | (at > size - 1 + 1e-9)] = np.nan
    return values


def _heights(lines: Field) -> Field:
    """Heights of the bedforms on lines, each from one rise through zero to the next."""
    flat = np.pad(lines, ((0, 0), (0, 1)), constant_values=np.nan).ravel()
    rises = np.flatnonzero((flat[:-1] <= 0.0) & (flat[1:] > 0.0)) + 1
    if rises.size < 2:
        return np.zeros(0)
    highest, lowest = (part.reduceat(flat, rises)[:-1] for part in (np.maximum, np.minimum))
    heights = highest - lowest
    return heights[np.isfinite(heights)]
