"""Conditions that end a run before its last step, and their record."""

import math

import numpy as np
import pytest

from barchan.errors import BarchanError
from barchan.measures import crest_orientation, dominant_spacing, migration
from barchan.simulation import Simulation
from barchan.simulation.stop import StopConditions
from tests.tiny import RIDGES, tiny

BARE = {"sand": {"kind": "flat", "mean": 0}}


@pytest.mark.parametrize("calls", [[20], [1] * 20, [3, 3, 14]])
def test_a_bare_field_ends_its_run_after_as_many_idle_steps_as_asked(calls):
    simulation = Simulation(tiny(run__until={"idle_steps": 4}, **BARE))
    for steps in calls:
        simulation.advance(steps)
    assert simulation.steps_done == 4
    assert simulation.finished == "nothing moved for 4 steps"
    assert simulation.done


def test_a_bare_field_runs_to_its_last_step_unless_asked_to_stop():
    simulation = Simulation(tiny(**BARE))
    simulation.advance(20)
    assert simulation.steps_done == 20
    assert simulation.finished is None
    assert simulation.tally.moved == 0


def test_a_run_in_which_sand_moves_is_not_still():
    simulation = Simulation(tiny(run__until={"idle_steps": 1}))
    simulation.advance(20)
    assert simulation.steps_done == 20
    assert simulation.finished is None


def test_idle_steps_count_from_the_last_slab_that_moved():
    """All sand blows out of an open field where nothing settles; then nothing can move."""
    blown = {
        "lattice__boundary_x": "open",
        "lattice__boundary_y": "open",
        "model__p_s": 0.0,
        "model__p_ns": 0.0,
        "model__shadow_angle": 89.0,
    }
    simulation = Simulation(tiny(run__until={"idle_steps": 6}, run__steps=1000, **blown))
    moved_at = 0
    while not simulation.done:
        if simulation.advance(1).moved:
            moved_at = simulation.steps_done
    assert simulation.bed.units == 0
    assert simulation.ledger.left == simulation.ledger.initial
    assert simulation.steps_done == moved_at + 6


def test_a_run_that_ended_early_has_a_last_frame_at_its_end():
    simulation = Simulation(tiny(run__until={"idle_steps": 7}, **BARE))
    assert [frame.step for frame in simulation] == [0, 5, 7]


def test_a_run_that_ended_does_no_more_steps():
    simulation = Simulation(tiny(run__until={"idle_steps": 2}, **BARE))
    simulation.advance(5)
    assert simulation.advance(5).steps == 0
    assert simulation.steps_done == 2


def first_steady_step(scenario, looks, tolerance):
    """The step at which the last ``looks`` steps agree, worked out from the surfaces of a whole run."""
    simulation = Simulation(scenario)
    surfaces, measures = [], []
    while True:
        simulation.advance(1)
        surfaces.append(simulation.elevation)
        speed = migration([0, 1], surfaces[-2:]).x if len(surfaces) > 1 else math.nan
        spacing = dominant_spacing(surfaces[-1], 1.0, 270.0)
        measures.append((spacing, crest_orientation(surfaces[-1], 1.0).coherence, speed))
        spacings, straightness, speeds = np.array(measures[-looks:]).T
        spreads = [np.ptp(spacings) / spacings.mean(), np.ptp(straightness), np.ptp(speeds) / speeds.mean()]
        if len(measures) >= looks and np.abs(spreads).max() <= tolerance:
            return simulation.steps_done


@pytest.mark.parametrize("calls", [[200], [7] * 30])
def test_a_run_ends_at_the_first_step_at_which_its_window_is_steady(calls):
    expected = first_steady_step(tiny(**RIDGES), looks=21, tolerance=0.7)
    simulation = Simulation(tiny(run__until={"steady": {"window": 20, "tolerance": 0.7}}, **RIDGES))
    for steps in calls:
        simulation.advance(steps)
    assert simulation.steps_done == expected
    assert simulation.finished.startswith("steady for 20 steps: spacing 24 m, straightness 0.9")


def test_an_impossible_tolerance_never_ends_a_run():
    simulation = Simulation(
        tiny(run__until={"steady": {"window": 20, "tolerance": 1e-12}}, run__steps=60, **RIDGES)
    )
    simulation.advance(60)
    assert simulation.steps_done == 60
    assert simulation.finished is None


def test_whichever_end_comes_first_ends_the_run():
    until = {"idle_steps": 3, "steady": {"window": 20}}
    simulation = Simulation(tiny(run__until=until, **BARE))
    simulation.advance(20)
    assert simulation.finished == "nothing moved for 3 steps"


def test_a_run_that_ended_early_cannot_be_extended():
    simulation = Simulation(tiny(run__until={"idle_steps": 2}, **BARE))
    simulation.advance(20)
    with pytest.raises(BarchanError, match="the run ended at step 2: nothing moved for 2 steps"):
        simulation.extend(40)


@pytest.mark.parametrize("steps", [-1, 0, 11])
def test_a_run_cannot_be_made_shorter_than_it_is(steps):
    simulation = Simulation(tiny())
    simulation.advance(12)
    with pytest.raises(BarchanError, match=f"12 steps are done already; {steps} cannot be the last one"):
        simulation.extend(steps)
    assert simulation.scenario.run.steps == 20


@pytest.mark.parametrize(("cycle", "every"), [(20, 20), (3, 6), (500, 500)])
def test_bedforms_under_winds_in_turn_are_looked_at_after_whole_cycles(cycle, every):
    """A window of 100 steps has a look every 5; dunes swing within a cycle."""
    half = cycle // 2
    winds = [{"direction": 270.0, "steps": half}, {"direction": 90.0, "steps": cycle - half}]
    scenario = tiny(
        wind={"kind": "regimes", "regimes": winds}, run__until={"steady": {"window": 100, "tolerance": 0.1}}
    )
    (condition,) = StopConditions(scenario).values()
    assert condition.every == every
    assert (condition.looks - 1) * condition.every >= 100


def test_a_run_that_its_model_ended_keeps_the_reason_in_its_tally_when_asked_to_go_on():
    """Snow that one day makes immobile: its run ends on day 1, and no later call does a step."""
    simulation = Simulation(tiny(model={"name": "snow_werner", "hardening": {"locks_after": 1}}))
    simulation.advance(3)
    state = simulation.state().data
    assert simulation.advance(2).steps == simulation.advance(0).steps == 0
    assert simulation.state().data == state
    assert state["tally"]["finished"] == "immobile on day 1"
