"""A run as long as the record of its wind.

Right values: six rows of ten minutes are 3600 s, 36 steps of 100 s, and 5.14 steps of 700 s.
"""

import pytest

from barchan.errors import ScenarioError
from barchan.scenario import load_scenario


@pytest.fixture
def data(tmp_path):
    path = tmp_path / "hour.csv"
    rows = [f"2024-01-10T00:{10 * n:02d},9,{260 + n}" for n in range(6)]
    path.write_text("\n".join(["time,wind_speed (m/s),wind_dir", *rows]) + "\n", "utf-8")
    return {
        "barchan": 5,
        "lattice": {"rows": 16, "columns": 16},
        "clock": {"step_seconds": 100.0},
        "wind": {"kind": "record", "path": str(path), "repeat": False},
        "run": {"steps": "record", "seed": 1},
    }


def refused(data, overrides=()):
    with pytest.raises(ScenarioError) as caught:
        load_scenario(data, overrides)
    return [(problem.key, problem.message) for problem in caught.value.problems]


@pytest.mark.parametrize(("seconds", "steps"), [(100.0, 36), (700.0, 6), (3600.0, 1), (1e6, 1)])
def test_a_run_has_the_steps_that_its_record_lasts(data, seconds, steps):
    data["clock"]["step_seconds"] = seconds
    assert load_scenario(data).run.steps == steps


def test_the_scenario_states_the_steps_that_it_took(data):
    found = load_scenario(data)
    assert found.data()["run"]["steps"] == 36
    assert found.time_facts()["wind lasts"].endswith("the run (run.steps 36) is as long")


def test_it_may_be_asked_for_on_the_command_line(data):
    data["run"]["steps"] = 5
    assert load_scenario(data, [("run.steps", "record")]).run.steps == 36
    assert load_scenario(data | {"run": {"steps": "record"}}, [("steps", "7")]).run.steps == 7


def test_made_up_storms_have_an_end_too(data):
    data |= {"wind": {"kind": "storms", "days": 2.0, "repeat": False}}
    assert load_scenario(data).run.steps == 2 * 864


def test_a_record_that_starts_over_has_no_length(data):
    data["wind"]["repeat"] = True
    (found,) = refused(data)
    assert found[0] == "run.steps"
    assert "set wind.repeat to false" in found[1]


def test_a_wind_without_a_record_gives_no_steps(data):
    assert refused(data | {"wind": {"kind": "steady"}}) == [
        ("run.steps", "is 'record', which needs a wind of kind 'record' or 'storms'")
    ]


def test_a_record_that_cannot_be_read_is_named_with_its_place(data):
    data["wind"]["path"] = "gone.csv"
    with pytest.raises(ScenarioError, match="no such file"):
        load_scenario(data)
