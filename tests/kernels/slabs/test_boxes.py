"""Shadow over boxes and prisms: walls and stacks whose shadows are known from geometry alone."""

import math

import numpy as np
import pytest

from barchan.bed import Bed
from barchan.kernels.slabs.shadow import in_shadow
from barchan.kernels.slabs.state import CELL, Rows, View
from barchan.lattice import HEX_ROWS, Lattice
from barchan.slabs.arguments import build
from barchan.slabs.parameters import ActingRules, SlabParameters
from barchan.slabs.rules import Rules
from barchan.slabs.stacks import stacks_of
from barchan.wind.frame import WindFrame
from tests.kernels.slabs.test_shadow import LEVEL, zone
from tests.kernels.slabs.test_step import rough_bed

PLACE = ActingRules("place", "wind")

HIGH = 6
"""Slabs of a wall."""


def nearest_hexagon(x, y):
    """Row and column of the hexagon with the centre nearest to a point (cells from the first centre)."""
    rows = np.floor(y / HEX_ROWS)[..., None] + np.arange(2)
    columns = np.rint(x[..., None] - 0.5 * (rows % 2))
    away = np.hypot(x[..., None] - columns - 0.5 * (rows % 2), y[..., None] - rows * HEX_ROWS)
    nearer = np.argmin(away, axis=-1)[..., None]
    row, column = (np.take_along_axis(part, nearer, -1)[..., 0].astype(int) for part in (rows, columns))
    return row, column


def sheltered(lattice, sand, angle, points, **parameters):
    """Which points (cells) lie in shadow, of a wind at an angle (degrees) to the rows."""
    frame = WindFrame(0, math.radians(angle))
    rules = build(SlabParameters(**parameters), Rules(), lattice, frame, 5.0, True, PLACE).rules
    surface = stacks_of(Bed(lattice, np.zeros(lattice.shape), sand), frame, None).surface
    view = View(surface.ctypes.data, surface.ctypes.data, Rows(0, lattice.rows))
    x, y = points.T
    if lattice.hexagonal:
        row, column = nearest_hexagon(x, y)
        beside, above = x - column - 0.5 * (row % 2) + 0.5, (y - row * HEX_ROWS) * HEX_ROWS + 0.5
    else:
        row, column = np.floor(y + 0.5).astype(int), np.floor(x + 0.5).astype(int)
        beside, above = x - column + 0.5, y - row + 0.5
    found, peak = [], surface.max()
    for r, c, u, v in zip(row % lattice.rows, column % lattice.columns, beside, above, strict=True):
        place = (int(c) << 32) + int(u * CELL), (int(r) << 32) + int(v * CELL)
        here = surface[r * lattice.columns + c]
        shadows = rules.grid, rules.axis, rules.ray, rules.box
        found.append(in_shadow(view, *place, here, peak, *shadows))
    return np.array(found)


def wall(lattice, way):
    """A wall one cell wide, from edge to edge in a direction (degrees to the rows)."""
    sand = np.zeros(lattice.shape, np.int32)
    if way == 0:
        sand[lattice.rows // 2] = HIGH
    elif lattice.hexagonal:  # two rows up it has come a cell to the east (60 degrees) or to the west
        rows = np.arange(lattice.rows)
        sand[rows, (rows // 2 if way == 60 else -((rows + 1) // 2)) % lattice.columns] = HIGH
    else:
        sand[:, lattice.columns // 2] = HIGH
    return sand


def points_over(lattice):
    """Points (cells), one drawn in each of 8000 parts of the field."""
    rows = HEX_ROWS if lattice.hexagonal else 1.0
    parts = np.stack(np.meshgrid(np.arange(80), np.arange(100)), -1).reshape(-1, 2)
    within = np.random.default_rng(1).random(parts.shape)
    return (parts + within) / (80, 100) * (lattice.columns, lattice.rows * rows)


@pytest.mark.parametrize(
    ("kind", "way", "angle"),
    [
        *(("square", 90, angle) for angle in (0.0, 17.0, -45.0)),
        ("square", 0, 30.0),
        *(("hex", 0, angle) for angle in (45.0, 77.0, -90.0)),
        *(("hex", 60, angle) for angle in (0.0, -30.0, -52.0)),
        *(("hex", 120, angle) for angle in (0.0, 30.0, 38.0)),
    ],
)
def test_behind_a_wall_a_strip_of_its_height_over_the_tangent_lies_in_shadow_on_the_average(kind, way, angle):
    """Along the wind the strip is as wide wherever a line leaves the wall, for no line meets it twice.

    That holds at more than 30 degrees to a wall of hexagons, whose two sides zigzag by 30 degrees.
    """
    lattice = Lattice(kind=kind, rows=48, columns=24)
    sand = wall(lattice, way)
    rows = HEX_ROWS if lattice.hexagonal else 1.0
    points = points_over(lattice)
    strip = HIGH * lattice.aspect / math.tan(math.radians(15.0))
    long = lattice.columns if way == 0 else lattice.rows * rows / math.sin(math.radians(way))
    area = strip * long * abs(math.sin(math.radians(angle - way)))
    share = area / (lattice.columns * lattice.rows * rows)
    # parts that the strip's borders cross, some 300 of 8000, are in or out by chance
    error = math.sqrt(300 / 4) / len(points)
    assert sheltered(lattice, sand, angle, points, **LEVEL).mean() == pytest.approx(share, abs=4 * error)


@pytest.mark.parametrize("direction", [270.0, 255.0, 225.5, 287.0, 200.0, 1.0])
def test_shadow_among_hexagons_equals_lines_marched_finely_over_prisms(direction):
    """From the middle of each cell the prism under each point of the line is looked up, 50 a cell."""
    lattice = Lattice(kind="hex", rows=10, columns=13)
    sand = rough_bed(lattice, 3, top=6)
    towards = math.radians(270.0 - direction)
    slope = math.tan(math.radians(15)) / lattice.aspect
    distances = np.arange(0.01, 40.0, 0.02)
    shaded = zone(lattice, sand, direction=direction, **LEVEL)
    for row, col in np.ndindex(lattice.shape):
        x = col + 0.5 * (row % 2) - distances * math.cos(towards)
        rows, cols = nearest_hexagon(x, row * HEX_ROWS - distances * math.sin(towards))
        above = sand[rows % lattice.rows, cols % lattice.columns] - slope * distances - sand[row, col]
        assert shaded[row, col] if above.max() > 0.0 else True
        assert not shaded[row, col] if above.max() < -0.02 * slope else True


def test_a_line_that_leaves_an_open_edge_of_hexagons_is_sheltered_by_nothing_beyond():
    lattice = Lattice(kind="hex", rows=6, columns=10, boundary_x="open", boundary_y="open")
    sand = np.zeros(lattice.shape, np.int32)
    sand[:, -1] = HIGH
    for direction in (270.0, 255.0, 250.0):
        assert not zone(lattice, sand, direction=direction, shadow_from="place")[:, :-1].any()
    assert zone(lattice, sand, direction=90.0, shadow_from="place")[:, -4:-1].all()


def across_the_wind(lattice, angle):
    """A bed that rises by whole slabs from cell to cell across a wind at 45, 26.57 or 30 degrees."""
    row, col = np.indices(lattice.shape)
    if lattice.hexagonal:
        return row - (col - row // 2)
    return (2 if angle < 45.0 else 1) * row - col


@pytest.mark.parametrize(
    ("kind", "angle"), [("square", 45.0), ("square", math.degrees(math.atan(0.5))), ("hex", 30.0)]
)
def test_a_slope_straight_across_the_wind_lies_in_no_shadow_under_sloping_tops(kind, angle):
    """Along the wind such a slope is level, so no line that falls meets it; its stacks are a staircase."""
    lattice = Lattice(kind=kind, rows=40, columns=40, boundary_x="open", boundary_y="open")
    sand = across_the_wind(lattice, angle)
    sand = (sand - sand.min()).astype(np.int32)
    points = points_over(lattice)
    rows = HEX_ROWS if lattice.hexagonal else 1.0
    inside = (points > 8).all(axis=1) & (points < np.array([32, 32 * rows])).all(axis=1)
    shaded = [
        sheltered(lattice, sand, angle, points[inside], repose_angle=60.0, stack_tops=tops).mean()
        for tops in ("level", "sloping")
    ]
    assert shaded[0] > 0.2
    assert shaded[1] == 0.0


@pytest.mark.parametrize(("kind", "angle"), [("square", 45.0), ("hex", 30.0)])
def test_tops_are_no_steeper_than_sand_that_lies_at_rest(kind, angle):
    """Ground beside a pillar rises to it by 2 slabs a cell at most, over 0.71 cells at most.

    That shelters 2 × 0.71 slabs over the tangent, 1.8 cells; the pillar shelters what is straight behind it.
    """
    lattice = Lattice(kind=kind, rows=40, columns=40, boundary_x="open", boundary_y="open")
    sand = np.zeros(lattice.shape, np.int32)
    sand[10, 10] = 1000
    points = points_over(lattice)
    middle = np.array([10.0, 10.0 * (HEX_ROWS if lattice.hexagonal else 1.0)])
    towards = math.radians(angle)
    downwind = (points - middle) @ (math.cos(towards), math.sin(towards))
    aside = np.abs((points - middle) @ (-math.sin(towards), math.cos(towards)))
    behind = (downwind > 4.0) & (aside < 0.4) & (points < 39 * HEX_ROWS).all(axis=1)
    beside = (downwind > 4.0) & (aside > 0.8) & (aside < 2.5) & (points < 39 * HEX_ROWS).all(axis=1)
    assert min(behind.sum(), beside.sum()) > 50
    assert sheltered(lattice, sand, angle, points[behind]).all()
    assert not sheltered(lattice, sand, angle, points[beside]).any()


@pytest.mark.parametrize("kind", ["square", "hex"])
def test_tops_near_an_open_edge_are_those_of_rows_that_no_other_thread_changes(kind):
    """A line from the first rows sees the last row as it was, though by its number it is near the first.

    Whoever works on the last rows may change them meanwhile: across an open edge nobody waits for them.
    """
    lattice = Lattice(kind=kind, rows=96, columns=128, boundary_y="open")
    sand = np.zeros(lattice.shape, np.int32)
    sand[94] = 105 if kind == "square" else 91  # lines from the first rows have fallen by about that
    frame = WindFrame(0, math.radians(-45.0))
    rules = build(SlabParameters(), Rules(), lattice, frame, 5.0, True, PLACE).rules
    surface = stacks_of(Bed(lattice, np.zeros(lattice.shape), sand), frame, None).surface
    raised = surface.copy()
    raised[95 * 128 :][:128] = 1000
    random = np.random.default_rng(5)
    places = [(int(x * 128 * CELL), int((1 + y) * CELL)) for x, y in random.random((400, 2)) * (1, 2)]

    def shaded(now, before):
        view = View(now.ctypes.data, before.ctypes.data, Rows(95, 8))
        shadows = rules.grid, rules.axis, rules.ray, rules.box
        heights = (now[(across >> 32) * 128 + (along >> 32)] for along, across in places)
        return [in_shadow(view, *at, here, 1000, *shadows) for at, here in zip(places, heights, strict=True)]

    was = shaded(surface, surface)
    assert shaded(raised, surface) == was
    assert shaded(surface, raised) != was
