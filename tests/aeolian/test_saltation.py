"""From a wind speed to a flux."""

import numpy as np
import pytest
from pydantic import ValidationError

from barchan.aeolian import Saltation
from barchan.aeolian.flux import LAWS
from barchan.parameters import declarations


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("threshold", [None, 6.0])
def test_sand_moves_just_above_the_threshold_speed_and_not_at_it(law, threshold):
    sand = Saltation(law=law, threshold=threshold)
    limit = sand.threshold_speed()
    assert sand.mass_flux(limit * 0.999999) == 0
    assert sand.mass_flux(limit * 1.001) > 0
    assert sand.friction_velocity(limit) == pytest.approx(sand.threshold_friction_velocity())


def test_dune_sand_begins_to_move_near_the_twelve_knots_of_the_field():
    assert Saltation().threshold_speed() == pytest.approx(12 * 1852 / 3600, rel=0.05)


def test_sand_as_it_lies_fills_more_than_its_grains():
    sand = Saltation(porosity=0.4)
    assert sand.mass_flux(12.0) == pytest.approx(sand.volume_flux(12.0) * 2650 * 0.6)


def test_a_smoother_ground_lowers_the_flux_of_the_same_wind():
    rough, smooth = Saltation(threshold=None), Saltation(roughness=None)
    assert smooth.roughness_length == pytest.approx(0.25e-3 / 30)
    assert smooth.mass_flux(14.0) < rough.mass_flux(14.0) / 3


def test_a_wind_measured_lower_down_is_a_stronger_one():
    assert Saltation(height=2.0).friction_velocity(8.0) > Saltation(height=10.0).friction_velocity(8.0)


def test_a_height_within_the_roughness_is_refused():
    with pytest.raises(ValidationError, match=r"height is 0\.5 m; allowed: above the roughness length, 1 m"):
        Saltation(height=0.5, roughness=1.0)


def test_speeds_keep_their_shape():
    assert Saltation().volume_flux(np.full((3, 2), 9.0)).shape == (3, 2)


def test_every_parameter_says_what_it_is():
    for declared in declarations(Saltation):
        assert declared.unit
        assert declared.meaning.endswith(".")
        assert declared.bounds
        assert declared.source or declared.key == "threshold"
