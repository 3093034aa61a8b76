"""An oblique wind as a mixture of two winds along the axes."""

import pytest
from pydantic import ValidationError

from barchan.simulation import Simulation
from barchan.wind import MixedAxes
from tests.tiny import tiny
from tests.wind.blown import forcing, segments


def test_a_third_of_the_polls_goes_along_one_axis_and_two_thirds_along_the_other():
    found = segments(MixedAxes(kind="mixed_axes"), 0, 1, cells=300)
    polls = {d: sum(s.polls for s in found if s.direction == d) for d in (270.0, 180.0)}
    assert polls == {270.0: 100, 180.0: 200}
    assert [s.direction for s in found[:4]] == [270.0, 180.0, 270.0, 180.0]


def test_a_third_and_two_thirds_come_to_an_angle_of_63_degrees():
    wind = MixedAxes(kind="mixed_axes")
    assert wind.nominal_direction == pytest.approx(270.0 - 63.435, abs=1e-3)
    assert forcing(wind).wind_of(0).direction == pytest.approx(wind.nominal_direction)


def test_transport_goes_along_the_nominal_direction():
    wind = {"kind": "mixed_axes", "first": 90, "second": 0, "share": 0.5}
    simulation = Simulation(tiny(wind=wind))
    tally = simulation.advance(30)
    assert tally.travel_x == pytest.approx(tally.travel_y, rel=0.1)
    assert tally.travel_x < 0


def test_axes_must_cross():
    with pytest.raises(ValidationError, match="second is 270 where first is 90; allowed: 180 or 0"):
        MixedAxes(kind="mixed_axes", first=90, second=270)
