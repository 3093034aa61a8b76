"""Courses of a speed in normalised time."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from barchan.wind.ramps import Bezier, Linear, Point, Points

shares = st.floats(0, 1)
COURSES = [
    Linear(kind="linear"),
    Bezier(kind="bezier"),
    Bezier(kind="bezier", time_1=1.0, value_1=2.0, time_2=0.0, value_2=-1.0),
    Points(kind="points", points=[Point(time=0.3, value=0.9)]),
]


@pytest.mark.parametrize("course", COURSES)
def test_every_course_goes_from_the_first_to_the_last_value(course):
    assert course.share(0.0) == pytest.approx(0.0, abs=1e-9)
    assert course.share(1.0) == pytest.approx(1.0, abs=1e-9)


@given(st.floats(0, 1), st.floats(0, 1), shares)
def test_a_bezier_curve_with_its_controls_on_the_line_is_the_line(first, second, time):
    curve = Bezier(kind="bezier", time_1=first, value_1=first, time_2=second, value_2=second)
    assert curve.share(time) == pytest.approx(time, abs=1e-6)


@given(shares, shares, st.floats(-2, 2), st.floats(-2, 2), shares)
def test_a_bezier_curve_passes_through_its_points(time_1, time_2, value_1, value_2, u):
    """Its points are given by Bernstein polynomials."""
    weights = [(1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u**2 * (1 - u), u**3]
    time = weights[1] * time_1 + weights[2] * time_2 + weights[3]
    value = weights[1] * value_1 + weights[2] * value_2 + weights[3]
    curve = Bezier(kind="bezier", time_1=time_1, value_1=value_1, time_2=time_2, value_2=value_2)
    slope = (curve.share(min(time + 1e-6, 1.0)) - curve.share(max(time - 1e-6, 0.0))) / 2e-6
    assert curve.share(time) == pytest.approx(value, abs=1e-5 * (1 + abs(slope)))


def test_points_are_joined_by_straight_lines():
    course = Points(kind="points", points=[Point(time=0.5, value=2.0), Point(time=0.75, value=0.0)])
    assert [course.share(t) for t in (0.25, 0.5, 0.625, 0.875)] == [1.0, 2.0, 1.0, 0.5]


def test_points_must_increase_in_time():
    with pytest.raises(
        ValidationError, match=r"points\[1\]\.time is 0\.5 after 0\.5; allowed: times that inc"
    ):
        Points(kind="points", points=[Point(time=0.5, value=0.0), Point(time=0.5, value=1.0)])
