"""Dunes are distinguished as bodies of sand, also over joined edges."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.measures.dunes import bodies_of, find_dunes


def heap(rows, columns, row, column, radius=6.0, top=5.0):
    """A cone on a field that goes on over its edges."""
    far = [
        np.minimum(np.abs(np.arange(n) - at), n - np.abs(np.arange(n) - at))
        for n, at in ((rows, row), (columns, column))
    ]
    return np.maximum(top * (1 - np.hypot(far[0][:, None], far[1][None, :]) / radius), 0.0)


@given(st.integers(0, 39), st.integers(0, 59))
def test_a_heap_is_one_dune_wherever_it_lies_on_a_field_with_joined_edges(row, column):
    (dune,) = find_dunes(heap(40, 60, row, column), 1.0)
    (middle,) = find_dunes(heap(40, 60, 20, 30), 1.0)
    assert dune.cells == middle.cells
    assert dune.height == pytest.approx(middle.height)
    assert np.ptp(dune.rows) == np.ptp(middle.rows)
    assert np.ptp(dune.columns) == np.ptp(middle.columns)
    assert dune.rows.mean() % 40 == pytest.approx(row, abs=1e-6)
    assert dune.columns.mean() % 60 == pytest.approx(column, abs=1e-6)


def test_heaps_that_stand_apart_are_dunes_of_their_own_and_low_ones_are_left_out():
    field = heap(60, 60, 15, 15) + heap(60, 60, 40, 40, top=3.0) + heap(60, 60, 15, 45, top=0.6)
    assert [round(dune.height) for dune in find_dunes(field, 1.0, width=0.5)] == [5, 3]
    assert len(find_dunes(field, 0.1, width=0.5)) == 3


def test_sand_that_touches_at_corners_only_is_one_dune():
    field = np.zeros((12, 12))
    field[3:5, 3:5] = field[5:7, 5:7] = 4.0
    assert len(find_dunes(field, 1.0, width=0.0)) == 1


def test_a_ridge_without_end_is_no_dune():
    field = np.zeros((30, 40))
    field[:, 10:16] = 3.0
    assert find_dunes(field, 1.0) == []
    assert find_dunes(np.full((10, 10), 4.0), 1.0) == []


def test_a_dune_that_an_open_edge_cuts_is_left_out():
    field = heap(40, 60, 20, 1)
    assert len(find_dunes(field, 1.0)) == 1
    assert find_dunes(np.maximum(field - 0.5, 0), 1.0, (True, False)) == []
    assert len(find_dunes(heap(40, 60, 20, 30), 1.0, (False, False))) == 1


@pytest.mark.parametrize(
    ("periodic", "bodies"), [((True, True), 1), ((True, False), 2), ((False, True), 2), ((False, False), 4)]
)
def test_the_corners_of_a_field_meet_over_joined_edges_only(periodic, bodies):
    corners = np.zeros((12, 16), bool)
    corners[[0, 0, -1, -1], [0, -1, 0, -1]] = True
    assert len(np.unique(bodies_of(corners, periodic))) - 1 == bodies
