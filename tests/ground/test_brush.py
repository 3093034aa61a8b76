"""A brush changes sand, ground and fields in a round patch, and never takes what is not there."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from barchan.bed import Bed
from barchan.ground.brush import brush, brushed, grown, raised, whole
from barchan.lattice import Lattice

ROWS, COLUMNS, CELL = 10, 14, 2.0

FALLOFFS = {
    "none": lambda share: 1.0,
    "linear": lambda share: 1.0 - share,
    "smooth": lambda share: 0.5 + 0.5 * math.cos(math.pi * share),
}


def bed_of(mean=3, boundary_x="periodic", boundary_y="periodic"):
    lattice = Lattice(
        rows=ROWS, columns=COLUMNS, cell_size=CELL, boundary_x=boundary_x, boundary_y=boundary_y
    )
    return Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, mean))


def gap(place, centre, length, joined):
    """The shortest distance, over the edges where they are joined."""
    images = range(-3, 4) if joined else [0]
    return min(abs(place - centre - k * length) for k in images)


def one_cell(bed, row, col, x, y, radius, amount, falloff):
    """What a stroke does to one cell, worked out alone."""
    dx = gap((col + 0.5) * CELL, x, COLUMNS * CELL, bed.lattice.boundary_x == "periodic")
    dy = gap((row + 0.5) * CELL, y, ROWS * CELL, bed.lattice.boundary_y == "periodic")
    share = math.hypot(dx, dy) / radius
    change = round(amount * FALLOFFS[falloff](share)) if share < 1 else 0
    return max(change, -int(bed.sand[row, col]))


def cell_by_cell(bed, *stroke):
    return [[one_cell(bed, row, col, *stroke) for col in range(COLUMNS)] for row in range(ROWS)]


def stroked(bed, x, y, radius, amount, falloff):
    return brushed(bed, whole(brush(bed.lattice, x, y, radius, falloff), None, amount))


boundaries = st.sampled_from(["periodic", "open"])
strokes = st.tuples(
    st.floats(0, COLUMNS * CELL),
    st.floats(0, ROWS * CELL),
    st.floats(0.1, 30),
    st.integers(-8, 8),
    st.sampled_from(list(FALLOFFS)),
)


@given(strokes, boundaries, boundaries)
def test_a_stroke_equals_its_definition_cell_by_cell(stroke, boundary_x, boundary_y):
    bed = bed_of(3, boundary_x, boundary_y)
    change = stroked(bed, *stroke)
    differences = np.abs(change - np.array(cell_by_cell(bed, *stroke)))
    halves = _close_to_a_half(bed, *stroke)
    assert (differences[~halves] == 0).all()
    assert (differences <= 1).all()


def _close_to_a_half(bed, x, y, radius, amount, falloff):
    """Cells whose change, or whose place on the rim, rounding of the last digit decides."""
    near = np.zeros((ROWS, COLUMNS), bool)
    for row, col in np.ndindex(ROWS, COLUMNS):
        dx = gap((col + 0.5) * CELL, x, COLUMNS * CELL, bed.lattice.boundary_x == "periodic")
        dy = gap((row + 0.5) * CELL, y, ROWS * CELL, bed.lattice.boundary_y == "periodic")
        share = math.hypot(dx, dy) / radius
        change = amount * FALLOFFS[falloff](min(share, 1.0))
        near[row, col] = abs(change % 1 - 0.5) < 1e-9
    return near


def test_a_stroke_a_whole_field_away_is_the_same_stroke_where_edges_are_joined():
    bed = bed_of()
    near = stroked(bed, 27.0, 7.0, 5.0, 4, "smooth")
    far = stroked(bed, 27.0 + COLUMNS * CELL, 7.0, 5.0, 4, "smooth")
    np.testing.assert_array_equal(near, far)


def test_a_stroke_beside_an_open_edge_stays_on_its_side():
    change = stroked(bed_of(boundary_x="open"), 0.0, 10.0, 5.0, 4, "none")
    assert change[:, :2].sum() > 0
    assert change[:, 4:].sum() == 0


def test_a_stroke_takes_no_more_than_there_is():
    assert stroked(bed_of(mean=3), 14.0, 10.0, 100.0, -50, "none").min() == -3


def test_ground_changes_by_whole_slabs_and_stays_above_the_lowest():
    bed = bed_of()
    bed.ground[:, 7:] = 2.5
    strength = brush(bed.lattice, 14.0, 10.0, 9.0, "smooth")
    steps = raised(bed, whole(strength, None, 6)) / bed.lattice.thickness
    np.testing.assert_allclose(steps, np.rint(6 * strength))
    lowered = bed.ground + raised(bed, np.full(bed.lattice.shape, -100.0))
    assert not lowered.any()


@given(st.lists(st.tuples(st.floats(2, 26), st.floats(2, 18)), min_size=1, max_size=6), st.integers(-5, 5))
def test_stamps_that_know_those_before_them_add_up_to_the_units_of_their_sum(places, amount):
    lattice = bed_of().lattice
    shares = [brush(lattice, x, y, 7.0, "smooth") for x, y in places]
    added = np.zeros(lattice.shape)
    for number, share in enumerate(shares):
        added += whole(share, sum(shares[:number], np.zeros(lattice.shape)) if number else None, amount)
    np.testing.assert_array_equal(added, np.rint(amount * sum(shares)))


def test_a_field_is_held_within_its_bounds_and_what_lies_beyond_stays():
    values = np.array([-0.5, 0.0, 0.4, 1.0, 1.3])
    ones = np.ones(5)
    np.testing.assert_allclose(values + grown(values, ones, 0.3, (0.0, 1.0)), [-0.2, 0.3, 0.7, 1.0, 1.3])
    np.testing.assert_allclose(values + grown(values, ones, -0.6, (0.0, 1.0)), [-0.5, 0.0, 0.0, 0.4, 0.7])
