"""Fields of a lattice of hexagons brought onto squares, for what works on squares: spectra, maps, files.

The squares have the width of the hexagons. As many rows of them cover the field as come nearest to its
height, so their own height differs from their width by half a row over the whole field at most; it
counts as one with the width. On a lattice of squares every field stays as it is.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.lattice import HEX_ROWS, Lattice
from barchan.measures.bedform_surface import bedform_surface


@dataclass(frozen=True)
class Squares:
    """The squares that cover a lattice's field."""

    true: Lattice
    """The lattice that fields come from."""

    @cached_property
    def lattice(self) -> Lattice:
        """The lattice of squares."""
        if not self.true.hexagonal:
            return self.true
        rows = max(1, round(self.true.rows * HEX_ROWS))
        return self.true.model_copy(update={"kind": "square", "rows": rows})

    def between(self, values: NDArray) -> NDArray:
        """A field (its last axes rows and columns) interpolated linearly: along the rows, then between them.

        What has no fractions, such as counts or yes and no, has the value of the cell that covers the centre.
        """
        if not self.true.hexagonal:
            return values
        if values.dtype.kind != "f":
            return values[..., *self._covering]
        lined_up = np.array(values)
        odd = values[..., 1::2, :]
        west = np.roll(odd, 1, -1)
        if self.true.boundary_x == "open":
            west[..., 0] = odd[..., 0]
        lined_up[..., 1::2, :] = 0.5 * (odd + west)
        lower, upper, share = self._rows
        return lined_up[..., lower, :] * (1.0 - share[:, None]) + lined_up[..., upper, :] * share[:, None]

    @cached_property
    def _rows(self) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64]]:
        """The rows below and above the centres of each row of squares, and the share of the upper one."""
        rows, count = self.true.rows, self.lattice.rows
        place = (np.arange(count) + 0.5) * rows / count - 0.5
        lower = np.floor(place).astype(np.int64)
        share = place - lower
        if self.true.boundary_y == "periodic":
            return lower % rows, (lower + 1) % rows, share
        return np.clip(lower, 0, rows - 1), np.clip(lower + 1, 0, rows - 1), share

    @cached_property
    def _covering(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Row and column of the cell whose centre is nearest to that of each square."""
        lower, upper, share = self._rows
        columns = np.arange(self.true.columns)
        # centres of even rows lie over those of the squares, those of odd rows half a cell beside them
        away = [
            np.hypot(0.5 * (rows % 2), HEX_ROWS * part)
            for rows, part in ((lower, share), (upper, 1.0 - share))
        ]
        rows = np.where(away[0] <= away[1], lower, upper)
        return np.broadcast_to(rows[:, None], self.lattice.shape), np.broadcast_to(
            columns, self.lattice.shape
        )


def bedforms_of(bed: Bed) -> NDArray[np.float64]:
    """Elevation (m) of the bedforms, without the relief of uneven ground, on squares; NaN on rock."""
    squares = Squares(bed.lattice)
    ground, depth = squares.between(bed.ground), squares.between(bed.depth)
    return bedform_surface(ground, depth, bed.lattice.cell_size, bed.lattice.periodic)
