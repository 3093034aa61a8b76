"""The wind's frame turns the map by quarter turns so that the wind blows towards growing columns."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.directions import downwind
from barchan.wind.frame import WindFrame

ROWS, COLUMNS = 5, 9

directions = st.floats(0, 360, exclude_max=True)
numbered = np.arange(ROWS * COLUMNS).reshape(ROWS, COLUMNS)

AXES = [270.0, 180.0, 90.0, 0.0]


def distance_downwind(direction):
    """How far downwind (cells) each cell of the map lies."""
    x, y = downwind(direction)
    row, col = np.mgrid[0:ROWS, 0:COLUMNS]
    return x * col + y * row


@pytest.mark.parametrize("direction", AXES)
def test_a_wind_along_an_axis_blows_exactly_along_the_frames_columns(direction):
    frame = WindFrame.of(direction)
    entered = frame.enter(distance_downwind(direction))
    assert frame.angle == 0.0
    np.testing.assert_allclose(np.diff(entered, axis=1), 1.0, atol=1e-12)
    np.testing.assert_allclose(np.diff(entered, axis=0), 0.0, atol=1e-12)


@pytest.mark.parametrize(
    ("direction", "first_row_of_the_frame"),
    [
        (270.0, numbered[0]),
        (180.0, numbered[:, -1]),
        (90.0, numbered[-1, ::-1]),
        (0.0, numbered[::-1, 0]),
    ],
)
def test_the_frames_first_row_lies_on_the_winds_right_hand(direction, first_row_of_the_frame):
    entered = WindFrame.of(direction).enter(numbered)
    np.testing.assert_array_equal(entered[0], first_row_of_the_frame)


@given(directions)
def test_an_oblique_wind_lies_within_45_degrees_of_the_frames_columns(direction):
    assert abs(WindFrame.of(direction).angle) <= math.pi / 4 + 1e-9


@given(directions)
def test_downwind_in_the_frame_is_along_the_columns_at_the_frames_angle(direction):
    frame = WindFrame.of(direction)
    entered = frame.enter(distance_downwind(direction))
    np.testing.assert_allclose(np.diff(entered, axis=1), math.cos(frame.angle), atol=1e-7)
    np.testing.assert_allclose(np.diff(entered, axis=0), math.sin(frame.angle), atol=1e-7)


@given(directions)
def test_a_vector_along_the_wind_in_the_frame_points_downwind_on_the_map(direction):
    frame = WindFrame.of(direction)
    vector = frame.to_map(math.cos(frame.angle), math.sin(frame.angle))
    assert vector == pytest.approx(downwind(direction), abs=1e-8)


@given(directions)
def test_entering_and_leaving_the_frame_are_inverse(direction):
    frame = WindFrame.of(direction)
    np.testing.assert_array_equal(frame.leave(frame.enter(numbered)), numbered)
    np.testing.assert_array_equal(frame.enter(frame.leave(numbered)), numbered)


@given(directions)
def test_rows_become_columns_when_the_frame_is_crossed(direction):
    frame = WindFrame.of(direction)
    expected = (COLUMNS, ROWS) if frame.crossed else (ROWS, COLUMNS)
    assert frame.enter(numbered).shape == expected


@given(directions)
def test_no_cell_is_copied_on_the_way_into_the_frame(direction):
    assert np.shares_memory(WindFrame.of(direction).enter(numbered), numbered)
