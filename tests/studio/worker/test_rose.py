"""Roses and drift of winds of every kind."""

import math

import pytest

from barchan.aeolian.saltation import Saltation
from barchan.scenario import validate
from barchan.simulation import Simulation
from barchan.studio.worker.rose import rose_of
from barchan.theory.wind_report import OF_SAND, of_record, of_winds
from barchan.theory.wind_table import drift_rows
from barchan.wind.records import read_record
from barchan.wind.records.reading import SAMPLE

TINY = {"barchan": 5, "lattice": {"rows": 16, "columns": 16}, "run": {"steps": 40, "seed": 1}}
WEST, SOUTH = 12, 8  # of 16 sectors, clockwise from north


def test_two_winds_in_turn_share_the_time_and_move_sand_between_their_ways():
    regimes = [{"direction": 270, "steps": 10}, {"direction": 180, "steps": 10}]
    rose = rose_of(Simulation(validate({**TINY, "wind": {"kind": "regimes", "regimes": regimes}})))
    shares = [sum(petal) for petal in rose["shares"]]
    assert shares[WEST] == pytest.approx(0.5)
    assert shares[SOUTH] == pytest.approx(0.5)
    assert rose["calms"] == pytest.approx(0.0)
    assert (rose["days"], rose["limits"]) == (None, [])
    # Equal amounts towards east and north: north-east, sqrt(1² + 1²) of the 2 that move.
    assert rose["toward"] == pytest.approx(45.0)
    assert rose["steadiness"] == pytest.approx(math.sqrt(2) / 2)


def test_a_record_comes_with_the_rows_and_remarks_of_the_command_line():
    """Of the record that ships with Barchan, as ``barchan wind`` prints them."""
    told = rose_of(Simulation(validate({**TINY, "wind": {"kind": "record"}, "clock": {}})))
    found = dict(told["rows"])
    subject = of_record(read_record(SAMPLE), Saltation(), 1.0, "wind.columns.height")
    for name, value, unit in (*subject.rows, *drift_rows(subject.found)):
        if name not in ("", "dunes to expect"):  # which depends on the supply
            assert found[name] == f"{value} {unit}".rstrip()
    assert "energy high" in found["drift potential"]
    assert "RDP/DP 0.56" in found["resultant"]
    assert found["crests, gross transport"] == "azimuth 116°"
    assert set(subject.found.remarks) <= set(told["remarks"])


def test_a_wind_in_metres_per_second_has_its_class_of_speed_and_its_days():
    wind = {"kind": "steady", "direction": 270, "speed": 9.0, "unit": "m/s"}
    scenario = validate({**TINY, "wind": wind, "clock": {}})
    rose = rose_of(Simulation(scenario))
    assert rose["days"] == pytest.approx(40 * scenario.step_seconds / 86_400)
    speeds = [0.0, *rose["limits"], math.inf]
    column = next(at for at in range(len(speeds) - 1) if speeds[at] <= 9.0 < speeds[at + 1])
    assert rose["shares"][WEST][column] == pytest.approx(1.0)
    assert rose["toward"] == pytest.approx(90.0)
    assert rose["crest"] == pytest.approx(0.0)  # across the wind


@pytest.mark.parametrize(("name", "said"), [("snow", True), ("snow_werner", True), ("werner", False)])
def test_of_winds_over_snow_it_is_said_what_holds_for_sand_only(name, said):
    found = of_winds(validate({**TINY, "model": {"name": name}}), 1.0)
    assert (OF_SAND in found.all_remarks) is said


def test_over_snow_the_panel_is_told_of_the_wind_alone():
    """What holds for dry sand only is left out, with one remark on that."""
    record = {"wind": {"kind": "record"}, "model": {"name": "snow"}}
    told = rose_of(Simulation(validate({**TINY, **record})))
    names = [name for name, _ in told["rows"]]
    assert "wind speed" in names
    assert not {"sand supply", "flux law", "drift potential", "dunes to expect"} & set(names)
    assert (told["sand"], told["crest"], told["toward"]) == (None, None, None)
    assert told["remarks"].count(OF_SAND) == 1
    steady = rose_of(Simulation(validate({**TINY, "model": {"name": "snow_werner"}})))
    assert (steady["rows"], steady["warnings"], steady["remarks"]) == ([], (), (OF_SAND,))
    assert sum(map(sum, steady["shares"])) == pytest.approx(1.0)
