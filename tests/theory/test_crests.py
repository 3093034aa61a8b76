"""Predicted crests against worked examples and symmetry."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.theory.crests import SPEEDUP, bed_instability, elongation, gross_transport
from barchan.theory.drift import drift_of

winds = st.lists(st.tuples(st.floats(0, 359.9), st.floats(0.1, 10)), min_size=1, max_size=6)


def two(divergence, duty):
    """Two winds about the west, the one from the left ``duty`` times as strong."""
    return drift_of([(270.0 - divergence / 2, duty), (270.0 + divergence / 2, 1.0)])


def from_resultant(azimuth, drift):
    """Angle of a crest with the resultant: 90 is transverse, 0 longitudinal."""
    return abs((azimuth - drift.toward + 90) % 180 - 90)


@pytest.mark.parametrize(
    ("divergence", "duty", "speedup", "angle"),
    [
        (60, 1, 0.0, 90),
        (60, 1, SPEEDUP, 90),
        (60, 2, SPEEDUP, 87),
        (85, 1, SPEEDUP, 90),
        (85, 2, 0.0, 90),
        (85, 2, SPEEDUP, 78),
        (85, 5, SPEEDUP, 83),
        (90, 2, SPEEDUP, 52),
        (95, 1, 0.0, 0),
        (95, 2, 0.0, 37),
        (95, 2, SPEEDUP, 49),
        (120, 1, 0.0, 0),
        (120, 1, SPEEDUP, 0),
        (120, 2, 0.0, 41),
        (120, 2, SPEEDUP, 44),
        (120, 5, SPEEDUP, 73),
        (150, 2, 0.0, 56),
        (150, 2, SPEEDUP, 56),
        (180, 2, 0.0, 90),
        (180, 5, SPEEDUP, 90),
    ],
)
def test_two_winds_give_the_crests_worked_out_for_them(divergence, duty, speedup, angle):
    drift = two(divergence, duty)
    assert from_resultant(gross_transport(drift, speedup).azimuth, drift) == pytest.approx(angle, abs=0.75)


@pytest.mark.parametrize("speedup", [0.0, SPEEDUP])
def test_equal_winds_switch_from_transverse_to_longitudinal_at_a_right_angle(speedup):
    for divergence, angle in ((80, 90), (100, 0)):
        drift = two(divergence, 1)
        crest = gross_transport(drift, speedup)
        assert from_resultant(crest.azimuth, drift) == pytest.approx(angle, abs=0.2)
        assert not crest.ambiguous
    tie = gross_transport(two(90, 1), speedup)
    assert sorted([tie.azimuth, *tie.rivals]) == pytest.approx([0, 90], abs=0.2)


def test_opposite_winds_give_crests_across_their_axis():
    assert gross_transport(two(180, 1)).azimuth == pytest.approx(90.0)


def test_one_wind_gives_a_crest_across_it_and_a_finger_along_it():
    drift = drift_of([(237.0, 3.0)])
    assert bed_instability(drift).azimuth == pytest.approx(147.0, abs=0.06)
    assert elongation(drift) == pytest.approx(57.0, abs=0.01)


def test_winds_from_everywhere_give_no_crest():
    drift = drift_of([(float(degree), 1.0) for degree in range(0, 360, 5)])
    assert np.isnan(bed_instability(drift).azimuth)
    assert np.isnan(elongation(drift))


def test_without_wind_nothing_is_predicted():
    still = drift_of([(10.0, 0.0)])
    assert np.isnan(gross_transport(still).azimuth)
    assert np.isnan(elongation(still))


@settings(max_examples=50)
@given(winds)
def test_the_flux_over_a_finger_points_along_it(given_winds):
    drift = drift_of(given_winds)
    toward = elongation(drift)
    if np.isnan(toward):
        return
    angle = np.radians(drift.direction + 180 - toward)
    over = drift.amount * (1 + SPEEDUP * np.abs(np.sin(angle)))
    assert abs(over @ np.sin(angle)) < 1e-3 * drift.total
    assert over @ np.cos(angle) > 0


@settings(max_examples=50)
@given(winds)
def test_no_other_crest_has_more_transport_across_it(given_winds):
    drift = drift_of(given_winds)
    crest = gross_transport(drift)
    if np.isnan(crest.azimuth):
        return

    def transport(azimuth):
        return drift.amount @ np.abs(np.sin(np.radians(drift.direction - azimuth)))

    assert transport(crest.azimuth) >= max(map(transport, range(180))) * (1 - 1e-5)


def test_many_winds_give_what_their_sums_by_degree_give():
    random = np.random.default_rng(1)
    many = drift_of([*zip((250 + 30 * random.standard_normal(5000)) % 360, random.random(5000), strict=True)])
    crest = bed_instability(many).azimuth
    assert from_resultant(crest, many) > 85
    assert elongation(many) == pytest.approx(many.toward, abs=3)
