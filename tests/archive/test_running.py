"""A run on disk, resumed: the same bits as if it had never stopped."""

import json

import pytest

import barchan
from barchan.archive import open_run, reopen, resume, run, run_info
from barchan.entry import load
from barchan.errors import ArchiveError, BarchanError, ScenarioError
from barchan.simulation import SetParameter, SetWind, Simulation, Stroke
from barchan.wind import Steady
from tests.tiny import RIDGES, VARIANTS, tiny

JOURNAL = {
    3: [SetParameter(key="model.hop_length", value=2.0), Stroke(x=4.0, y=5.0, radius=3.0, amount=5)],
    8: [SetWind(wind=Steady(direction=200.0))],
    10: [Stroke(x=20.0, y=5.0, radius=3.0, amount=-5)],
}


class After:
    """Asks for a stop after a number of looks."""

    def __init__(self, looks):
        self.looks = looks

    def __call__(self):
        self.looks -= 1
        return self.looks < 0


def one_step_at_a_time(monkeypatch):
    """Look at whether to stop after every step."""
    monkeypatch.setattr("barchan.archive.running.CHUNK_SECONDS", 0.0)


@pytest.mark.parametrize("changes", VARIANTS.values(), ids=list(VARIANTS))
def test_a_run_that_was_interrupted_again_and_again_equals_one_that_was_not(
    monkeypatch, tmp_path, same_frames, changes
):
    one_step_at_a_time(monkeypatch)
    scenario = tiny(**changes)
    run(Simulation(scenario), tmp_path / "whole")
    outcome = run(Simulation(scenario), tmp_path / "parts", stop=After(3))
    stops = [outcome.simulation.steps_done]
    while outcome.interrupted:
        outcome = resume(tmp_path / "parts", stop=After(4))
        stops.append(outcome.simulation.steps_done)
    assert stops == [3, 7, 11, 15, 19, 20]
    same_frames(tmp_path / "whole", tmp_path / "parts")


@pytest.mark.parametrize("looks", range(22))
def test_a_run_may_be_interrupted_at_any_step(monkeypatch, tmp_path, whole, same_frames, looks):
    one_step_at_a_time(monkeypatch)
    outcome = run(Simulation(tiny()), tmp_path / "run", stop=After(looks))
    assert outcome.interrupted == (looks < 20)
    assert outcome.simulation.steps_done == min(looks, 20)
    again = resume(tmp_path / "run")
    assert (again.interrupted, again.reason) == (False, "all steps done")
    same_frames(whole, tmp_path / "run")


@pytest.mark.parametrize("looks", [2, 3, 5, 8, 9, 10, 12])
def test_a_run_with_events_goes_on_under_them(monkeypatch, tmp_path, same_frames, looks):
    one_step_at_a_time(monkeypatch)

    def happen(simulation):
        for event in JOURNAL.get(simulation.steps_done, []):
            simulation.apply(event)

    run(Simulation(tiny()), tmp_path / "whole", progress=happen)
    run(Simulation(tiny()), tmp_path / "parts", progress=happen, stop=After(looks))
    outcome = resume(tmp_path / "parts", progress=happen)
    same_frames(tmp_path / "whole", tmp_path / "parts")
    assert [record.step for record in outcome.simulation.events] == [3, 3, 8, 10]
    lines = [(tmp_path / folder / "events.jsonl").read_text() for folder in ("whole", "parts")]
    assert lines[0] == lines[1]
    assert len(lines[0].splitlines()) == 4


@pytest.mark.parametrize("looks", [1, 10, 28])
def test_a_run_that_is_watched_ends_where_it_would_have_ended(monkeypatch, tmp_path, same_frames, looks):
    one_step_at_a_time(monkeypatch)
    scenario = tiny(run__until={"steady": {"window": 20, "tolerance": 0.7}}, run__steps=100, **RIDGES)
    expected = run(Simulation(scenario), tmp_path / "whole")
    run(Simulation(scenario), tmp_path / "parts", stop=After(looks))
    outcome = resume(tmp_path / "parts")
    assert outcome.reason == expected.reason
    assert outcome.reason.startswith("steady for 20 steps")
    same_frames(tmp_path / "whole", tmp_path / "parts")


def test_the_reason_of_an_early_end_is_kept(tmp_path):
    bare = tiny(sand={"kind": "flat", "mean": 0}, run__until={"idle_steps": 7})
    outcome = run(Simulation(bare), tmp_path / "run")
    assert outcome.reason == "nothing moved for 7 steps"
    assert run_info(tmp_path / "run").stopped == "nothing moved for 7 steps"
    with open_run(tmp_path / "run") as dataset:
        assert dataset["step"].values.tolist() == [0, 5, 7]


def test_resuming_a_run_that_is_over_changes_no_frame(fresh, whole, same_frames):
    outcome = resume(fresh)
    assert outcome.reason == "all steps done"
    same_frames(whole, fresh)


def test_a_run_goes_on_beyond_its_end_like_one_that_was_longer_from_the_start(tmp_path, fresh):
    resume(fresh, steps=35)
    run(Simulation(tiny(run__steps=35)), tmp_path / "long")
    with open_run(fresh) as extended, open_run(tmp_path / "long") as long:
        assert extended["step"].values.tolist() == [0, 5, 10, 15, 20, 25, 30, 35]
        assert extended.equals(long)
    assert run_info(fresh).scenario.run.steps == 35


@pytest.mark.parametrize("steps", [-5, 0, 7, 19])
def test_a_run_cannot_be_made_shorter_than_it_is(fresh, steps):
    before = (fresh / "scenario.json").read_text()
    with pytest.raises(BarchanError, match=f"20 steps are done already; {steps} cannot be the last one"):
        resume(fresh, steps=steps)
    assert (fresh / "scenario.json").read_text() == before
    assert not (fresh / "writer.lock").exists()


def test_a_run_cannot_be_made_longer_than_a_scenario_may_be(fresh):
    with pytest.raises(ScenarioError, match=r"run\.steps: is 10000000000000; allowed"):
        resume(fresh, steps=10**13)
    assert resume(fresh).simulation.steps_done == 20


def test_a_run_that_ended_early_cannot_be_made_longer(tmp_path):
    bare = tiny(sand={"kind": "flat", "mean": 0}, run__until={"idle_steps": 7})
    run(Simulation(bare), tmp_path / "run")
    with pytest.raises(BarchanError, match="the run ended at step 7: nothing moved for 7 steps"):
        resume(tmp_path / "run", steps=40)


def test_going_on_with_another_version_of_the_program_is_remarked_on(monkeypatch, fresh):
    same = reopen(fresh)
    assert same.remark == ""
    same.archive.close()
    monkeypatch.setattr("barchan.archive.running._version", lambda: "99.0")
    other = reopen(fresh)
    other.archive.close()
    assert other.remark == f"begun with Barchan {barchan.__version__}, now 99.0: the bits may differ"


def test_the_frames_of_a_longer_run_tell_of_the_longer_scenario(fresh):
    resume(fresh, steps=35)
    with open_run(fresh) as dataset:
        assert load(json.loads(dataset.attrs["scenario"])).run.steps == 35


def test_a_longer_total_holds_even_if_the_program_is_killed_before_the_next_checkpoint(fresh):
    reopen(fresh, steps=35).archive.close()
    assert resume(fresh).simulation.steps_done == 35


def test_progress_is_told_of_every_piece_of_work(tmp_path):
    seen = []
    run(Simulation(tiny()), tmp_path / "run", progress=lambda simulation: seen.append(simulation.steps_done))
    assert seen == sorted(set(seen))
    assert {5, 10, 15, 20} <= set(seen)


def test_an_outcome_tells_where_and_how_the_run_ended(tmp_path):
    outcome = run(Simulation(tiny()), tmp_path / "run")
    assert outcome.path == tmp_path / "run"
    assert outcome.simulation.steps_done == 20
    assert outcome.work_per_second > 0


def test_there_is_nothing_to_resume_where_there_is_no_run(tmp_path):
    with pytest.raises(ArchiveError, match="not a run"):
        resume(tmp_path)


def test_a_run_without_steps_is_one_frame(tmp_path):
    run(Simulation(tiny(run__steps=0)), tmp_path / "run")
    with open_run(tmp_path / "run") as dataset:
        assert dataset["step"].values.tolist() == [0]
