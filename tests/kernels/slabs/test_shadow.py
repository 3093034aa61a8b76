"""The shadow zone equals a brute-force ray test, for both rules, every boundary and oblique winds."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.slabs.parameters import SlabParameters
from tests.kernels.slabs.test_step import PlainSlabs, rough_bed

LEVEL = {"shadow_from": "place", "stack_tops": "level"}
"""Shadow over stacks that are boxes."""


def zone(lattice, sand, ground=None, direction=270.0, **parameters):
    ground = np.zeros(lattice.shape) if ground is None else ground
    return PlainSlabs(SlabParameters(**parameters), lattice).shadow_zone(
        Bed(lattice, ground, sand), direction
    )


def line_of_sight(elevation, lattice, angle, start):
    """For a wind from the west: is there a stack upwind whose line passes above the cell's middle? (m)"""
    slope = math.tan(math.radians(angle))
    shaded = np.zeros(lattice.shape, bool)
    periodic = lattice.boundary_x == "periodic"
    for row in range(lattice.rows):
        for col in range(lattice.columns):
            for d in range(1, lattice.columns + 1 if periodic else col + 1):
                upwind = elevation[row, (col - d) % lattice.columns]
                line = upwind - slope * (d - start) * lattice.cell_size
                shaded[row, col] |= line > elevation[row, col] + 1e-9
    return shaded


@settings(max_examples=60)
@given(
    st.integers(0, 2**32),
    st.integers(8, 70),
    st.sampled_from(["periodic", "open"]),
    st.sampled_from(["centre", "edge", "place"]),
    st.sampled_from([4.0, 15.0, 27.3]),
    st.sampled_from([1 / 3, 0.1, 0.51]),
    st.booleans(),
)
def test_shadow_along_an_axis_equals_lines_of_sight(seed, columns, boundary, rule, angle, aspect, uneven):
    lattice = Lattice(rows=3, columns=columns, boundary_x=boundary, slab_aspect=aspect, cell_size=2.0)
    sand = rough_bed(lattice, seed)
    ground = np.random.default_rng(seed).random(lattice.shape) * 3 if uneven else np.zeros(lattice.shape)
    start = 0.0 if rule == "centre" else 0.5
    expected = line_of_sight(ground + sand * lattice.thickness, lattice, angle, start)
    shaded = zone(lattice, sand, ground, shadow_angle=angle, shadow_from=rule)
    np.testing.assert_array_equal(shaded, expected)


def test_elders_figure_shades_four_cells():
    """The rule of Elder 2009, Fig. 2: shaded is a cell with more than half of its top below the line.

    From the edge of a stack of 3 slabs of 1/3 cell the line falls to 0.87, 0.60, 0.33, 0.06 and -0.21 cells
    over the middles of the bare cells behind it.
    """
    lattice = Lattice(rows=1, columns=16, boundary_x="open")
    sand = np.zeros(lattice.shape, np.int32)
    sand[0, 4] = 3
    heights = [1.0 - math.tan(math.radians(15)) * (d - 0.5) for d in range(1, 6)]
    assert [h > 0 for h in heights] == [True, True, True, True, False]
    shaded = zone(lattice, sand, shadow_from="edge")
    assert np.flatnonzero(shaded[0]).tolist() == [5, 6, 7, 8]
    assert np.flatnonzero(zone(lattice, sand)[0]).tolist() == [5, 6, 7]


def interpolated(elevation, row, col):
    """Height at a point on a column of the periodic lattice, linear between the two nearest cells."""
    rows = elevation.shape[0]
    lower = math.floor(row + 1e-9)
    share = row - lower
    below, above = elevation[lower % rows, col], elevation[(lower + 1) % rows, col]
    return below + share * (above - below)


@pytest.mark.parametrize("direction", [240.0, 255.0, 225.0, 292.5])
@pytest.mark.parametrize("rule", ["centre", "edge"])
def test_oblique_shadow_equals_rays_marched_column_by_column(direction, rule):
    lattice = Lattice(rows=24, columns=40)
    sand = rough_bed(lattice, 7, top=6)
    elevation = sand * lattice.thickness
    towards = math.radians(270.0 - direction)
    slope = math.tan(math.radians(15))
    start = 0.5 if rule == "edge" else 0.0
    expected = np.zeros(lattice.shape, bool)
    for row, col in np.ndindex(lattice.shape):
        for k in range(1, lattice.columns + 1):
            upwind = interpolated(elevation, row - k * math.tan(towards), (col - k) % lattice.columns)
            line = upwind - slope * (k / math.cos(towards) - start)
            expected[row, col] |= line > elevation[row, col] + 1e-9
    np.testing.assert_array_equal(zone(lattice, sand, direction=direction, shadow_from=rule), expected)


@pytest.mark.parametrize("direction", [255.0, 225.5, 287.0])
def test_oblique_shadow_from_a_place_equals_lines_marched_finely_over_boxes(direction):
    """From the middle of each cell the box under each point of the line is looked up, 50 a cell."""
    lattice = Lattice(rows=9, columns=13)
    sand = rough_bed(lattice, 3, top=6)
    towards = math.radians(270.0 - direction)
    slope = math.tan(math.radians(15)) / lattice.aspect
    distances = np.arange(0.01, 30.0, 0.02)
    for row, col in np.ndindex(lattice.shape):
        rows = np.floor(row + 0.5 - distances * math.sin(towards)).astype(int) % lattice.rows
        cols = np.floor(col + 0.5 - distances * math.cos(towards)).astype(int) % lattice.columns
        above = sand[rows, cols] - slope * distances - sand[row, col]
        shaded = zone(lattice, sand, direction=direction, **LEVEL)[row, col]
        assert shaded if above.max() > 0.0 else True
        assert not shaded if above.max() < -0.02 * slope else True


HEIGHT, RADIUS = 8.0, 12.0


def cone(x, y):
    return np.maximum(HEIGHT * (1 - np.hypot(x, y) / RADIUS), 0.0)


def behind_cone(x, y, angle):
    """Whether points lie in the cone's shadow, by rays marched finely over the true surface."""
    slope = math.tan(math.radians(15))
    along, across = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    shaded = np.zeros(x.shape, bool)
    for distance in np.arange(0.05, 50.0, 0.05):
        line = cone(x - distance * along, y - distance * across) - slope * distance
        shaded |= line > cone(x, y)
    return shaded


@pytest.mark.parametrize(
    "angle", [*(pytest.param(one, marks=pytest.mark.extended) for one in (0.0, 22.5)), 45.0]
)
def test_a_cones_shadow_has_the_same_shape_within_a_cell_at_every_angle_to_the_lattice(angle):
    lattice = Lattice(rows=121, columns=121, boundary_x="open", boundary_y="open", slab_aspect=0.01)
    y, x = np.mgrid[0:121, 0:121] - 60.0
    sand = np.rint(cone(x, y) / lattice.thickness).astype(np.int32)
    shaded = zone(lattice, sand, direction=(270.0 - angle) % 360)
    around = [(math.cos(a), math.sin(a)) for a in np.linspace(0, 2 * math.pi, 16, endpoint=False)]
    near = np.array([behind_cone(x + dx, y + dy, angle) for dx, dy in around])
    assert shaded[near.all(axis=0)].all()
    assert not shaded[~near.any(axis=0)].any()
    assert near.all(axis=0).sum() > behind_cone(x, y, angle).sum() / 2


def test_nothing_lies_in_shadow_on_a_flat_bed():
    lattice = Lattice(rows=9, columns=33)
    for direction in (270.0, 201.0, 45.0):
        assert not zone(lattice, np.full(lattice.shape, 7), direction=direction).any()
