"""Every key a scenario may have is listed, and what the list says of it is true."""

import pytest

from barchan.models import models
from barchan.scenario import Scenario, load_scenario
from barchan.scenario.listing import all_keys

KEYS = list(all_keys())

OWN = {"name", "max_hops", "band_rows", "iterations_per_step", "shelter_every"}
"""Parameters of models that no paper knows: the model's tag, a cap, the work's order and its rhythm."""

OPTIONAL = ("clock.", "weather.", "wind.gusts.", "run.until.steady.")
"""Groups that a scenario need not have."""


def keys_within(data, prefix=""):
    """Dotted keys of all values in plain data."""
    for key, value in data.items():
        if isinstance(value, dict):
            yield from keys_within(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}"


def test_every_value_of_a_complete_scenario_is_listed():
    gusty = {"kind": "steady", "speed": 9.0, "unit": "m/s", "gusts": {}}
    data = {"barchan": 5, "clock": {}, "wind": gusty, "run": {"until": {"steady": {}}}}
    scenario = load_scenario(data)
    assert set(keys_within(scenario.data())) - {"influx", "weather"} <= {key.key for key in KEYS}


def test_listed_defaults_are_the_values_of_a_scenario_that_gives_none():
    data = load_scenario({"barchan": 5}).data()
    headings = {'ground, kind "flat"', 'sand, kind "flat"', 'wind, kind "steady"', 'model, name "werner"'}
    for key in KEYS:
        if (", " in key.heading and key.heading not in headings) or "[]" in key.key:
            continue
        value = data
        for step in key.key.split("."):
            value = value and value[step]
        if not key.key.startswith(OPTIONAL):
            assert value == key.default, key.key


@pytest.mark.parametrize("key", KEYS, ids=lambda key: f"{key.heading}:{key.key}")
def test_every_listed_key_has_unit_bounds_and_meaning(key):
    assert key.unit
    assert key.bounds
    assert key.meaning


@pytest.mark.parametrize("name", list(models()))
def test_every_parameter_of_a_model_has_a_source_or_is_the_programs_own(name):
    listed = [key for key in KEYS if key.heading == f'model, name "{name}"']
    without = {key.key.removeprefix("model.") for key in listed if not key.source}
    assert listed
    assert without <= OWN


def test_keys_of_variants_stand_under_each_of_them():
    headings = {key.heading for key in KEYS if key.key == "sand.mean"}
    assert {'sand, kind "flat"', 'sand, kind "random"', 'sand, kind "dropped"'} <= headings
    assert 'sand, kind "level"' not in headings


def test_groups_are_listed_in_the_order_of_a_scenario():
    order = [key.heading.split(",")[0] for key in KEYS if key.heading != "scenario"]
    groups = [name for name in Scenario.model_fields if name in order]
    assert list(dict.fromkeys(order)) == groups


def test_keys_of_parts_are_listed():
    parts = [key.key for key in KEYS if key.heading == 'sand, kind "dropped"' and "parts[]" in key.key]
    assert parts == [f"sand.parts[].{name}" for name in ("west", "east", "south", "north", "mean")]
