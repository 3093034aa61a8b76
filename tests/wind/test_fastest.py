"""No wind is faster than any wind: a speed above 100 m/s is a mistake of unit."""

import pytest

from barchan.errors import ScenarioError
from barchan.scenario import validate


def scenario(wind):
    return validate({"barchan": 5, "wind": wind, "clock": {}})


REGIME = {"direction": 270.0, "steps": 5, "unit": "m/s"}


@pytest.mark.parametrize(
    ("wind", "key"),
    [
        ({"kind": "steady", "unit": "m/s", "speed": 101.0}, "wind.speed"),
        ({"kind": "steady", "unit": "m/s", "speed": 90_000.0}, "wind.speed"),
        ({"kind": "regimes", "regimes": [{**REGIME, "speed": 900.0}]}, "wind.regimes[0].speed"),
        (
            {"kind": "regimes", "regimes": [{**REGIME, "speed": 9.0, "final_speed": 900.0}]},
            "wind.regimes[0].final_speed",
        ),
        (
            {
                "kind": "regimes",
                "regimes": [
                    {
                        **REGIME,
                        "speed": 0.0,
                        "final_speed": 50.0,
                        "speed_ramp": {"kind": "points", "points": [{"time": 0.5, "value": 10.0}]},
                    }
                ],
            },
            "wind.regimes[0].speed_ramp",
        ),
    ],
)
def test_a_wind_above_100_metres_per_second_is_refused_with_the_hint_of_a_wrong_unit(wind, key):
    with pytest.raises(ScenarioError) as error:
        scenario(wind)
    (problem,) = error.value.problems
    assert problem.key == key
    assert "allowed: up to 100 m/s" in problem.message
    assert "another unit" in problem.message


def test_the_fastest_wind_and_any_hop_in_cells_are_taken():
    assert scenario({"kind": "steady", "unit": "m/s", "speed": 100.0}).wind.speed == 100.0
    assert scenario({"kind": "steady", "unit": "cells", "speed": 5000.0}).wind.speed == 5000.0
