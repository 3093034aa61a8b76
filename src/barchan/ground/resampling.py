"""Heights of a file on cells of another size: means over larger cells, linear between smaller ones."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice

if TYPE_CHECKING:
    from scipy.sparse import csr_array

WHOLE = 0.01
"""Cells by which our last border may miss one of the file's, for the file's cells to count as whole."""


def resampled(
    heights: NDArray[np.float64], step_y: float, step_x: float, lattice: Lattice
) -> NDArray[np.float64]:
    """Heights on the lattice's cells, whose sides are ``step_y`` and ``step_x`` of the file's cells.

    The first cells begin at the file's south-west corner. A cell that is larger than the file's has the
    mean height of the area that it covers, so no waves appear that are not there; a smaller one has the
    height at its centre, linear between the centres of the file's cells.
    """
    rows, columns = heights.shape
    along = _shares(lattice.rows, rows, step_y)
    across = _shares(lattice.columns, columns, step_x)
    return np.asarray((across @ (along @ heights).T).T)


def with_volume_kept(
    field: NDArray[np.float64], shape: tuple[int, int], periodic: tuple[bool, bool]
) -> NDArray[np.float64]:
    """A field on as many rows and columns over the same area, its mean the same but for rounding.

    Each new cell has the mean over its area: of the old cells where a whole number of them fits in, elsewhere
    of values that are linear between their centres. Across periodic edges (south to north, west to east) the
    field goes on with its other side.
    """
    for axis in (0, 1):
        count, available = shape[axis], field.shape[axis]
        if count != available:
            weights = _means(count, available, available / count, periodic[axis])
            field = weights @ field if axis == 0 else (weights @ field.T).T
    return np.asarray(field)


def _shares(count: int, available: int, step: float) -> "csr_array":
    """The share that each of the file's cells (columns) has in each of ours (rows), along one axis."""
    return _means(count, available, step) if step > 1.0 else _between(count, available, step)


def _means(count: int, available: int, step: float, joined: bool = False) -> "csr_array":
    """Weights of the file's cells in the mean over each of ours.

    At the file's edge its last cell goes on, or where edges are ``joined`` those of the other side.

    Where ours begin and end between two of the file's cells, the mean is that of the cells; elsewhere it is
    that of the heights between their centres, which keeps a slope free of steps.
    """
    from scipy.sparse import coo_array

    whole = abs(step - round(step)) * count < WHOLE
    up_to = _within_cell if whole else _between_centres
    first = np.arange(count) * step - 0.5
    reach = int(np.ceil(step)) + 3
    cell = np.floor(first).astype(np.int64)[:, None] - 1 + np.arange(reach)
    weight = up_to(first[:, None] + step - cell) - up_to(first[:, None] - cell)
    row = np.repeat(np.arange(count), reach)
    column = cell.ravel() % available if joined else np.clip(cell.ravel(), 0, available - 1)
    return coo_array((weight.ravel() / step, (row, column)), shape=(count, available)).tocsr()


def _within_cell(place: NDArray[np.float64]) -> NDArray[np.float64]:
    """The part of a cell that lies before a place, counted in cells from its centre."""
    return np.clip(place + 0.5, 0.0, 1.0)


def _between_centres(place: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same of a cell whose height falls off linearly to the centres of its neighbours."""
    place = np.clip(place, -1.0, 1.0)
    return np.where(place < 0, 0.5 * (1.0 + place) ** 2, 1.0 - 0.5 * (1.0 - place) ** 2)


def _between(count: int, available: int, step: float) -> "csr_array":
    """Weights of the two cells of the file on either side of each of our centres; at its edge of the last."""
    from scipy.sparse import coo_array

    centre = np.clip((np.arange(count) + 0.5) * step - 0.5, 0.0, available - 1.0)
    below = np.minimum(np.floor(centre).astype(np.int64), max(available - 2, 0))
    above = np.minimum(below + 1, available - 1)
    part = centre - below
    row, column = np.tile(np.arange(count), 2), np.concatenate([below, above])
    weights = np.concatenate([1.0 - part, part])
    return coo_array((weights, (row, column)), shape=(count, available)).tocsr()
