"""Every event that a run accepts survives its own journal: written, read, resumed and branched from."""

import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import barchan
from barchan.errors import BarchanError
from barchan.models import models
from barchan.parameters import declarations
from barchan.scenario import Scenario
from barchan.simulation import Simulation, State
from barchan.simulation.events import Record, SetWind, event_from
from tests.scenario.strategies import group, values
from tests.tiny import tiny

FLYING = {"cell_size": 0.01, "slab_height": 1.5e-4}


def started(name: str) -> Simulation:
    """A small run of a model, before its first step."""
    lattice = {"rows": 8, "columns": 8, **(FLYING if hasattr(models()[name], "closures") else {})}
    return Simulation(barchan.load({"barchan": 5, "lattice": lattice, "model": {"name": name}}, seed=1))


def live(name: str) -> list[str]:
    return [d.key for d in declarations(models()[name].Parameters) if d.live]


def value_of(name: str, key: str) -> st.SearchStrategy[Any]:
    """Any value that the declaration of a live parameter allows."""
    parameters = models()[name].Parameters
    *groups, last = key.split(".")
    for inner in groups:
        parameters = parameters.model_fields[inner].annotation
    return values(parameters.model_fields[last].annotation, parameters.model_fields[last].metadata)


def reread(simulation: Simulation) -> Simulation:
    """The simulation after its state went through text, as a checkpoint does."""
    state = simulation.state()
    return Simulation.from_state(State(json.loads(json.dumps(state.data)), state.arrays))


@pytest.mark.parametrize(("name", "key"), [(name, key) for name in models() for key in live(name)])
@settings(max_examples=8, deadline=None)
@given(data=st.data())
def test_every_value_of_a_live_parameter_survives_the_journal(name, key, data):
    simulation = started(name)
    value = data.draw(value_of(name, key))
    try:
        record = simulation.apply(event_from({"kind": "set", "key": f"model.{key}", "value": value}))
    except BarchanError:
        assert simulation.events == []
        return
    assert Record.from_data(json.loads(json.dumps(record.data()))) == record
    assert reread(simulation).model.parameters == simulation.model.parameters
    assert reread(simulation).events == simulation.events


@pytest.mark.parametrize(
    ("name", "key"), [("werner", "static_repose_angle"), ("ripples", "relief_flow.stress_in_phase")]
)
def test_a_parameter_that_may_be_absent_can_be_set_to_null(name, key):
    simulation = started(name)
    simulation.apply(
        event_from({"kind": "set", "key": f"model.{key}", "value": 15.0 if "." in key else 60.0})
    )
    simulation.apply(event_from({"kind": "set", "key": f"model.{key}", "value": None}))
    assert [event.value for event in (r.event for r in reread(simulation).events)][-1] is None


@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_every_wind_that_a_run_takes_survives_the_journal(data):
    simulation = Simulation(tiny(clock={}))
    kinds = Scenario.model_fields["wind"].annotation.__args__
    wind = data.draw(st.sampled_from(kinds).flatmap(group))
    try:
        record = simulation.apply(event_from({"kind": "wind", "wind": wind}))
    except BarchanError:
        assert simulation.events == []
        return
    assert isinstance(record.event, SetWind)
    assert Record.from_data(json.loads(json.dumps(record.data()))) == record
    assert reread(simulation).wind == simulation.wind


def test_a_run_whose_parameter_was_set_to_null_is_resumed_and_branched(tmp_path):
    run = tmp_path / "run"
    simulation = Simulation(tiny(model__static_repose_angle=60.0))
    simulation.advance(2)
    simulation.apply(event_from({"kind": "set", "key": "model.static_repose_angle", "value": None}))
    barchan.run(simulation, run)
    assert barchan.branch(run, at=4).simulation.model.parameters.static_repose_angle is None
    assert barchan.resume(run, steps=25).reason == "all steps done"


def test_a_journal_that_left_a_null_out_is_read():
    record = Record.from_data({"step": 3, "kind": "set", "key": "model.static_repose_angle"})
    assert record.event.value is None


def test_a_mistake_in_an_event_names_the_keys_of_its_kind():
    with pytest.raises(barchan.ScenarioError, match="unknown key; did you mean 'value'"):
        event_from({"kind": "set", "key": "model.p_s", "valu": 3})


@pytest.mark.parametrize(
    ("name", "key"),
    [
        ("werner", "static_repose_angle"),
        ("ripples", "repose_angle"),
        pytest.param("wang_hu", "repose_angle", marks=pytest.mark.extended),
    ],
)
def test_slopes_next_to_the_vertical_are_no_overflow(name, key):
    """The tangent of the steepest angle is 5e15, and a lattice of flat slabs multiplies it."""
    simulation = started(name)
    simulation.apply(event_from({"kind": "set", "key": f"model.{key}", "value": 89.99999999999999}))
    assert simulation.advance(2).steps == 2


def test_a_key_of_an_earlier_format_is_the_one_of_today():
    event = event_from({"kind": "set", "key": "model.release_angle", "value": 40.0})
    assert (event.key, event.value) == ("model.static_repose_angle", 40.0)
