"""How many threads are used: the environment's number, the scenario's, or one for each core."""

import pytest
from numba import config

import barchan
from barchan.errors import BarchanError, ScenarioError
from barchan.kernels.core.threads import VARIABLE, asked_for, state_threads, thread_count


@pytest.fixture(autouse=True)
def nothing_stated(monkeypatch):
    monkeypatch.delenv(VARIABLE, raising=False)


def test_all_cores_without_a_number():
    assert thread_count() == config.NUMBA_NUM_THREADS


def test_a_scenario_states_its_threads_and_the_environment_comes_before_it(monkeypatch):
    with asked_for(3):
        assert thread_count() == 3
        with asked_for(None):
            assert thread_count() == 3
        monkeypatch.setenv(VARIABLE, "5")
        assert thread_count() == 5
    monkeypatch.delenv(VARIABLE)
    assert thread_count() == config.NUMBA_NUM_THREADS


def test_the_command_line_comes_before_the_environment(monkeypatch):
    monkeypatch.setenv(VARIABLE, "5")
    state_threads(None)
    assert thread_count() == 5
    state_threads(2)
    assert thread_count() == 2


@pytest.mark.parametrize("value", ["0", "-1", "two", "1.5", "1025", "٣"])
def test_a_number_that_is_none_is_refused_with_the_variable(monkeypatch, value):
    monkeypatch.setenv(VARIABLE, value)
    with pytest.raises(BarchanError, match=f"{VARIABLE} is .*whole number from 1 to 1024"):
        thread_count()


def test_a_simulation_uses_the_threads_of_its_scenario(monkeypatch):
    seen = []
    scenario = barchan.load("barchans", lattice__rows=8, lattice__columns=8, run__threads=7, run__seed=1)
    simulation = barchan.Simulation(scenario)
    advance = simulation.model.advance

    def watched(*arguments):
        seen.append(thread_count())
        return advance(*arguments)

    monkeypatch.setattr(simulation.model, "advance", watched)
    simulation.advance(2)
    assert set(seen) == {7}


@pytest.mark.parametrize("threads", [0, 1025, "many"])
def test_threads_of_a_scenario_have_bounds(threads):
    with pytest.raises(ScenarioError, match=r"run\.threads"):
        barchan.load("barchans", run__threads=threads)
