"""The closures of snow as curves, against values of their publications."""

import numpy as np
import pytest

from barchan.models import models
from barchan.scenario import validate


@pytest.fixture(scope="module")
def curves():
    scenario = validate({"barchan": 5, "model": {"name": "snow"}, "run": {"steps": 1}})
    return {(c.title, c.y_title): c for c in models()["snow"].curves(scenario.model)}


@pytest.mark.parametrize(("hours", "wind"), [(1.0, 7.8), (6.0, 9.2), (24.0, 10.6), (240.0, 13.7)])
def test_snow_withstands_the_winds_of_its_age(curves, hours, wind):
    """Fallen snow at -10 °C: the fit to the medians of Li & Pomeroy, worked out by hand to 0.1 m/s."""
    curve = curves["fallen, 100 kg/m³, at -10 °C", "threshold wind at 10 m (m/s)"]
    assert np.interp(np.log(hours), np.log(curve.x), curve.y) == pytest.approx(wind, abs=0.06)
    assert "Li & Pomeroy 1997" in curve.source


def test_bonds_grow_twice_as_fast_at_0_as_at_minus_10(curves):
    """exp[41000 / 8.314 (1/263.15 - 1/273.15)] = 1.99."""
    curve = next(c for (_, y), c in curves.items() if y.startswith("speed of bonding"))
    assert np.interp(-10.0, curve.x, curve.y) == pytest.approx(1.0)
    assert curve.y[-1] == pytest.approx(1.99, abs=0.01)


def test_every_curve_names_its_quantities_with_units_and_its_source(curves):
    for curve in curves.values():
        assert curve.source
        assert "(" in curve.x_title
        assert "(" in curve.y_title or curve.y_title.startswith("speed of bonding over")
        assert np.isfinite(curve.y).all()


def test_snow_that_does_not_pack_has_no_curve_of_packing():
    scenario = validate(
        {"barchan": 5, "model": {"name": "snow", "packing": {"law": "none"}}, "run": {"steps": 1}}
    )
    titles = {curve.y_title for curve in models()["snow"].curves(scenario.model)}
    assert "density of a layer (kg/m³)" not in titles
