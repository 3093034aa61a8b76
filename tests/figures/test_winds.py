"""A wind that changes direction is drawn as the sand rose of all winds, a steady one as an arrow."""

import json

import numpy as np
import pytest

from barchan.entry import simulate
from barchan.figures.maps import relief_map
from barchan.figures.winds import changing_drift
from tests.tiny import tiny

FOUR = {"kind": "regimes", "regimes": [{"direction": d, "steps": 1} for d in (270, 180, 90, 90)]}
"""Of four steps one wind is from the west, one from the south, two from the east."""


@pytest.fixture(scope="module")
def turning():
    """A frame under winds that turn, and its scenario."""
    scenario = tiny(wind=FOUR, run__steps=4)
    return simulate(scenario).isel(step=-1), scenario


def test_the_petals_of_the_rose_are_the_winds_shares(turning):
    """Sectors of 22.5 degrees from north: east is the 5th, south the 9th, west the 13th."""
    frame, scenario = turning
    (rose,) = relief_map(frame, scenario).axes[0].child_axes
    petals = [bar.get_height() for bar in rose.patches if bar.get_height() > 0]
    at = [
        round(np.degrees(bar.get_x() + bar.get_width() / 2)) for bar in rose.patches if bar.get_height() > 0
    ]
    assert at == [90, 180, 270]
    np.testing.assert_allclose(petals, [0.5, 0.25, 0.25])


def test_the_arrow_of_the_rose_points_where_sand_goes_on_the_whole(turning):
    """Half to the west, a quarter each to the north and the east: (-1/4, 1/4) is to the north-west."""
    frame, scenario = turning
    drift = changing_drift(scenario, frame)
    assert drift.toward == pytest.approx(315.0)
    assert drift.steadiness == pytest.approx(np.sqrt(2) / 4)
    (rose,) = relief_map(frame, scenario).axes[0].child_axes
    (arrow,) = (text for text in rose.texts if getattr(text, "arrow_patch", None) is not None)
    assert arrow.xy == pytest.approx((np.radians(315.0), np.sqrt(2) / 4 * 0.5))


def test_a_steady_wind_has_no_rose(painted):
    frame, scenario = painted(3)
    assert changing_drift(scenario, frame) is None
    assert relief_map(frame, scenario).axes[0].child_axes == []


def test_after_an_event_the_arrow_is_that_of_the_new_wind(turning):
    frame, scenario = turning
    event = {"step": 2, "kind": "wind", "wind": {"kind": "steady", "direction": 0.0}}
    assert changing_drift(scenario, frame.assign_attrs(events=json.dumps([event]))) is None
