"""Shadow over stacks as they are: square boxes, or prisms on a lattice of hexagons.

A line rises from a slab's own place, against the wind, and passes from cell to cell through their faces. How
far it has fallen from where it comes to a face, down to the slab, is kept for the next face of each kind, so
a cell costs a few additions. All is done in the wind's frame (see ``shadow``).

Level tops make a staircase of a slope across an oblique wind, and its steps throw shadows that a slope across
the wind does not throw. Tops may slope across the wind instead, as the surface about them does. A line passes
a cell at one distance from its middle across the wind, so each top has one height for it.
"""

import numpy as np

from barchan.kernels.core.inlining import never_inline
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
def _from_middle(place):
    """How far a place (fixed-point cells) lies from the middle of its cell, along or across."""
    return np.float64(place & (CELL - 1)) * _PLACE - 0.5


@internal(forceinline=True)
def _around(place, size, joined):
    """A row or column at most one beyond the field; negative: beyond an open edge."""
    if 0 <= place < size:
        return place
    return (place + size) % size if joined else -1


@internal(forceinline=True)
def _surface(view, place):
    """The surface in a row, by its place among the near rows and how many these are."""
    beside, near = place
    return view.now if 0 <= beside < near else view.before


@internal
def _neighbour(view, place, row, col, middle, grid, width):
    """Height of a neighbour of a cell of height ``middle``; beyond an open edge it goes on level.

    Which rows are near is counted from where the line starts, as for the cell itself: another thread may be
    at work on a row beyond the field's other edge.
    """
    row, col = _around(row, grid.rows, grid.wrap_across), _around(col, grid.cols, grid.wrap_along)
    if row < 0 or col < 0:
        return middle
    return load_at(_surface(view, place) + (row * grid.cols + col) * width, middle)


@internal(forceinline=True)
def _surface_about(view, place, row, col, grid):
    """The surface (its address) where a cell and all its neighbours are; 0: not all are in one.

    So it is at an edge of the field, and where some are seen as they are now and some as they were.
    """
    if row < 1 or row + 1 >= grid.rows or col < 1 or col + 1 >= grid.cols:
        return np.int64(0)
    beside, near = place
    if 0 < beside < near - 1:
        return np.int64(view.now)
    return np.int64(view.before) if beside < -1 or beside > near else np.int64(0)


@internal()
def _steps_about_square(view, place, row, col, middle, grid, width):
    """The steps between the neighbours of a box along and across, each of which is looked up."""
    never_inline()
    beside, near = place
    along = _neighbour(view, place, row, col + 1, middle, grid, width)
    along -= _neighbour(view, place, row, col - 1, middle, grid, width)
    across = _neighbour(view, (beside + 1, near), row + 1, col, middle, grid, width)
    across -= _neighbour(view, (beside - 1, near), row - 1, col, middle, grid, width)
    return along, across


@internal(error_model="numpy", forceinline=True)
def _rise_of_square(tops, view, place, row, col, middle, aside, grid, width):
    """How much higher the top of a box is ``aside`` of its middle, to the wind's left, than there."""
    surface = _surface_about(view, place, row, col, grid)
    if surface != 0:
        cell = surface + (row * grid.cols + col) * width
        line = grid.cols * width
        along = load_at(cell + width, middle) - load_at(cell - width, middle)
        across = load_at(cell + line, middle) - load_at(cell - line, middle)
    else:
        along, across = _steps_about_square(view, place, row, col, middle, grid, width)
    slope = np.float64(along) * tops.steps[0] + np.float64(across) * tops.steps[1]
    return min(max(slope, -tops.steepest), tops.steepest) * aside


@internal(error_model="numpy")
def _among_squares(faces, tops, view, along, across, here, peak, grid, width):
    rise = np.float64(peak - here)
    row, col = across >> 32, along >> 32
    beside, near = _place_among_near(view, row, grid)
    aside, start = 0.0, 0.0
    if tops is not None:
        aside = _from_middle(along) * tops.along + _from_middle(across) * tops.height
        start = _rise_of_square(tops, view, (beside, near), row, col, here, aside, grid, width)
        rise += tops.reach - start
    across &= CELL - 1
    if faces.upwind > 0:
        across = CELL - across
    next_column = np.float64(along & (CELL - 1)) * _PLACE * faces.column_fall
    next_row = np.float64(across) * _PLACE * faces.row_fall
    while True:
        if next_column <= next_row:
            fall = next_column
            next_column += faces.column_fall
            col -= 1
            if tops is not None:
                aside += tops.along
            if col < 0:
                if not grid.wrap_along:
                    return False
                col += grid.cols
        else:
            fall = next_row
            next_row += faces.row_fall
            row += faces.upwind
            beside += faces.upwind
            if tops is not None:
                aside -= faces.upwind * tops.height
            if row < 0 or row >= grid.rows:
                if not grid.wrap_across:
                    return False
                row -= faces.upwind * grid.rows
        if fall >= rise:
            return False
        height = load_at(_surface(view, (beside, near)) + (row * grid.cols + col) * width, here)
        above = np.float64(height - here)
        if tops is not None:
            above -= start
            most = tops.steepest * abs(aside)
            if above - most > fall:
                return True
            if above + most > fall:
                above += _rise_of_square(tops, view, (beside, near), row, col, height, aside, grid, width)
        if above > fall:
            return True


@internal(forceinline=True)
def _fall_to(face, along, across):
    """How far a line falls from the next face of a kind to a place in a cell, measured from its middle."""
    return face.fall * (0.5 - face.along * along - face.across * across)


@internal()
def _steps_about_hexagon(view, place, row, col, middle, grid, width):
    """The steps between opposite neighbours of a hexagon, eastwards, each of which is looked up."""
    never_inline()
    beside, near = place
    above, below = (beside + 1, near), (beside - 1, near)
    east, west = col + (row & 1), col - 1 + (row & 1)
    along = _neighbour(view, place, row, col + 1, middle, grid, width)
    along -= _neighbour(view, place, row, col - 1, middle, grid, width)
    eastwards = _neighbour(view, above, row + 1, east, middle, grid, width)
    eastwards -= _neighbour(view, below, row - 1, west, middle, grid, width)
    westwards = _neighbour(view, above, row + 1, west, middle, grid, width)
    westwards -= _neighbour(view, below, row - 1, east, middle, grid, width)
    return along, eastwards, westwards


@internal(error_model="numpy", forceinline=True)
def _rise_of_hexagon(tops, view, place, row, col, middle, aside, grid, width):
    """How much higher the top of a prism is ``aside`` of its middle, to the wind's left, than there."""
    surface = _surface_about(view, place, row, col, grid)
    if surface != 0:
        cell = surface + (row * grid.cols + col) * width
        northeast = cell + (grid.cols + (row & 1)) * width
        southeast = cell + ((row & 1) - grid.cols) * width
        along = load_at(cell + width, middle) - load_at(cell - width, middle)
        eastwards = load_at(northeast, middle) - load_at(southeast - width, middle)
        westwards = load_at(northeast - width, middle) - load_at(southeast, middle)
    else:
        along, eastwards, westwards = _steps_about_hexagon(view, place, row, col, middle, grid, width)
    slope = np.float64(along) * tops.steps[0]
    slope += np.float64(eastwards) * tops.steps[1] + np.float64(westwards) * tops.steps[2]
    return min(max(slope, -tops.steepest), tops.steepest) * aside


@internal(error_model="numpy")
def _among_hexagons(faces, tops, view, along, across, here, peak, grid, width):
    rise = np.float64(peak - here)
    row, col = across >> 32, along >> 32
    beside, near = _place_among_near(view, row, grid)
    along_middle, across_middle = _from_middle(along), _from_middle(across)
    aside, start = 0.0, 0.0
    if tops is not None:
        aside = along_middle * tops.along + across_middle * tops.height
        start = _rise_of_hexagon(tops, view, (beside, near), row, col, here, aside, grid, width)
        rise += tops.reach - start
    ahead, clockwise, anticlockwise = faces
    next_ahead = _fall_to(ahead, along_middle, across_middle)
    next_clockwise = _fall_to(clockwise, along_middle, across_middle)
    next_anticlockwise = _fall_to(anticlockwise, along_middle, across_middle)
    while True:
        # through a face sixty degrees from another the line comes half a cell nearer to that one's kind, or
        # farther from it
        if next_ahead <= next_clockwise and next_ahead <= next_anticlockwise:
            fall, up, side = next_ahead, ahead.row, ahead.col
            aside += ahead.aside
            next_ahead += ahead.fall
            next_clockwise += 0.5 * clockwise.fall
            next_anticlockwise += 0.5 * anticlockwise.fall
        elif next_clockwise <= next_anticlockwise:
            fall, up, side = next_clockwise, clockwise.row, clockwise.col
            aside += clockwise.aside
            next_clockwise += clockwise.fall
            next_ahead += 0.5 * ahead.fall
            next_anticlockwise -= 0.5 * anticlockwise.fall
        else:
            fall, up, side = next_anticlockwise, anticlockwise.row, anticlockwise.col
            aside += anticlockwise.aside
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
        height = load_at(_surface(view, (beside, near)) + (row * grid.cols + col) * width, here)
        above = np.float64(height - here)
        if tops is not None:
            above -= start
            most = tops.steepest * abs(aside)
            if above - most > fall:
                return True
            if above + most > fall:
                above += _rise_of_hexagon(tops, view, (beside, near), row, col, height, aside, grid, width)
        if above > fall:
            return True


@internal(forceinline=True)
def in_box_shadow(squares, hexagons, tops, view, along, across, here, peak, grid, width):
    """Whether a place (fixed-point cells) on top of a stack of height ``here`` lies in shadow of the stacks.

    One of ``squares`` and ``hexagons`` is None, and ``tops`` is where tops are level.
    """
    if tops is None and peak <= here:
        return False
    shaded = False
    if squares is not None:
        shaded = _among_squares(squares, tops, view, along, across, here, peak, grid, width)
    if hexagons is not None:
        shaded = _among_hexagons(hexagons, tops, view, along, across, here, peak, grid, width)
    return shaded
