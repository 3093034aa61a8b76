"""Units in the words of UDUNITS."""

import pytest

from barchan.analysis.fields import PLAIN
from barchan.fields import GROUND
from barchan.models import models
from barchan.parameters import declarations
from barchan.simulation import Simulation
from barchan.udunits import cf_units, udunits
from tests.contract.test_every_model import scenario

BY_HAND = {
    "m": "m",
    "µm": "um",
    "kg/m³": "kg m-3",
    "kg/m²/h": "kg m-2 h-1",
    "m²/step": "m2",
    "m/s²": "m s-2",
    "h at -10 °C": "h",
    "600 s at -10 °C": "600 s",
    "Pa s": "Pa s",
    "degrees": "degree",
    "°C": "degC",
    "1/yr": "year-1",
    "grains/cell": "1",
    "cells/slab²": "1",
    "bonding time": "1",
    "quanta": "1",
    "-": "1",
    "": "1",
}


@pytest.mark.parametrize(("unit", "expected"), BY_HAND.items())
def test_a_unit_is_spelled_as_udunits_has_it(unit, expected):
    assert udunits(unit) == expected


@pytest.mark.parametrize("name", list(models()))
def test_every_field_of_every_model_has_a_unit_that_others_read(name):
    simulation = Simulation(scenario(name))
    fields = (GROUND, *PLAIN, *simulation.bed.declared.values(), *simulation.model.derived)
    assert [(field.name, field.unit) for field in fields if udunits(field.unit) is None] == []


@pytest.mark.parametrize("name", list(models()))
def test_so_has_every_parameter(name):
    units = {one.unit for one in declarations(models()[name].Parameters)}
    assert [unit for unit in units if udunits(unit) is None] == []


def test_of_an_unknown_unit_nothing_is_claimed():
    assert cf_units("furlongs") == {"unit": "furlongs"}
