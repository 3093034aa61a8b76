"""What must hold for a run of any scenario, however it is cut."""

import json
from random import Random
from typing import Any

import numpy as np

from barchan.errors import BarchanError, ConservationError
from barchan.scenario import validate
from barchan.scenario.cost import expected_seconds
from barchan.simulation import Simulation, State, event_from
from tests.random_runs.drawing import event, live_parameters

REFUSED, RAN, LONG = "refused", "ran", "left out, for it would run for minutes"

ENDLESS = 60.0
"""Seconds that a scenario may be expected to run: rare ones move sand for hours, as ``check`` foretells."""

TRAVEL = ("travel_x", "travel_y")
"""Sums of real numbers, which depend on the order of adding in their last digits."""


def check(data: dict[str, Any], number: int, few: bool = True) -> str:
    """Run a scenario in one go and in pieces, resumed from each; raises AssertionError where they differ.

    ``few``: events change nothing that decides which kernels are compiled.
    Returns whether it was refused, as a scenario that is not sound may be, ran, or is foretold to take
    minutes and was left out.
    """
    try:
        sound = validate(data)
        if expected_seconds(sound) > ENDLESS:
            return LONG
        whole = Simulation(sound)
    except ConservationError:
        raise
    except BarchanError:
        return REFUSED
    events = _events(Random(number), data, few)
    pieces = Simulation.from_state(_written(whole.state()))
    ends = sorted({step for step, _ in events} | {sound.run.steps})
    whole, accepted = _run(whole, ends, events, resumes=False)
    rng = Random(number + 1)
    cuts = sorted({*ends, *(rng.randint(1, sound.run.steps) for _ in range(4))})
    pieces, accepted_again = _run(pieces, cuts, events, resumes=True)
    assert accepted == accepted_again
    _assert_same(whole.state(), pieces.state())
    return RAN


def _events(rng: Random, data: dict[str, Any], few: bool) -> list[tuple[int, dict[str, Any]]]:
    live = live_parameters(data["model"]["name"])
    steps = [rng.randint(0, data["run"]["steps"]) for _ in range(rng.choice([0, 0, 1, 2]))]
    return [(step, event(rng, data, live, few)) for step in sorted(steps)]


def _run(
    simulation: Simulation, ends: list[int], events: list[tuple[int, Any]], resumes: bool
) -> tuple[Simulation, list[bool]]:
    """Advance to each end and let the events of that step happen; where it ``resumes``, from a checkpoint.

    Returns the simulation and which events it accepted.
    """
    accepted = []
    for end in ends:
        simulation.advance(max(end - simulation.steps_done, 0))
        _assert_finite(simulation)
        accepted += [_accepts(simulation, change) for step, change in events if step == end]
        if resumes:
            simulation = Simulation.from_state(_written(simulation.state()))
    return simulation, accepted


def _accepts(simulation: Simulation, change: dict[str, Any]) -> bool:
    try:
        simulation.apply(event_from(change))
    except ConservationError:
        raise
    except BarchanError:
        return False
    return True


def _written(state: State) -> State:
    """The state as it comes back from a file: its data through JSON."""
    return State(json.loads(json.dumps(state.data)), {name: a.copy() for name, a in state.arrays.items()})


def _assert_finite(simulation: Simulation) -> None:
    arrays = simulation.state().arrays.items()
    for name, array in arrays:
        if array.dtype.kind == "f" and not name.startswith("stop/"):
            assert np.isfinite(array).all(), f"{name} holds numbers that are not finite"
    assert np.isfinite(simulation.elevation).all()
    assert int(simulation.bed.stack.min()) >= 0


def _assert_same(one: State, other: State) -> None:
    assert set(one.arrays) == set(other.arrays)
    for name, array in one.arrays.items():
        np.testing.assert_array_equal(array, other.arrays[name], err_msg=name)
    mine, theirs = ({**state.data, "tally": dict(state.data["tally"])} for state in (one, other))
    for key in TRAVEL:
        np.testing.assert_allclose(mine["tally"].pop(key), theirs["tally"].pop(key), rtol=1e-9, atol=1e-6)
    assert json.dumps(mine, sort_keys=True) == json.dumps(theirs, sort_keys=True)
