"""``barchan schema``: the JSON schema of scenarios."""

import json
import subprocess
import sys

import jsonschema
import pytest

from barchan.scenario import Scenario, load_scenario, preset_names
from tests.tiny import data

BARCHAN = [sys.executable, "-c", "from barchan.cli import main; main()"]


@pytest.fixture(scope="module")
def schema():
    """The printed schema."""
    printed = subprocess.run([*BARCHAN, "schema"], check=True, stdout=subprocess.PIPE)
    return json.loads(printed.stdout)


@pytest.fixture(scope="module")
def validator(schema):
    """What checks data against the schema."""
    return jsonschema.Draft202012Validator(schema)


def groups_in(schema):
    """Every object that the schema describes."""
    yield schema
    yield from schema["$defs"].values()


def test_the_schema_describes_every_key(schema):
    assert set(schema["properties"]) == set(Scenario.model_fields)
    for group in groups_in(schema):
        assert group["type"] == "object"
        assert group["additionalProperties"] is False
        for name, key in group["properties"].items():
            assert key.get("description") or "$ref" in key, name


def test_the_schema_holds_bounds_units_and_choices(schema):
    rows = schema["$defs"]["Lattice"]["properties"]["rows"]
    assert (rows["minimum"], rows["maximum"], rows["unit"]) == (1, 65536, "cells")
    assert schema["$defs"]["Lattice"]["properties"]["boundary_x"]["enum"] == ["periodic", "open"]


def test_a_lattice_from_the_ground_holds_to_the_schema(schema):
    assert {"const": "from ground"} in schema["properties"]["lattice"]["anyOf"]
    assert schema["$defs"]["Lattice"]["properties"]["kind"]["enum"] == ["square", "hex", "from ground"]


def test_a_run_as_long_as_its_record_holds_to_the_schema(schema, validator):
    steps = schema["$defs"]["Run"]["properties"]["steps"]
    assert (steps["anyOf"][0]["maximum"], steps["anyOf"][1]) == (10**12, {"const": "record"})
    assert validator.is_valid({**data(), "run": {"steps": "record"}})


@pytest.mark.parametrize("name", preset_names())
def test_every_preset_holds_to_the_schema(validator, name):
    assert list(validator.iter_errors(load_scenario(name).data())) == []


@pytest.mark.parametrize(
    "change",
    [
        {"lattice": {"rows": 0}},
        {"latice": {}},
        {"model": {"name": "wernr"}},
        {"sand": {"kind": "flat", "mean": 2.5}},
        {"run": {"until": {"idle_steps": 0}}},
    ],
)
def test_what_barchan_refuses_the_schema_refuses(validator, change):
    assert not validator.is_valid({**data(), **change})


def test_the_schema_asks_for_the_formats_version(schema):
    assert "barchan" in schema["required"]
