import numpy as np
import pytest

import barchan
from barchan.archive import open_run, resume
from barchan.errors import ConservationError
from barchan.simulation import SetParameter, Simulation, State
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.measuring import Job
from barchan.studio.worker.run import started, states_of
from barchan.studio.worker.saved_runs import open_saved_run, save_run
from tests.grains.test_sizes import SMALL, TWO
from tests.studio.worker.test_run import run_to


def test_a_saved_run_resumes_on_the_command_line_with_the_same_bits(scenario, tmp_path):
    run = started(scenario)
    run_to(run, 25)
    run.live.apply(SetParameter(key="model.p_s", value=0.9))
    run_to(run, 33)
    assert save_run(states_of(run), tmp_path / "mine") == 5
    outcome = resume(tmp_path / "mine")
    alone = Simulation(scenario)
    alone.advance(25)
    alone.apply(SetParameter(key="model.p_s", value=0.9))
    alone.advance(75)
    assert np.array_equal(outcome.simulation.bed.sand, alone.bed.sand)


def test_the_frames_of_a_saved_run_are_the_states_that_were_kept(scenario, tmp_path):
    run = started(scenario)
    run_to(run, 30)
    save_run(states_of(run), tmp_path / "mine")
    with open_run(tmp_path / "mine") as dataset:
        assert list(dataset["step"].values) == [0, 10, 20, 30]
        for at, state in enumerate(run.history.states):
            assert np.array_equal(dataset["sand"][at].values, state.arrays["bed/sand"])


def test_an_opened_run_can_be_looked_at_and_goes_on_from_its_newest_state(scenario, tmp_path):
    run = started(scenario)
    run_to(run, 30)
    save_run(states_of(run), tmp_path / "mine")
    again = open_saved_run(tmp_path / "mine")
    assert again.live.steps_done == 30
    again.look(10)
    assert np.array_equal(again.shown.bed.sand, run.history.at(10).arrays["bed/sand"])
    again.look_now()
    run_to(again, 50)
    run_to(run, 50)
    assert np.array_equal(again.live.bed.sand, run.live.bed.sand)


@pytest.mark.extended
def test_a_saved_run_of_several_sizes_is_opened_looked_at_measured_and_saved_again(tmp_path):
    """Its frames hold the sizes of the active layer alone, which do not add up to all sand of a cell."""
    sizes = {**SMALL, "model": {**SMALL["model"], "sizes": {"classes": TWO}}}
    run = started(barchan.load(sizes, run__save_every=10))
    run_to(run, 20)
    save_run(states_of(run), tmp_path / "mine")
    again = open_saved_run(tmp_path / "mine")
    again.look(10)
    for name in ("sand", "surface_1", "surface_2"):
        assert np.array_equal(again.shown.bed.arrays[name], run.history.at(10).arrays[f"bed/{name}"])
    assert not again.can_branch
    assert [row["step"] for row in again.measures.unsent()["measures"] if row["values"]] == [0, 10, 20]
    save_run(states_of(again), tmp_path / "once-more")
    with open_run(tmp_path / "once-more") as dataset:
        assert list(dataset["step"].values) == [0, 10, 20]


def test_a_state_that_cannot_be_measured_says_why_and_ends_nothing(scenario):
    state = Simulation(scenario).state()
    lost = State(state.data, {**state.arrays, "bed/sand": state.arrays["bed/sand"] + np.int32(1)})
    with pytest.raises(ConservationError):
        Simulation.from_state(lost)
    rows = []
    Desk(None).submit(Job(0, lost, (), extra=False), rows.append)
    assert "does not close" in rows[0]["failed"]
