"""A branch: a run taken up at any of its steps, with its bits, in a folder that names it."""

import shutil

import numpy as np
import pytest

from barchan.archive import Parent, branch, open_run, reopen, resume, run, run_info
from barchan.archive.folder import CHECKPOINT
from barchan.errors import ArchiveError
from barchan.simulation import SetParameter, SetWind, Simulation, Stroke
from barchan.wind import Steady
from tests.tiny import VARIANTS, tiny


def eventful(folder, **changes):
    """A run of 20 steps in which things happen at steps 3 and 8."""
    simulation = Simulation(tiny(**changes))
    simulation.advance(3)
    simulation.apply(SetParameter(key="model.hop_length", value=2.0))
    simulation.apply(Stroke(x=4.0, y=5.0, radius=3.0, amount=5))
    simulation.advance(5)
    simulation.apply(SetWind(wind=Steady(direction=200.0)))
    return run(simulation, folder).path


def frames_from(folder, step):
    with open_run(folder) as dataset:
        return dataset.sel(step=slice(step, None)).load()


@pytest.mark.parametrize("changes", VARIANTS.values(), ids=list(VARIANTS))
def test_a_branch_that_changes_nothing_is_the_run_from_there_on(tmp_path, changes):
    parent = run(Simulation(tiny(**changes)), tmp_path / "parent").path
    for at in (0, 7, 10, 20):
        branch(parent, at).run(tmp_path / f"from-{at}")
        assert frames_from(parent, at).identical(frames_from(tmp_path / f"from-{at}", 0))


@pytest.mark.parametrize("at", [0, 2, 3, 5, 8, 12, 20])
def test_a_branch_of_a_run_in_which_things_happened_has_its_bits(tmp_path, at):
    parent = eventful(tmp_path / "parent")
    taken = branch(parent, at).simulation
    assert taken.steps_done == at
    for record in Simulation.from_state(reopened_state(parent)).events:
        if record.step > at:
            taken.advance(record.step - taken.steps_done)
            taken.apply(record.event)
    taken.advance(20 - taken.steps_done)
    np.testing.assert_array_equal(taken.bed.sand, frames_from(parent, 20)["sand"][0])


def reopened_state(folder):
    going = reopen(folder)
    going.archive.close()
    return going.simulation.state()


def test_a_branch_goes_its_own_way_and_names_where_it_came_from(tmp_path):
    parent = run(Simulation(tiny()), tmp_path / "parent").path
    taken = branch(parent, 10)
    taken.simulation.apply(SetParameter(key="model.hop_length", value=2.0))
    child = taken.run(tmp_path / "child").path
    assert run_info(parent).parent is None
    assert run_info(child).parent == Parent(parent.resolve(), 10)
    assert frames_from(child, 0)["step"].values.tolist() == [10, 15, 20]
    assert (frames_from(child, 20)["sand"].values != frames_from(parent, 20)["sand"].values).any()
    grandchild = branch(child, 15).run(tmp_path / "grandchild").path
    assert run_info(grandchild).parent == Parent(child.resolve(), 15)
    assert frames_from(grandchild, 0).identical(frames_from(child, 15))


def test_runs_that_are_moved_together_still_know_each_other(tmp_path):
    first = tmp_path / "first"
    first.mkdir()
    parent = run(Simulation(tiny()), first / "parent").path
    branch(parent, 10).run(first / "child")
    shutil.move(first, tmp_path / "second")
    assert run_info(tmp_path / "second" / "child").parent.run == tmp_path / "second" / "parent"


def test_a_branch_without_a_step_begins_at_the_newest_checkpoint(tmp_path):
    parent = run(Simulation(tiny()), tmp_path / "parent").path
    taken = branch(parent)
    assert taken.parent.step == taken.simulation.steps_done == 20
    taken.simulation.extend(30)
    taken.run(tmp_path / "child")
    resume(parent, steps=30)
    assert frames_from(parent, 20).identical(frames_from(tmp_path / "child", 0))


def test_a_branch_needs_no_checkpoint(tmp_path):
    parent = run(Simulation(tiny()), tmp_path / "parent").path
    (parent / CHECKPOINT).write_bytes(b"damaged")
    branch(parent, 5).run(tmp_path / "child")
    assert frames_from(parent, 5).identical(frames_from(tmp_path / "child", 0))


@pytest.mark.parametrize("at", [-1, 21])
def test_a_branch_begins_where_the_run_has_been(tmp_path, at):
    parent = run(Simulation(tiny()), tmp_path / "parent").path
    with pytest.raises(ArchiveError, match=f"has done 20 steps; a branch cannot begin at step {at}"):
        branch(parent, at)


def test_a_run_that_its_scenario_does_not_give_has_no_earlier_branches(tmp_path):
    simulation = Simulation(tiny())
    simulation.bed.sand[...] = np.roll(simulation.bed.sand, 1, axis=0)
    parent = run(simulation, tmp_path / "parent").path
    with pytest.raises(ArchiveError, match="step 10 is not that of its frame"):
        branch(parent, 10)
    assert branch(parent, 20).simulation.steps_done == 20


def test_the_way_to_a_branch_can_be_interrupted(tmp_path):
    parent = run(Simulation(tiny()), tmp_path / "parent").path
    with pytest.raises(ArchiveError, match="interrupted at step 0 on the way to step 10"):
        branch(parent, 10, stop=lambda: True)
