"""Cells that crests run through: where the surface is highest across its sharpest bend."""

from typing import Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.measures.filters import Field, Periodic, smoothed

BESIDE = 0.6
"""Cells by which a crest may lie beside the centre of its cell; above a half, so that lines have no gaps."""

SHARP = 0.1
"""Share of the root-mean-square curvature that crests are bent by at least; ours."""

HIGH = 0.5
"""Standard deviations above its surroundings that a crest reaches somewhere; ours."""

ROUND = 0.5
"""Share of the reach that the contour lines over a crest may have as their radius: flanks of a cone have
none;
ours."""

FARTHEST = 1.0
"""Cells by which a thinned line may be moved onto the crest."""


def crest_cells(
    elevation: NDArray, periodic: Periodic, width: float, reach: float
) -> tuple[NDArray[np.bool_], Field, Field]:
    """Cells of the crests, a line one cell wide, and the crest's place from their centres (rows, columns).

    A crest is where, across the direction of the strongest downward bend, the surface smoothed over ``width``
    cells is highest (Steger 1998). It lies above the mean of the square of ``2 reach + 1`` cells about it,
    and somewhere by half of the standard deviation of those differences. Next to cells of NaN there is none.
    """
    from skimage.filters import apply_hysteresis_threshold
    from skimage.morphology import skeletonize

    surface = smoothed(elevation, width, periodic)
    above = surface - local_mean(surface, reach, periodic)
    ridge, north, east = _ridges(surface, above, periodic, ROUND * reach)
    spread = float(np.std(above, where=np.isfinite(above))) if np.isfinite(above).any() else 0.0
    margin = [(8 if joined else 0,) * 2 for joined in periodic]
    wide = np.pad(np.where(ridge, above, -np.inf), margin, mode="wrap")
    raised = apply_hysteresis_threshold(wide, 0.0, HIGH * spread)  # type: ignore[no-untyped-call]
    thin = skeletonize(raised)  # type: ignore[no-untyped-call]
    rows, columns = (slice(m, thin.shape[axis] - m) for axis, (m, _) in enumerate(margin))
    return np.asarray(thin[rows, columns]), north, east


def local_mean(field: Field, reach: float, periodic: Periodic) -> Field:
    """The mean of the square of ``2 reach + 1`` cells about each cell; cells of NaN are left out."""
    modes: list[Literal["wrap", "nearest"]] = ["wrap" if joined else "nearest" for joined in periodic]
    size = [min(2 * round(reach) + 1, max(extent - (1 - extent % 2), 1)) for extent in field.shape]
    known = np.isfinite(field)
    total = scipy.ndimage.uniform_filter(np.where(known, field, 0.0), size, mode=modes)
    if known.all():
        return total
    weight = scipy.ndimage.uniform_filter(known.astype(float), size, mode=modes)
    return np.where(known, total / np.where(known, weight, 1.0), np.nan)


def _ridges(
    surface: Field, above: Field, periodic: Periodic, radius: float
) -> tuple[NDArray[np.bool_], Field, Field]:
    """Cells that a crest runs through, not yet thinned, and the crest's place from their centres.

    Contour lines bend about a crest with at most a ``radius`` (cells).
    """
    pads: list[Literal["wrap", "edge"]] = ["wrap" if joined else "edge" for joined in periodic]
    wide = np.pad(np.pad(surface, ((1, 1), (0, 0)), mode=pads[0]), ((0, 0), (1, 1)), mode=pads[1])
    south, north = wide[:-2, 1:-1], wide[2:, 1:-1]
    west, east = wide[1:-1, :-2], wide[1:-1, 2:]
    yy, xx = north - 2 * surface + south, east - 2 * surface + west
    xy = (wide[2:, 2:] + wide[:-2, :-2] - wide[2:, :-2] - wide[:-2, 2:]) / 4
    bend = (xx + yy) / 2 - np.sqrt(((xx - yy) / 2) ** 2 + xy**2)
    known = np.isfinite(bend)
    mean = float(np.sqrt(np.mean(np.square(bend, where=known, out=np.zeros_like(bend)))))
    at = np.flatnonzero(known & (bend < -SHARP * mean) & (above > 0.0))
    along_y, along_x = ((north - south) / 2).ravel()[at], ((east - west) / 2).ravel()[at]
    angle = 0.5 * np.arctan2(2 * xy.ravel()[at], (xx - yy).ravel()[at]) + np.pi / 2
    slope, bent = along_x * np.cos(angle) + along_y * np.sin(angle), bend.ravel()[at]
    step = -slope / bent
    down = along_y * np.cos(angle) - along_x * np.sin(angle)
    places = step * np.sin(angle), step * np.cos(angle)
    ridge = np.zeros(surface.size, bool)
    ridge[at] = np.maximum(np.abs(places[0]), np.abs(places[1])) <= BESIDE
    ridge[at] &= np.abs(down) <= -bent * radius
    offsets = []
    for place in places:
        offset = np.zeros(surface.size)
        offset[at] = np.clip(place, -FARTHEST, FARTHEST)
        offsets.append(offset.reshape(surface.shape))
    return ridge.reshape(surface.shape), offsets[0], offsets[1]
