"""How rough a surface is: heights about its smoothed self, and the area that it turns to the wind."""

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.filters import Periodic, smoothed


def roughness(elevation: NDArray, periodic: Periodic = (True, True), scale: float = 2.0) -> float:
    """Root-mean-square height (m) of a surface about itself smoothed over ``scale`` cells.

    It holds what is smaller than about six times the scale, the width of the filter's pass: slabs and ripples
    on dunes, or the noise of a survey. Cells of NaN are left out. 0 on a plane without open edges.
    """
    rest = np.asarray(elevation, float) - smoothed(elevation, scale, periodic)
    known = np.isfinite(rest)
    return float(np.sqrt(np.mean(rest[known] ** 2))) if known.any() else float("nan")


def frontal_area_index(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
    width: float = 0.5,
) -> float:
    """Area that rises against a wind from ``direction`` (degrees), per area of ground (Raupach 1992).

    The mean of the rises from cell to cell downwind, of the surface smoothed over ``width`` cells, over the
    width of a cell: height over spacing for ridges across the wind. Cells of NaN are left out.
    """
    surface, (x, y) = smoothed(elevation, width, periodic), downwind(direction)
    x, y = round(x, 12), round(y, 12)
    ahead = scipy.ndimage.shift(surface, (-y, -x), order=1, mode="grid-wrap")
    if y and not periodic[0]:
        ahead[-1 if y > 0 else 0] = np.nan
    if x and not periodic[1]:
        ahead[:, -1 if x > 0 else 0] = np.nan
    rises = (ahead - surface) / cell_size
    known = np.isfinite(rises)
    return float(np.maximum(rises[known], 0.0).mean()) if known.any() else float("nan")
