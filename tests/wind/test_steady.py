"""A wind that never changes."""

import pytest
from pydantic import ValidationError

from barchan.wind import Segment, Steady


def test_a_steady_wind_is_one_segment_that_polls_every_cell_once_a_step():
    segments = list(Steady(direction=90.0, speed=3.0).segments(40, 7, 384))
    assert segments == [Segment(40, 7, 0, 384, 90.0, 3.0)]


def test_a_wind_without_a_speed_leaves_the_hop_length_to_the_model():
    (segment,) = Steady().segments(0, 1, 8)
    assert segment.hop_length is None
    assert segment.seconds is None


@pytest.mark.parametrize("direction", [-1.0, 360.0, float("nan"), "west"])
def test_a_direction_lies_within_a_turn(direction):
    with pytest.raises(ValidationError):
        Steady(direction=direction)
