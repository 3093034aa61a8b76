"""Every event that a run accepts survives its own journal."""

import json
from random import Random

import pytest

from barchan.errors import BarchanError
from barchan.models import models
from barchan.simulation import Record, SetParameter, Simulation
from tests.random_runs.drawing import live_parameters, value
from tests.tiny import tiny

LIVE = [(name, key, field) for name in models() for key, field in live_parameters(name)]


@pytest.mark.parametrize(("name", "key", "field"), LIVE, ids=[f"{name} {key}" for name, key, _ in LIVE])
def test_any_allowed_value_of_a_live_parameter_survives_the_journal(name, key, field):
    rng = Random(f"{name} {key}")
    for _ in range(12):
        event = SetParameter(key=key, value=value(rng, field.annotation, field.metadata, key))
        record = Record(3, event)
        assert Record.from_data(json.loads(json.dumps(record.data()))) == record


def test_a_parameter_set_to_null_stays_null_when_the_run_is_resumed():
    simulation = Simulation(tiny(model__static_repose_angle=40.0))
    simulation.advance(2)
    simulation.apply(SetParameter(key="model.static_repose_angle", value=None))
    state = simulation.state()
    assert state.data["events"] == [
        {"step": 2, "kind": "set", "key": "model.static_repose_angle", "value": None}
    ]
    resumed = Simulation.from_state(state)
    assert resumed.events == simulation.events
    assert resumed.model.parameters.static_repose_angle is None


def test_a_null_where_a_number_is_needed_is_refused():
    simulation = Simulation(tiny())
    with pytest.raises(BarchanError, match=r"model\.hop_length"):
        simulation.apply(SetParameter(key="model.hop_length", value=None))
    assert simulation.events == []
