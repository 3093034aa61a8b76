"""Values are shown in units that suit them."""

import math

import pytest

from barchan.analysis.suited_units import LADDERS, spoken, suited


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (0.0032, "m", "3.2 mm"),
        (0.05, "m", "5 cm"),
        (0.3333, "m", "0.3333 m"),
        (4.2e-5, "m", "42 µm"),
        (21.25, "m", "21.25 m"),
        (25_000.0, "m", "25 km"),
        (-0.0032, "m", "-3.2 mm"),
        (5259.6, "m/yr", "1 cm/min"),
        (12.0, "m/yr", "12 m/yr"),
        (0.004, "m/yr", "4 mm/yr"),
        (0.25, "cells/step", "0.25 cells/step"),
        (2.5e-4, "m/step", "250 µm/step"),
        (0.372, "fraction", "37.2%"),
        (92.1, "degrees", "92.1°"),
        (2e-6, "m³", "2 cm³"),
        (14.6, "-", "14.6"),
        (0.0, "m", "0 m"),
        (math.nan, "m", "– m"),
    ],
)
def test_a_value_is_spoken_in_a_unit_that_suits_it(value, unit, text):
    assert spoken(value, unit) == text


@pytest.mark.parametrize("unit", LADDERS)
@pytest.mark.parametrize("exponent", range(-12, 13))
def test_a_suited_value_is_the_same_quantity(unit, exponent):
    value = 1.7 * 10.0**exponent
    shown, name = suited(value, unit)
    sizes = {found: size for found, size, _ in LADDERS[unit]}
    assert shown * sizes[name] == pytest.approx(value, rel=1e-12)
