"""Shadow over stacks as they are: square boxes, or prisms on a lattice of hexagons.

A line rises from a slab's own place, against the wind, and passes from cell to cell through their faces. How
far it has fallen from where it comes to a face, down to the slab, is kept for the next face of each kind, so
a cell costs a few additions. All is done in the wind's frame (see ``shadow``).
"""

import numpy as np

from barchan.kernels.core.internal import internal
from barchan.kernels.core.simd import load_at
from barchan.kernels.slabs.state import CELL

_PLACE = 1.0 / CELL

_ENDLESS = np.int64(1 << 62)


@internal(forceinline=True)
def _place_among_near(view, row, grid):
    """Where a row lies among the near rows, and how many there are; without end where all rows are near."""
    near = view.near
    if near.number == grid.rows:
        return _ENDLESS >> 1, _ENDLESS
    beside = row - near.first
    beside += grid.rows if beside < 0 else 0
    return beside, near.number


@internal(forceinline=True)
def _rows_near(view, row, grid, upwind):
    """How many rows upwind of a near row are near as well."""
    beside, near = _place_among_near(view, row, grid)
    return beside if upwind < 0 else near - 1 - beside


@internal(error_model="numpy")
def _among_squares(faces, view, along, across, here, peak, grid, width):
    rise = np.float64(peak - here)
    surface = view.now
    row, col = across >> 32, along >> 32
    across &= CELL - 1
    if faces.upwind > 0:
        across = CELL - across
    next_column = np.float64(along & (CELL - 1)) * _PLACE * faces.column_fall
    next_row = np.float64(across) * _PLACE * faces.row_fall
    rows_near = _rows_near(view, row, grid, faces.upwind)
    while True:
        if next_column <= next_row:
            fall = next_column
            next_column += faces.column_fall
            col -= 1
            if col < 0:
                if not grid.wrap_along:
                    return False
                col += grid.cols
        else:
            fall = next_row
            next_row += faces.row_fall
            row += faces.upwind
            if row < 0 or row >= grid.rows:
                if not grid.wrap_across:
                    return False
                row -= faces.upwind * grid.rows
            if rows_near == 0:
                surface = view.before
            rows_near -= 1
        if fall >= rise:
            return False
        if np.float64(load_at(surface + (row * grid.cols + col) * width, here) - here) > fall:
            return True


@internal(forceinline=True)
def _fall_to(face, along, across):
    """How far a line falls from the next face of a kind to a place in a cell, measured from its middle."""
    return face.fall * (0.5 - face.along * along - face.across * across)


@internal(error_model="numpy")
def _among_hexagons(faces, view, along, across, here, peak, grid, width):
    rise = np.float64(peak - here)
    row, col = across >> 32, along >> 32
    along_middle = np.float64(along & (CELL - 1)) * _PLACE - 0.5
    across_middle = np.float64(across & (CELL - 1)) * _PLACE - 0.5
    ahead, clockwise, anticlockwise = faces
    next_ahead = _fall_to(ahead, along_middle, across_middle)
    next_clockwise = _fall_to(clockwise, along_middle, across_middle)
    next_anticlockwise = _fall_to(anticlockwise, along_middle, across_middle)
    beside, near = _place_among_near(view, row, grid)
    while True:
        # through a face sixty degrees from another the line comes half a cell nearer to that one's kind, or
        # farther from it
        if next_ahead <= next_clockwise and next_ahead <= next_anticlockwise:
            fall, up, side = next_ahead, ahead.row, ahead.col
            next_ahead += ahead.fall
            next_clockwise += 0.5 * clockwise.fall
            next_anticlockwise += 0.5 * anticlockwise.fall
        elif next_clockwise <= next_anticlockwise:
            fall, up, side = next_clockwise, clockwise.row, clockwise.col
            next_clockwise += clockwise.fall
            next_ahead += 0.5 * ahead.fall
            next_anticlockwise -= 0.5 * anticlockwise.fall
        else:
            fall, up, side = next_anticlockwise, anticlockwise.row, anticlockwise.col
            next_anticlockwise += anticlockwise.fall
            next_ahead += 0.5 * ahead.fall
            next_clockwise -= 0.5 * clockwise.fall
        if fall >= rise:
            return False
        col += side + (row & up & 1)
        row += up
        beside += up
        if col < 0 or col >= grid.cols:
            if not grid.wrap_along:
                return False
            col += grid.cols if col < 0 else -grid.cols
        if row < 0 or row >= grid.rows:
            if not grid.wrap_across:
                return False
            row += grid.rows if row < 0 else -grid.rows
        surface = view.now if 0 <= beside < near else view.before
        if np.float64(load_at(surface + (row * grid.cols + col) * width, here) - here) > fall:
            return True


@internal(forceinline=True)
def in_box_shadow(squares, hexagons, view, along, across, here, peak, grid, width):
    """Whether a place (fixed-point cells) on top of a stack of height ``here`` lies in shadow of the stacks.

    One of ``squares`` and ``hexagons`` is None.
    """
    shaded = False
    if squares is not None:
        shaded = _among_squares(squares, view, along, across, here, peak, grid, width)
    if hexagons is not None:
        shaded = _among_hexagons(hexagons, view, along, across, here, peak, grid, width)
    return shaded
