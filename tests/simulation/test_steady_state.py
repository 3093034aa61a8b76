"""Bedforms are steady when spacing, straightness and speed stay constant over the whole window."""

import json
from types import SimpleNamespace

import numpy as np
import pytest

from barchan.model import Tally
from barchan.scenario import SteadyState
from barchan.simulation import Simulation
from barchan.simulation.steady_state import SteadyBedforms
from tests.measures.waves import COLUMNS, ROWS, random_surface, sine
from tests.tiny import RIDGES, tiny

SCENARIO = tiny(lattice__rows=ROWS, lattice__columns=COLUMNS)


def condition_of(window=20, tolerance=0.05):
    return SteadyBedforms(SteadyState(window=window, tolerance=tolerance), SCENARIO)


def show(condition, surface, direction=270.0):
    """Let a condition look at a surface of sand on level ground."""
    scenario = (
        SCENARIO
        if direction == 270.0
        else tiny(lattice__rows=ROWS, lattice__columns=COLUMNS, wind__direction=direction)
    )
    ground, depth = np.zeros(surface.shape), surface - surface.min() + 1.0
    bed = SimpleNamespace(ground=ground, depth=depth, lattice=scenario.lattice)
    simulation = SimpleNamespace(
        bed=bed, scenario=scenario, forcing=scenario.forcing(), steps_done=1, wind_direction=direction
    )
    return condition.check(simulation, Tally())


def looks_until_steady(condition, surfaces):
    """The number of looks until a condition is met, and the reason it gives."""
    for count, surface in enumerate(surfaces, start=1):
        reason = show(condition, surface)
        if reason:
            return count, reason
    return None, None


def drifting(speeds, height=1.0):
    """Waves that move on by a number of cells from look to look, over random relief that moves with them."""
    place = 0.0
    for speed in speeds:
        place += speed
        column = np.arange(COLUMNS)
        yield np.tile(height * np.cos(2 * np.pi * 5 * (column - place) / COLUMNS), (ROWS, 1))


def test_waves_that_move_on_evenly_are_steady_after_a_window():
    count, reason = looks_until_steady(condition_of(), drifting([1.5] * 40))
    assert count == 22
    assert reason == "steady for 20 steps: spacing 16 m, straightness 1.00, speed 1.5 cells per step"


def test_waves_that_move_ever_faster_are_not_steady():
    speeds = np.linspace(0.5, 4.5, 60)
    assert looks_until_steady(condition_of(), drifting(speeds)) == (None, None)


def test_waves_whose_speed_stays_within_the_tolerance_are_steady():
    speeds = [1.5 * (1 + 0.02 * (-1) ** k) for k in range(40)]
    assert looks_until_steady(condition_of(tolerance=0.05), drifting(speeds))[0] == 22
    assert looks_until_steady(condition_of(tolerance=0.03), drifting(speeds)) == (None, None)


def test_one_disturbance_is_waited_for_to_leave_the_window():
    speeds = [1.5] * 10 + [2.5] + [1.5] * 40
    count, _ = looks_until_steady(condition_of(), drifting(speeds))
    assert count == 11 + 21


def test_waves_whose_spacing_changes_are_not_steady():
    surfaces = [np.roll(sine(3 + k // 5, 0), k, axis=1) for k in range(60)]
    assert looks_until_steady(condition_of(), surfaces) == (None, None)


def test_crests_that_lose_their_straightness_are_not_steady():
    surfaces = [np.roll(sine(5, 0) + 0.04 * k * sine(0, 3), k, axis=1) for k in range(40)]
    assert looks_until_steady(condition_of(tolerance=0.2), surfaces) == (None, None)


def test_a_flat_bed_is_never_steady():
    assert looks_until_steady(condition_of(), [np.zeros((ROWS, COLUMNS))] * 50) == (None, None)


@pytest.mark.parametrize("surface", [sine(5, 0), random_surface(1)], ids=["waves", "hills"])
def test_bedforms_that_stand_still_are_steady(surface):
    count, reason = looks_until_steady(condition_of(), [surface] * 40)
    assert count == 22
    assert "speed 0 cells per step" in reason


@pytest.mark.parametrize("window", [10, 20, 30, 39, 40, 50, 500, 510])
def test_a_window_is_looked_at_from_end_to_end(window):
    """The first look has no speed yet, so the window begins at the second."""
    condition = condition_of(window=window)
    count, reason = looks_until_steady(condition, drifting([1.5] * 60))
    looked = (count - 2) * condition.every
    assert window <= looked < window + condition.every
    assert reason.startswith(f"steady for {looked} steps")


def test_speed_is_per_step_not_per_look():
    _, reason = looks_until_steady(condition_of(window=100), drifting([1.5] * 40))
    assert reason.endswith("speed 0.3 cells per step")


@pytest.mark.parametrize("looks", [0, 1, 5, 21])
def test_a_watch_goes_on_from_what_it_had_seen(looks):
    surfaces = list(drifting([1.5] * 40))
    first = condition_of()
    assert looks_until_steady(first, surfaces[:looks]) == (None, None)
    seen = first.state()
    again = condition_of()
    again.restore({**json.loads(json.dumps({"seen": seen["seen"]})), "previous": seen["previous"]})
    assert looks_until_steady(again, surfaces[looks:])[0] == 22 - looks


def test_a_simulation_is_watched_by_the_entry_point_of_that_name():
    simulation = Simulation(tiny(run__until={"steady": {"window": 60}}, **RIDGES))
    condition = simulation.stop_conditions["steady"]
    assert isinstance(condition, SteadyBedforms)
    assert condition.every == 3
    simulation.advance(10)
    assert len(condition.seen) == 3
