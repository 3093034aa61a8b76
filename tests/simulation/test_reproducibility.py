"""Same scenario and seed, same bits: however the run is cut into calls."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.simulation import Simulation
from tests.tiny import VARIANTS, tiny


@pytest.mark.parametrize("changes", VARIANTS.values(), ids=list(VARIANTS))
@settings(max_examples=8)
@given(cuts=st.lists(st.integers(0, 7), max_size=5))
def test_steps_are_the_same_in_one_call_and_in_many(changes, cuts):
    in_one, in_many = Simulation(tiny(**changes)), Simulation(tiny(**changes))
    in_one.advance(sum(cuts))
    for cut in cuts:
        in_many.advance(cut)
    np.testing.assert_array_equal(in_one.bed.sand, in_many.bed.sand)
    assert in_one.tally == in_many.tally
    assert in_one.steps_done == in_many.steps_done == sum(cuts)


def test_tallies_of_calls_add_up_to_that_of_the_run():
    simulation = Simulation(tiny(lattice__boundary_x="open"))
    parts = [simulation.advance(steps) for steps in (3, 1, 9)]
    for name in ("steps", "polls", "moved", "left", "capped", "travel_x", "travel_y"):
        assert getattr(simulation.tally, name) == sum(getattr(part, name) for part in parts)
    assert simulation.tally.left > 0


@pytest.mark.parametrize("changes", VARIANTS.values(), ids=list(VARIANTS))
def test_another_seed_gives_other_bits(changes):
    one, other = Simulation(tiny(run__seed=1, **changes)), Simulation(tiny(run__seed=2, **changes))
    one.advance(3)
    other.advance(3)
    assert (one.bed.sand != other.bed.sand).any()


def test_the_first_sand_depends_on_the_seed_and_not_on_model_wind_or_length():
    first = Simulation(tiny()).bed.sand
    for changes in ({"model__hop_length": 1}, {"wind__direction": 90}, {"run__steps": 1}):
        np.testing.assert_array_equal(first, Simulation(tiny(**changes)).bed.sand)


def test_a_step_polls_as_many_cells_as_the_field_has():
    simulation = Simulation(tiny())
    assert simulation.advance(5).polls == 5 * 16 * 24


def test_no_steps_change_nothing():
    simulation = Simulation(tiny())
    before = simulation.bed.sand.copy()
    tally = simulation.advance(0)
    assert (tally.steps, tally.moved) == (0, 0)
    np.testing.assert_array_equal(simulation.bed.sand, before)


def test_a_scenario_without_a_seed_draws_one_and_keeps_it():
    simulation = Simulation(tiny(run__seed=None))
    again = Simulation(simulation.scenario)
    simulation.advance(5)
    again.advance(5)
    np.testing.assert_array_equal(simulation.bed.sand, again.bed.sand)


@pytest.mark.parametrize("changes", VARIANTS.values(), ids=list(VARIANTS))
def test_sand_is_kept_to_the_slab(changes):
    simulation = Simulation(tiny(**changes))
    before = int(simulation.bed.sand.sum())
    simulation.advance(10)
    assert simulation.bed.sand.min() >= 0
    assert int(simulation.bed.sand.sum()) + simulation.ledger.left == before
    assert (simulation.ledger.left > 0) == ("lattice__boundary_x" in changes)
