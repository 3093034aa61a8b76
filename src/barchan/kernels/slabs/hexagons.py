"""Places on a hexagonal lattice, in the wind's frame: which cell a slab comes down on.

The cells of a row stand side by side; odd rows lie half a cell farther along, and rows three quarters of a
cell's height apart. A position is kept as on a square lattice: the column and the row in the upper halves
of two numbers, the place within the cell in the lower ones, along in 1/``CELL`` of a cell's width, across in
1/``CELL`` of its height from the lowest corner to the highest. So hops across are in heights of a cell.
"""

from barchan.kernels.core.internal import internal
from barchan.kernels.slabs.state import CELL

MIDDLE = CELL >> 1
"""The place of a cell's centre, along and across."""

ROW = 3 * (CELL >> 2)
"""Distance between two rows, in 1/``CELL`` of a cell's height."""

_CORNER = CELL >> 2
_WITHIN = CELL - 1


@internal(forceinline=True)
def cell_about(along, across):
    """The cell around a point: its row and column (both perhaps beyond the field), and the place within.

    The point is measured from the lower left end of the first row: the lowest quarter of a cell lies between
    the highest quarters of two cells of the row below.
    """
    row = across // ROW
    above = across - row * ROW
    east = along - ((row & 1) << 31)
    if above < _CORNER and 2 * above < abs((east & _WITHIN) - MIDDLE):
        row -= 1
        above += ROW
        east = along - ((row & 1) << 31)
    return row, east >> 32, east & _WITHIN, above


@internal(forceinline=True)
def cell_after(along, across, hop_along, hop_across):
    """The cell where a hop from a position ends, perhaps beyond the field, and the place within."""
    row = across >> 32
    east = along + ((row & 1) << 31) + hop_along
    return cell_about(east, row * ROW + (across & _WITHIN) + hop_across)


@internal(forceinline=True)
def position(row, col, beside, above, grid):
    """The position at a place in a cell, brought back into the field; negative where it lies outside."""
    if row < 0 or row >= grid.rows:
        if not grid.wrap_across:
            return -1, -1
        row %= grid.rows
    if col < 0 or col >= grid.cols:
        if not grid.wrap_along:
            return -1, -1
        col %= grid.cols
    return col << 32 | beside, row << 32 | above


@internal(forceinline=True)
def place_within(high, low):
    """A place within a cell, all equally likely, from two random numbers of 32 bits."""
    _, _, beside, above = cell_about(high, (low * 3) >> 2)
    return beside, above
