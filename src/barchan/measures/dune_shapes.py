"""The size and shape of single dunes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.measures.dunes import Dune
from barchan.measures.filters import Field
from barchan.measures.horns import horns

SMALLEST = 4
"""Cells below which a dune has no shape of its own."""


@dataclass(frozen=True)
class DuneShape:
    """A dune in metres; lengths along and across a wind, directions clockwise from north."""

    row: float
    column: float
    """Its centre of volume (cells, from the centre of the south-western cell)."""
    area: float
    """Area of its outline (m²)."""
    volume: float
    """Volume of the sand within its outline, down to the floor (m³)."""
    height: float
    """Greatest depth of its sand (m), smoothed, above the floor."""
    width: float
    """Extent across the wind (m)."""
    length: float
    """Extent along the wind (m)."""
    orientation: float
    """Direction of its long axis (degrees in [0, 180)); NaN where no direction is longer than another."""
    elongation: float
    """Long axis over short axis of the ellipse with the moments of its outline, 1 for a round dune."""
    left_horn: float
    """Length (m) of the horn to the left of the wind; negative where that side stays back."""
    right_horn: float
    asymmetry: float
    """How much farther the left horn reaches than the right one, over the width."""
    horn_direction: float
    """Direction (degrees) that its horns point in, from the dune towards its bay; NaN without a bay."""
    bay: float
    """Share of the area of the outline's convex hull that lies outside of the dune."""


def dune_shape(dune: Dune, direction: float, cell_size: float) -> DuneShape:
    """Size and shape of a dune in a wind from ``direction`` (degrees).

    Horns are those of ``horns``. The direction of the horns needs no wind: it points from the centre of the
    dune's area to the centre of what its convex hull adds to it, the bay between its horns.
    """
    sand = dune.depth + dune.level
    sides = horns(dune, direction, cell_size)
    orientation, elongation = long_axis(dune.rows, dune.columns)
    share, pointing = bay_of(dune.rows, dune.columns)
    return DuneShape(
        row=float(np.average(dune.rows, weights=sand)),
        column=float(np.average(dune.columns, weights=sand)),
        area=dune.cells * cell_size**2,
        volume=float(sand.sum()) * cell_size**2,
        height=float(sand.max()),
        width=sides.width,
        length=sides.length,
        orientation=orientation,
        elongation=elongation,
        left_horn=sides.left,
        right_horn=sides.right,
        asymmetry=sides.slant,
        horn_direction=pointing,
        bay=share,
    )


def long_axis(rows: NDArray, columns: NDArray) -> tuple[float, float]:
    """Direction (degrees clockwise from north, in [0, 180)) of the long axis of cells, and its elongation.

    Of the ellipse with the second moments of the cells, each a square; the elongation is 1 where no direction
    is longer, and the direction then NaN.
    """
    yy, xx = float(rows.var()) + 1 / 12, float(columns.var()) + 1 / 12
    xy = float(((rows - rows.mean()) * (columns - columns.mean())).mean())
    mean, apart = (xx + yy) / 2, float(np.hypot((xx - yy) / 2, xy))
    elongation = float(np.sqrt((mean + apart) / (mean - apart)))
    if apart <= 1e-9 * mean:
        return float("nan"), 1.0
    axis = np.degrees(0.5 * np.arctan2(2 * xy, xx - yy))
    return float((90.0 - axis) % 180.0 % 180.0), elongation


LEAST_BAY = 0.05
"""Share of the convex hull below which what lies outside of a dune is the raggedness of its outline; ours."""

ONE_SIDED = 0.4
"""Distance of the centre of what the hull adds from the dune's centre, over the radius of a disc of its area,
below which that lies all round, as where an outline is ragged. Of 60 discs each with ragged outlines, 6 to 20
cells in radius, 95 % stay below 0.37; of crescents it is 0.5 to 0.7. The limit is ours."""

PLAIN = 0.2
"""Share of the hull from which on a bay is no raggedness wherever it lies: joined dunes have several."""


def bay_of(rows: NDArray, columns: NDArray) -> tuple[float, float]:
    """The share of their convex hull that cells leave free, and the direction (degrees) towards it.

    The direction is NaN where the share is below 5 %, and below 20 % where it does not lie to one side of the
    cells.
    """
    from scipy.spatial import ConvexHull

    if len(rows) < SMALLEST:
        return 0.0, float("nan")
    north, east = _rim(rows, columns)
    corners = np.concatenate(
        [np.stack([east + a, north + b], axis=1) for a in (-0.5, 0.5) for b in (-0.5, 0.5)]
    )
    hull = corners[ConvexHull(corners).vertices]
    area, centre = _polygon(hull)
    own = np.array([columns.mean(), rows.mean()])
    share = float(max(1.0 - len(rows) / area, 0.0))
    if share < LEAST_BAY:
        return share, float("nan")
    x, y = (centre - own) / share  # from the centre of the cells to that of what the hull adds
    one_sided = np.hypot(x, y) >= ONE_SIDED * np.sqrt(len(rows) / np.pi)
    points = one_sided or share >= PLAIN
    return share, float(np.degrees(np.arctan2(x, y)) % 360.0) if points else float("nan")


def _rim(rows: NDArray, columns: NDArray) -> tuple[NDArray, NDArray]:
    """The first and the last cell in each row: no others lie on the convex hull."""
    order = np.lexsort((columns, rows))
    north, east = rows[order], columns[order]
    new = np.diff(north) != 0
    ends = np.concatenate([[True], new]) | np.concatenate([new, [True]])
    return north[ends], east[ends]


def _polygon(corners: Field) -> tuple[float, Field]:
    """Area and centre of a polygon whose corners are in counter-clockwise order."""
    following = np.roll(corners, -1, axis=0)
    cross = corners[:, 0] * following[:, 1] - following[:, 0] * corners[:, 1]
    area = float(cross.sum()) / 2
    centre = ((corners + following) * cross[:, None]).sum(axis=0) / (6 * area)
    return area, np.asarray(centre)


def outline(dune: Dune) -> list[Field]:
    """Rings around a dune, [place, (row, column)] in cells: the outer one first, then those of its holes.

    They run half-way between the centres of its cells and of their neighbours, and end where they began.
    """
    from skimage.measure import find_contours

    south, west = int(dune.rows.min()) - 1, int(dune.columns.min()) - 1
    mask = np.zeros((int(np.ptp(dune.rows)) + 3, int(np.ptp(dune.columns)) + 3))
    mask[dune.rows - south, dune.columns - west] = 1.0
    traced = find_contours(mask, 0.5, fully_connected="high")  # type: ignore[no-untyped-call]
    rings = [ring + np.array([south, west]) for ring in traced]
    return sorted(rings, key=lambda ring: -float(np.ptp(ring[:, 0]) * np.ptp(ring[:, 1])))
