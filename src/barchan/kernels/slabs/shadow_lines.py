"""Shadow lines under one wind, as data. Nothing here imports the compiler."""

from typing import NamedTuple


class AxisShadow(NamedTuple):
    """Shadow lines of a wind along a lattice axis."""

    falls: int
    """Address of how far the line has fallen: ``d`` cells downwind at index ``size - d``."""
    size: int
    shift: int
    """Binary places of a height below one slab."""
    reach: int
    """Cells, in 2**-16, that a line of one slab's height reaches downwind, rounded up."""
    width: int
    """Bytes of one height."""


class RayShadow(NamedTuple):
    """Shadow lines of an oblique wind; entry ``k`` is where the ray crosses the column ``k + 1`` upwind.

    Of hexagons it is where the ray crosses the ``k + 1``-th upwind line of the lattice, of those lines of
    cells that lie most squarely across the wind.
    """

    rows: int
    """Address of the row of the cell below the crossing, relative to the sheltered cell (int64)."""
    weights: int
    """Address of the share of the next row's cell in the height at the crossing (float64)."""
    falls: int
    """Address of how far the line has fallen from the crossing to the sheltered cell (float64)."""
    near: int
    """Address of how many crossings lie at most so many rows away: none, one and so on (int64)."""
    rises: bool
    """Whether the ray goes towards growing rows."""
    size: int
    width: int
    cells: int
    """Address of the two cells about each crossing, flat, relative to the sheltered one (int64); of
    hexagons first where that lies in an even row, then where it lies in an odd one."""
    inside: int
    """Address of how many crossings lie in the field's columns, by the sheltered cell's column (int64)."""
    cols: int = 0
    """Of hexagons: address of the column of that cell, relative to the sheltered one (int64); first where the
    sheltered cell lies in an even row, then where it lies in an odd one."""
    next_row: int = 1
    """Of hexagons: row and column of the second cell of a crossing, relative to the first; in the next row
    half a cell less than the column's number says."""
    next_col: int = 0


class SquareFaces(NamedTuple):
    """The faces of square boxes that a shadow line meets on its way upwind."""

    column_fall: float
    """How far a line falls from one column's upwind edge to the next."""
    row_fall: float
    """How far it falls from one row's upwind edge to the next; along an axis more than any stack is high."""
    upwind: int
    """Upwind across the rows: -1 or 1."""


class Face(NamedTuple):
    """A face of a hexagon, one of the three through which shadow lines leave upwind."""

    fall: float
    """How far a line falls from one face of this kind to the next."""
    along: float
    """How much nearer (widths of a cell) a place is that lies a width of a cell farther along."""
    across: float
    """The same of a place that lies a height of a cell farther across."""
    aside: float
    """How much farther to the wind's left of the middle a line lies in the hexagon behind it."""
    row: int
    """Row of the cell behind it, relative to the cell."""
    col: int
    """Column of that cell, relative to the cell in an even row; from an odd row to another it is one more."""


class HexagonFaces(NamedTuple):
    """The faces of hexagons that a shadow line meets on its way upwind, sixty degrees apart."""

    ahead: Face
    """The one that lies most squarely to the wind."""
    clockwise: Face
    """The next one clockwise."""
    anticlockwise: Face


class SlopingTops(NamedTuple):
    """Tops of stacks that slope across the wind as the surface about them does, and are level along it."""

    along: float
    """How much farther to the wind's left (widths of a cell) a place one column farther along lies."""
    height: float
    """The same of a place that is the height of a cell farther across; of squares that is a row."""
    steps: tuple[float, float, float]
    """What a step of one between opposite neighbours adds to the slope: along and across; of hexagons along,
    and in the directions 60 and 120 degrees anticlockwise from it."""
    steepest: float
    """Slope (height over a width of a cell) that no top exceeds."""
    reach: float
    """Height by which no point of a top is above its middle."""


class BoxShadow(NamedTuple):
    """Shadow lines over stacks as the boxes or prisms that they are, from a slab's own place in its cell."""

    squares: SquareFaces | None
    """One of ``squares`` and ``hexagons`` is None."""
    hexagons: HexagonFaces | None
    tops: SlopingTops | None
    """None: level tops."""
    width: int
    """Bytes of one height."""
