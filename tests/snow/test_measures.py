"""What tables show of snow: how much the wind can take, how much has bonded, and the class of its forms."""

import dataclasses

import numpy as np
import pytest

from barchan.analysis.declared_measures import MEASURES, Value
from barchan.analysis.forms import form
from barchan.snow.conditions import Conditions
from barchan.snow.measures import bonded_share, mobile_share
from tests.snow.scenes import snow
from tests.tiny import tiny


def test_snow_that_is_half_a_day_old_is_bonded_and_too_strong_for_a_wind_that_moves_fresh_drift():
    """Drift of 12 hours withstands 12.2 m/s, fresh drift 7.6 m/s; a quarter of the field holds no snow."""
    simulation = snow(10, {"speed": 0.0}, start_density=350.0, start_age=12.0)
    bed = simulation.bed
    change = np.zeros(bed.lattice.shape, np.int64)
    change[:8] = -10
    change[8:16] = 1
    bed.lay(change)
    simulation.model.relax(bed, np.zeros(bed.lattice.shape, bool))
    assert bonded_share(bed, 3.0) == pytest.approx(2 / 3)
    assert mobile_share(bed, Conditions(simulation.model.parameters, 10.0, -10.0)) == pytest.approx(1 / 3)
    assert mobile_share(bed, Conditions(simulation.model.parameters, 14.0, -10.0)) == 1.0
    assert mobile_share(bed, Conditions(simulation.model.parameters, 6.0, -10.0)) == 0.0


def test_the_class_of_a_frame_follows_from_its_measures():
    scenario = snow().scenario
    of = {measure.name: measure for measure in MEASURES}
    found = {"relief": 0.2, "spacing": 5.0, "slope_skewness": -0.8, "speed": 0.001, "bonded_share": 0.1}
    values = [
        Value(dataclasses.replace(of["spacing"], name=name), value, "") for name, value in found.items()
    ]
    assert form(values, scenario) == "depositional, moving"
    assert form(values, tiny()) is None
