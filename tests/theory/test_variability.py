"""Directional classes of winds that are built to be of them."""

import numpy as np
import pytest

from barchan.theory.drift import drift_of
from barchan.theory.variability import variability


def spread(*winds, width=12.0):
    """Winds as (direction, amount), each spread over its neighbours."""
    degrees = np.arange(360.0)
    amount = np.zeros(360)
    for direction, weight in winds:
        away = (degrees - direction + 180) % 360 - 180
        amount += weight * np.exp(-0.5 * (away / width) ** 2)
    return drift_of([*zip(degrees, amount, strict=True)])


def two_lobes(width):
    """Two winds 115 degrees apart, 60 to 40, each spread over its neighbours."""
    return spread((240.0, 6.0), (355.0, 4.0), width=width)


@pytest.mark.parametrize("width", [15.0, 25.0, 30.0, 35.0])
def test_two_wide_lobes_that_a_clear_saddle_parts_are_bimodal(width):
    """At 35 degrees the saddle, 57.5 degrees off both, stands 0.65 as high as the lower peak."""
    saddle, lower = np.exp(-0.5 * (57.5 / 35.0) ** 2) * 10.0, 4.0 + 6.0 * np.exp(-0.5 * (115.0 / 35.0) ** 2)
    assert saddle / lower == pytest.approx(0.65, abs=0.01)
    found = variability(two_lobes(width))
    assert found.name == "obtuse bimodal"
    assert list(found.modes) == pytest.approx([240.0, 355.0], abs=8)


def test_two_lobes_so_wide_that_the_lower_one_is_a_shoulder_are_one():
    assert variability(two_lobes(50.0)).name == "wide unimodal"


@pytest.mark.parametrize("sectors", [12, 16, 36])
def test_an_even_wind_known_by_sectors_has_no_modes(sectors):
    even = drift_of([(360.0 * sector / sectors, 1.0) for sector in range(sectors)])
    assert variability(even).modes == ()


@pytest.mark.parametrize(
    ("drift", "name", "modes"),
    [
        (drift_of([(270.0, 1.0)]), "narrow unimodal", [270]),
        (drift_of([(340.0, 1.0), (25.0, 1.0)]), "narrow unimodal", None),
        (spread((5.0, 1.0)), "narrow unimodal", [5]),
        (spread((200.0, 1.0), width=35.0), "wide unimodal", [200]),
        (spread((250.0, 2.0), (320.0, 1.0)), "acute bimodal", [250, 320]),
        (spread((10.0, 1.0), (280.0, 2.0)), "acute bimodal", [280, 10]),
        (spread((10.0, 1.0), (145.0, 2.0)), "obtuse bimodal", [145, 10]),
        (spread((90.0, 1.0), (270.0, 1.1)), "obtuse bimodal", [270, 90]),
        (spread((0.0, 3.0), (120.0, 2.0), (240.0, 1.0)), "complex", [0, 120, 240]),
        (drift_of([(float(degree), 1.0) for degree in range(360)]), "complex", []),
        (drift_of([(10.0, 0.0)]), "still", []),
    ],
)
def test_winds_are_classed_by_their_modes(drift, name, modes):
    found = variability(drift)
    assert found.name == name
    if modes is not None:
        assert list(found.modes) == pytest.approx(modes, abs=3)


def test_the_class_does_not_depend_on_where_north_is():
    for turn in range(0, 360, 15):
        assert (
            variability(spread(((250.0 + turn) % 360, 2.0), ((320.0 + turn) % 360, 1.0))).name
            == "acute bimodal"
        )
