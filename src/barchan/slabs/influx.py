"""Influx of slab models: from a share of the flux, or a number of slabs, to means by cell of an edge."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.kernels.slabs.state import EdgeInflux
from barchan.lattice import Lattice
from barchan.wind.frame import WindFrame
from barchan.wind.segment import Segment

INFLUX = 5
"""Number of the random sequences of influx under the key of a step."""

_NONE: NDArray[np.float64] = np.zeros(0)


def edge_influx(
    segment: Segment, saturated: Callable[[], float], lattice: Lattice, frame: WindFrame
) -> EdgeInflux | None:
    """Mean number of slabs that enter in a step at each cell of the open upwind edges, in the wind's frame.

    None where the wind brings nothing in.

    ``saturated`` gives the number that crosses a cell's width square to the wind on a flat bed of sand. An
    edge that lies obliquely to the wind is crossed by less of it, in proportion to the cosine.
    """
    if segment.influx is None:
        return None
    number = segment.influx.slabs_per_row(saturated, segment.share)
    row_width = lattice.row_spacing / lattice.cell_size
    x, y = downwind(segment.direction)
    at_x, at_y = np.zeros((2, *lattice.shape))
    at_x[:, 0 if x > 0 else -1] = number * row_width * abs(x) * segment.influx.along_edge(lattice.rows)
    at_y[0 if y > 0 else -1, :] = number * abs(y) * segment.influx.along_edge(lattice.columns)
    open_y, open_x = (not joined for joined in lattice.periodic)
    first, second = (at_y, at_x) if frame.crossed else (at_x, at_y)
    first_open, second_open = (open_y, open_x) if frame.crossed else (open_x, open_y)
    row = 0 if frame.angle > 0.0 else -1
    along = frame.enter(first)[:, 0] if first_open else _NONE
    across = frame.enter(second)[row, :] if second_open and frame.angle != 0.0 else _NONE
    return EdgeInflux(np.ascontiguousarray(along), np.ascontiguousarray(across))


def slabs_in(influx: EdgeInflux | None) -> float:
    """Mean number of slabs that enter in a step across all edges."""
    return 0.0 if influx is None else float(influx.along.sum() + influx.across.sum())
