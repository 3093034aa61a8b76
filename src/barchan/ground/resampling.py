"""Heights of a file on cells of another size: means over larger cells, linear between smaller ones."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice

if TYPE_CHECKING:
    from scipy.sparse import csr_array


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


def _shares(count: int, available: int, step: float) -> "csr_array":
    """The share that each of the file's cells (columns) has in each of ours (rows), along one axis."""
    return _overlaps(count, available, step) if step > 1.0 else _between(count, available, step)


def _overlaps(count: int, available: int, step: float) -> "csr_array":
    """Parts of each of our cells that the file's cells cover; beyond the file's edge its last cell does."""
    from scipy.sparse import coo_array

    first = np.arange(count) * step
    reach = int(np.ceil(step)) + 1
    cell = np.floor(first).astype(np.int64)[:, None] + np.arange(reach)
    length = np.minimum(cell + 1.0, first[:, None] + step) - np.maximum(cell, first[:, None])
    row = np.repeat(np.arange(count), reach)
    column = np.clip(cell.ravel(), 0, available - 1)
    shares = coo_array((np.maximum(length, 0.0).ravel() / step, (row, column)), shape=(count, available))
    return shares.tocsr()


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
