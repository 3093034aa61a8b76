"""A stretch of wind: where it blows to, and how it is divided."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.directions import bearing, downwind
from barchan.wind import Segment

directions = st.floats(0, 360, exclude_max=True)


@pytest.mark.parametrize(
    ("direction", "x", "y"),
    [(0, 0, -1), (90, -1, 0), (180, 0, 1), (270, 1, 0), (225, math.sqrt(0.5), math.sqrt(0.5))],
    ids=["north", "east", "south", "west", "south-west"],
)
def test_a_wind_blows_away_from_where_it_comes_from(direction, x, y):
    assert downwind(direction) == pytest.approx((x, y), abs=1e-12)


@given(directions)
def test_downwind_is_a_unit_vector_whose_bearing_is_opposite_to_the_winds(direction):
    x, y = downwind(direction)
    bearing = math.degrees(math.atan2(x, y))
    assert math.hypot(x, y) == pytest.approx(1, abs=1e-12)
    assert (bearing - direction) % 360 == pytest.approx(180, abs=1e-9)


@given(directions)
def test_a_bearing_is_where_a_wind_comes_from(direction):
    assert (bearing(*downwind(direction)) - direction + 180) % 360 == pytest.approx(180, abs=1e-9)


def test_part_of_a_segment_takes_its_share_of_the_time():
    part = Segment(10, 8, 0, 384, 270.0, step_seconds=450.0).part(3, 2)
    assert (part.step, part.steps, part.polls, part.seconds) == (13, 2, 384, 900.0)


def test_a_segment_for_a_share_of_a_step_lasts_that_share():
    assert Segment(10, 1, 96, 96, 270.0, share=0.25, step_seconds=400.0, ends=False).seconds == 100.0


def test_part_of_a_segment_without_a_clock_has_none():
    assert Segment(10, 8, 0, 384, 270.0).part(0, 2).seconds is None
