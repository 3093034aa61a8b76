"""How near a wind lies to the limits of its classes.

Right values: two winds of 1 and w hold 1/(1 + w) and w/(1 + w) of the drift; modes of two narrow winds are
where they blow from.
"""

import pytest

from barchan.theory.drift import drift_of
from barchan.theory.limits_nearby import class_nearby, dunes_nearby
from tests.theory.test_variability import spread


def test_a_wind_far_from_every_limit_is_near_none():
    assert class_nearby(drift_of([(270.0, 1.0)])) == []
    assert class_nearby(spread((200.0, 1.0), (80.0, 0.6))) == []


def test_most_but_not_quite_all_from_within_45_degrees_is_nearly_narrow():
    """88 of 100 from 270°, 12 from 200°: 88 % lie within 45°, of 90 % that are asked for."""
    (said,) = class_nearby(drift_of([(270.0, 88.0), (200.0, 12.0)]))
    assert said == (
        "the directions are nearly narrow unimodal: "
        "they would be so if narrow were 85 % from within 45° (90 %)"
    )


@pytest.mark.parametrize(("apart", "other"), [(85.0, "obtuse"), (95.0, "acute")])
def test_two_winds_about_a_right_angle_apart_are_nearly_the_other_bimodal(apart, other):
    (said,) = class_nearby(spread((100.0, 1.0), (100.0 + apart, 0.7)))
    assert said.startswith(f"the directions are nearly {other} bimodal")


def test_a_second_wind_that_hardly_counts_makes_it_nearly_bimodal():
    """17 % of the highest: above 15 %, below 20 %; of 117 parts 100, 85 %, are from one side."""
    said = class_nearby(spread((250.0, 1.0), (110.0, 0.17)))
    assert any("nearly obtuse bimodal" in one and "15 % of the highest" in one for one in said)


@pytest.mark.parametrize(
    ("steadiness", "supply", "said"),
    [
        (0.5, 1.0, []),
        (0.5, None, []),
        (0.68, 1.0, ["RDP/DP 0.68 is near 0.7, above which one would expect barchans"]),
        (0.72, 1.0, ["RDP/DP 0.72 is near 0.7, below which one would expect isolated linear dunes"]),
        (
            0.28,
            9.0,
            ["RDP/DP 0.28 is near 0.3, above which one would expect linear dunes, close and compound"],
        ),
        (0.9, 2.5, ["the sand supply of 2.5 m is near 3 m; with more sand: transverse dunes"]),
        (0.9, 4.0, ["the sand supply of 4 m is near 3 m; with less sand: barchans"]),
        (float("nan"), 1.0, []),
    ],
)
def test_other_dunes_are_named_near_the_limits_of_steadiness_and_supply(steadiness, supply, said):
    assert dunes_nearby(steadiness, supply) == said
