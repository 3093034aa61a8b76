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
        (0.25, "cells/step", "0.25 cells/step"),
        (0.372, "fraction", "37.2%"),
        (92.1, "degrees", "92.1°"),
        (2e-6, "m³", "2 cm³"),
        (14.6, "-", "14.6"),
        (0.0, "m", "0 m"),
        (math.nan, "m", "– m"),
    ],
)
def test_a_value_is_spoken_in_a_unit_that_suits_it(value, unit, text):
    assert spoken(value, unit, 1.0) == text


@pytest.mark.parametrize(
    ("value", "unit", "dunes", "ripples"),
    [
        (5259.6, "m/yr", "5260 m/yr", "1 cm/min"),  # 31,557,600 s are 525,960 minutes
        (0.004, "m/yr", "0.004 m/yr", "7.605e-07 cm/min"),
        (2.5e-4, "m/step", "0.00025 m/step", "0.25 mm/step"),
        (0.0, "m/step", "0 m/step", "0 mm/step"),
        (3.0, "m²/step", "3 m²/step", "30000 cm²/step"),
        (3155.76, "m²/yr", "3156 m²/yr", "1 cm²/s"),
    ],
)
def test_migration_and_flux_have_one_unit_for_dunes_and_one_for_ripples_whatever_their_value(
    value, unit, dunes, ripples
):
    assert (spoken(value, unit, 1.0), spoken(value, unit, 0.005)) == (dunes, ripples)


@pytest.mark.parametrize("unit", LADDERS)
@pytest.mark.parametrize("exponent", range(-12, 13))
def test_a_suited_value_is_the_same_quantity(unit, exponent):
    value = 1.7 * 10.0**exponent
    shown, name = suited(value, unit, 1.0)
    sizes = {found: size for found, size, _ in LADDERS[unit]}
    assert shown * sizes[name] == pytest.approx(value, rel=1e-12)


def test_migration_and_flux_of_short_steps_are_by_the_hour():
    # a year of 365.25 days has 8766 hours
    assert spoken(8766.0, "m/yr", 0.25, 4.3) == "1 m/h"
    assert spoken(17532.0, "m²/yr", 0.25, 4.3) == "2 m²/h"
    assert spoken(8766.0, "m/yr", 5.0, 86400.0) == "8766 m/yr"
    assert spoken(0.0, "m/yr", 0.25, 4.3) == "0 m/h"
