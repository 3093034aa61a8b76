"""A state is all that it takes to go on with the same bits."""

import itertools
import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.errors import ConservationError
from barchan.simulation import SetParameter, SetWind, Simulation, State, Stroke
from barchan.wind import Steady
from tests.tiny import RIDGES, VARIANTS, tiny

STEADY = {**RIDGES, "run__until": {"steady": {"window": 20, "tolerance": 0.7}}, "run__steps": 100}

EVENTS = [
    SetParameter(key="model.hop_length", value=3.0),
    SetWind(wind=Steady(direction=120.0)),
    Stroke(x=5.0, y=3.0, radius=4.0, amount=6),
]


def through_json(state):
    """The state as it comes back from a disk."""
    arrays = {name: array.copy() for name, array in state.arrays.items()}
    return State(json.loads(json.dumps(state.data)), arrays)


@pytest.mark.parametrize("changes", VARIANTS.values(), ids=list(VARIANTS))
@settings(max_examples=5)
@given(before=st.integers(0, 9), after=st.integers(0, 9))
def test_a_restored_simulation_goes_on_with_the_same_bits(same, changes, before, after):
    unbroken = Simulation(tiny(**changes))
    unbroken.advance(before)
    restored = Simulation.from_state(through_json(unbroken.state()))
    same(unbroken, restored)
    unbroken.advance(after)
    restored.advance(after)
    same(unbroken, restored)


def test_a_restored_simulation_goes_on_under_the_events_that_happened(same):
    unbroken = Simulation(tiny())
    for event in EVENTS:
        unbroken.advance(3)
        unbroken.apply(event)
    restored = Simulation.from_state(through_json(unbroken.state()))
    same(unbroken, restored)
    assert restored.model.parameters.hop_length == 3.0
    assert restored.wind.direction == 120.0
    unbroken.advance(7)
    restored.advance(7)
    same(unbroken, restored)


def test_events_leave_the_scenario_as_it_was_written():
    simulation = Simulation(tiny())
    for event in EVENTS:
        simulation.apply(event)
    restored = Simulation.from_state(through_json(simulation.state()))
    assert simulation.scenario == restored.scenario == tiny()


@pytest.mark.parametrize("before", [0, 1, 7, 20, 27, 28])
def test_a_restored_watch_ends_the_run_at_the_same_step_for_the_same_reason(same, before):
    unbroken = Simulation(tiny(**STEADY))
    unbroken.advance(before)
    restored = Simulation.from_state(through_json(unbroken.state()))
    unbroken.advance(100)
    restored.advance(100)
    same(unbroken, restored)
    assert unbroken.finished.startswith("steady for 20 steps")
    assert unbroken.steps_done < 100


@pytest.mark.parametrize("before", [0, 4, 5, 8])
def test_a_restored_run_neither_repeats_nor_misses_a_frame(before):
    simulation = Simulation(tiny())
    steps = [frame.step for frame in itertools.islice(simulation, before // 5 + 1)]
    simulation.advance(before - simulation.steps_done)
    restored = Simulation.from_state(through_json(simulation.state()))
    steps += [frame.step for frame in restored]
    assert steps == [0, 5, 10, 15, 20]


def test_a_state_keeps_still_while_its_simulation_goes_on():
    simulation = Simulation(tiny(**STEADY))
    simulation.advance(5)
    state = simulation.state()
    data, sand = json.dumps(state.data), state.arrays["bed/sand"].copy()
    simulation.advance(30)
    simulation.apply(EVENTS[0])
    assert json.dumps(state.data) == data
    np.testing.assert_array_equal(state.arrays["bed/sand"], sand)


def test_two_simulations_from_one_state_do_not_touch_each_other(same):
    state = Simulation(tiny(**STEADY)).state()
    first, second = Simulation.from_state(state), Simulation.from_state(state)
    first.advance(30)
    second.advance(30)
    same(first, second)


def test_a_state_knows_its_step():
    simulation = Simulation(tiny())
    simulation.advance(13)
    assert simulation.state().step == 13


def test_a_state_with_sand_missing_is_not_taken_up():
    state = Simulation(tiny()).state()
    state.arrays["bed/sand"][3, 4] += 1
    with pytest.raises(ConservationError, match="does not close"):
        Simulation.from_state(state)
