"""The faces of boxes and prisms that shadow lines from a slab's own place meet."""

import math

from barchan.kernels.bed.state import Grid
from barchan.kernels.slabs.shadow_lines import BoxShadow, Face, HexagonFaces, SlopingTops, SquareFaces
from barchan.lattice import HEX_ROWS

_ROUNDING = 1e-9
"""Slack for winds half way between two faces."""

_PARALLEL = 1e-12
"""Sine of the angle to a face below which a line is taken to come to the next one no sooner than that."""

_NEVER = 1e300
"""A fall that no line reaches; finite, so that none of it is nothing for a place on the edge itself."""

_FACES = {
    0: (1.0, 0.0, 0, 1),
    60: (0.5, 1.0, 1, 0),
    120: (-0.5, 1.0, 1, -1),
    180: (-1.0, 0.0, 0, -1),
    240: (-0.5, -1.0, -1, -1),
    300: (0.5, -1.0, -1, 0),
}
"""Faces of a hexagon by direction (degrees anticlockwise from along): how much nearer a place is that lies
one width of a cell farther along, or one height farther across; row and column of the cell behind."""


def box_shadow(grid: Grid, angle: float, fall: float, width: int, steepest: float | None) -> BoxShadow:
    """Shadow lines of a wind at an ``angle`` (rad) to the rows, over boxes or prisms.

    Lines fall by ``fall`` units of height a cell; heights have ``width`` bytes. Tops slope across the wind by
    up to ``steepest`` units of height a cell, or are level where it is None, and along an axis, where
    a line keeps to one row, along which a slope across the wind has no steps.
    """
    tops = None if steepest is None or not angle else _sloping_tops(grid, angle, steepest)
    if grid.hexagonal:
        return BoxShadow(None, _hexagon_faces(angle, fall), tops, width)
    row_fall = fall / abs(math.sin(angle)) if angle else _NEVER
    faces = SquareFaces(fall / math.cos(angle), row_fall, 1 if angle < 0.0 else -1)
    return BoxShadow(faces, None, tops, width)


def _sloping_tops(grid: Grid, angle: float, steepest: float) -> SlopingTops:
    along, across = -math.sin(angle), math.cos(angle)
    if grid.hexagonal:
        steps = along, across * HEX_ROWS + along / 2, across * HEX_ROWS - along / 2
        thirds = steps[0] / 3, steps[1] / 3, steps[2] / 3
        reach = steepest * math.sqrt(1 / 3)
        return SlopingTops(along, across / HEX_ROWS, thirds, steepest, reach)
    reach = steepest * (abs(along) + across) / 2
    return SlopingTops(along, across, (along / 2, across / 2, 0.0), steepest, reach)


def _hexagon_faces(angle: float, fall: float) -> HexagonFaces:
    """The upwind faces: the one that lies most squarely to the wind, and its two neighbours."""
    ahead = 180
    if abs(angle) > math.pi / 6 + _ROUNDING:
        ahead += 60 if angle > 0.0 else -60
    return HexagonFaces(*(_face(way % 360, angle, fall) for way in (ahead, ahead - 60, ahead + 60)))


def _face(way: int, angle: float, fall: float) -> Face:
    along, across, row, col = _FACES[way]
    squarely = math.cos(math.pi + angle - math.radians(way))
    aside = along * math.sin(angle) - across * HEX_ROWS * math.cos(angle)
    return Face(fall / max(squarely, _PARALLEL), along, across, aside, row, col)
