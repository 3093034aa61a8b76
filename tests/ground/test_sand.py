"""The sand that lies on the ground at the start."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from barchan.ground.layer import Part
from barchan.ground.sand import DroppedSand, FlatSand, RandomSand
from barchan.lattice import Lattice
from barchan.streams import Stream

SMALL = Lattice(rows=16, columns=24)
LARGE = Lattice(rows=150, columns=200)
LEVEL = np.zeros(1)
KINDS = [FlatSand, RandomSand, DroppedSand]


def stream(seed=5):
    return Stream(seed, "initial surface")


def test_flat_sand_lies_equally_high_everywhere():
    assert set(FlatSand(mean=4).slabs(SMALL, LEVEL, stream()).ravel()) == {4}


def test_random_sand_has_one_slab_less_none_or_one_more_with_equal_chance():
    slabs = RandomSand(mean=4).slabs(LARGE, LEVEL, stream())
    counts = np.bincount(slabs.ravel(), minlength=6)
    assert counts[:3].sum() == 0
    assert counts.size == 6
    deviation = math.sqrt(LARGE.cells * (1 / 3) * (2 / 3))
    assert (np.abs(counts[3:] - LARGE.cells / 3) < 4 * deviation).all()


def test_random_sand_about_nothing_never_takes_what_is_not_there():
    slabs = RandomSand(mean=0).slabs(SMALL, LEVEL, stream())
    assert set(slabs.ravel()) == {0, 1}


@given(st.floats(0, 30), st.integers(1, 20), st.integers(8, 20))
def test_dropped_sand_has_exactly_the_stated_mean(mean, rows, columns):
    lattice = Lattice(rows=rows, columns=columns)
    slabs = DroppedSand(mean=mean).slabs(lattice, LEVEL, stream())
    assert slabs.sum() == round(mean * rows * columns)


def test_dropped_sand_falls_on_every_cell_alike():
    mean = 4.0
    slabs = DroppedSand(mean=mean).slabs(LARGE, LEVEL, stream())
    variance = mean * (1 - 1 / LARGE.cells)
    error = variance * math.sqrt((2 + 1 / mean) / LARGE.cells)
    assert abs(slabs.var() - variance) < 4 * error
    by_row = slabs.sum(axis=1)
    by_column = slabs.sum(axis=0)
    assert np.abs(by_row - mean * LARGE.columns).max() < 5 * math.sqrt(mean * LARGE.columns)
    assert np.abs(by_column - mean * LARGE.rows).max() < 5 * math.sqrt(mean * LARGE.rows)


def test_a_part_covers_its_share_of_columns_from_west_and_of_rows_from_south():
    part = Part(mean=9.0, west=0.25, east=0.5, south=0.75, north=1.0)
    slabs = FlatSand(mean=1, parts=[part]).slabs(SMALL, LEVEL, stream())
    expected = np.ones((16, 24), int)
    expected[12:16, 6:12] = 9
    np.testing.assert_array_equal(slabs, expected)


def test_later_parts_lie_over_earlier_ones():
    parts = [Part(mean=9.0), Part(mean=2.0, east=0.5)]
    slabs = FlatSand(mean=1, parts=parts).slabs(SMALL, LEVEL, stream())
    assert set(slabs[:, :12].ravel()) == {2}
    assert set(slabs[:, 12:].ravel()) == {9}


def test_each_part_of_dropped_sand_has_its_own_mean():
    part = Part(mean=7.5, west=0.5, north=0.5)
    slabs = DroppedSand(mean=2.0, parts=[part]).slabs(SMALL, LEVEL, stream())
    assert slabs[:8, 12:].sum() == round(7.5 * 8 * 12)


def test_sand_outside_a_part_is_as_it_would_be_without_the_part():
    part = Part(mean=7.0, west=0.5, north=0.5)
    outside = np.ones((16, 24), bool)
    outside[:8, 12:] = False
    for kind in KINDS:
        alone = kind(mean=3).slabs(SMALL, LEVEL, stream())
        parted = kind(mean=3, parts=[part]).slabs(SMALL, LEVEL, stream())
        np.testing.assert_array_equal(parted[outside], alone[outside])


@pytest.mark.parametrize("kind", [RandomSand, DroppedSand])
def test_the_same_seed_lays_the_same_sand_and_another_seed_other_sand(kind):
    first = kind(mean=3).slabs(SMALL, LEVEL, stream())
    np.testing.assert_array_equal(first, kind(mean=3).slabs(SMALL, LEVEL, stream()))
    assert (first != kind(mean=3).slabs(SMALL, LEVEL, stream(6))).any()


@pytest.mark.parametrize(
    "edges", [{"west": 0.5, "east": 0.5}, {"south": 0.8, "north": 0.2}, {"west": -0.1}, {"north": 1.1}]
)
def test_a_part_lies_in_the_field_and_has_an_area(edges):
    with pytest.raises(ValidationError):
        Part(mean=1.0, **edges)


@pytest.mark.parametrize("kind", KINDS)
def test_sand_is_never_negative(kind):
    with pytest.raises(ValidationError):
        kind(mean=-1)
