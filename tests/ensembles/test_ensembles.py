"""An ensemble comes to its end, whatever happens to those that work on it."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from concurrent.futures import Executor, Future
from pathlib import Path

import numpy as np
import pytest

import barchan
from barchan.archive import open_run
from barchan.archive.folder import SCENARIO, log_of
from barchan.ensembles import task
from barchan.ensembles.axes import parse_axes
from barchan.ensembles.plan import PLAN, load_plan, make_plan, make_varied_plan, member_id
from barchan.ensembles.reports import State, member_folder, read_failure, read_report, state_of
from barchan.ensembles.running import run_ensemble
from barchan.ensembles.table import measure_table, series_table, short_names
from barchan.ensembles.workers import given, processes
from barchan.errors import ArchiveError, BarchanError, ScenarioError
from tests.tiny import DATA, tiny

ROOT = Path(__file__).parents[2]


class Here(Executor):
    """Works at once, in this process."""

    def submit(self, function, *arguments):
        future = Future()
        try:
            future.set_result(function(*arguments))
        except BaseException as error:
            future.set_exception(error)
        return future


HERE = given(Here(), 1)


def plan_of(*vary, data=DATA, **options):
    return make_plan(data, parse_axes(vary), **options)


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A finished grid of two hop lengths and two amounts of sand, two seeds each."""
    folder = tmp_path_factory.mktemp("grid")
    data = {**DATA, "run": {"steps": 20, "save_every": 10, "seed": 7}}
    plan = plan_of("model.hop_length=1,4", "sand.mean=2,3", data=data, seeds=2)
    outcome = run_ensemble(plan, folder, HERE)
    assert outcome.complete
    return folder, plan


def ends(folder):
    """How often each member's run came to its end."""
    return Counter(
        path.name for path in (folder / "members").iterdir() for e in log_of(path) if e["event"] == "stop"
    )


def test_a_member_is_an_ordinary_run_named_after_its_scenario_without_threads(finished):
    folder, plan = finished
    member = plan.members[0]
    alone = barchan.simulate(tiny(model__hop_length=1, sand__mean=2, run__save_every=10))
    with open_run(member_folder(folder, member.id)) as run:
        assert (run.sand.values == alone.sand.values).all()
    threaded = {**member.scenario, "run": {**member.scenario["run"], "threads": 5}}
    assert member.id == member_id(threaded)
    assert len({m.id for m in plan.members}) == 8


def test_common_seeds_are_the_same_at_every_point_and_independent_ones_nowhere():
    for pairing, distinct in (("common", 3), ("independent", 6)):
        plan = plan_of("model.hop_length=1,4", seeds=3, first_seed=20, pairing=pairing)
        assert {m.seed for m in plan.members} == set(range(20, 20 + distinct))


def test_a_dataset_has_a_dimension_for_each_axis_and_the_frames_of_each_member(finished):
    folder, plan = finished
    ensemble = barchan.open_ensemble(folder)
    assert ensemble.sand.dims == ("hop_length", "mean", "realization", "step", "y", "x")
    for member in plan.members:
        hop, mean = member.values
        found = ensemble.sel(hop_length=hop, mean=mean, realization=member.realization)
        with open_run(member_folder(folder, member.id)) as run:
            assert (found.sand.values == run.sand.values).all()
            assert (found.elevation[-1, 3:5, ::2].values == run.elevation[-1, 3:5, ::2].values).all()
            assert found.elevation.isel(step=1, y=-1, x=2) == run.elevation[1, -1, 2]
        assert str(found.status.values) == "done"
    assert np.isclose(ensemble.elevation.isel(step=-1).mean(), 2.5 / 3, atol=0.02)


def test_tables_have_a_row_for_each_member_and_for_each_frame(finished):
    folder, plan = finished
    table = measure_table(folder)
    assert list(table["member"]) == [m.id for m in plan.members]
    assert (table["state"] == "done").all()
    with open_run(member_folder(folder, plan.members[0].id)) as run:
        assert table["highest_stack"][0] == run.sand[-1].max()
    assert len(series_table(folder)) == 8 * 3


def test_keys_named_like_something_else_keep_their_whole_names():
    axes = parse_axes(["run.steps=1,2", "model.name=werner,momiji", "model.hop_length=1,2"])
    plan = make_plan(DATA, axes)
    assert short_names(plan) == ["run.steps", "model.name", "hop_length"]


def test_a_finished_ensemble_does_nothing_again(finished):
    folder, _ = finished
    before = {path: path.stat().st_mtime_ns for path in (folder / "members").rglob("*") if path.is_file()}
    outcome = run_ensemble(load_plan(folder), folder, HERE)
    assert [ended.ran for ended in outcome.done] == [False] * 8
    assert before == {path: path.stat().st_mtime_ns for path in before}


def test_missing_members_are_gaps_and_more_seeds_keep_what_is_there(tmp_path):
    few = plan_of("model.hop_length=1,4")
    run_ensemble(few, tmp_path, HERE)
    more = plan_of("model.hop_length=1,4", seeds=2)
    more.save(tmp_path)
    ensemble = barchan.open_ensemble(tmp_path)
    assert (ensemble.status.values == [["done", "waiting"]] * 2).all()
    assert (ensemble.sand.isel(realization=1) == -1).all()
    assert ensemble.elevation.isel(realization=1).isnull().all()
    outcome = run_ensemble(more, tmp_path, HERE)
    assert sum(ended.ran for ended in outcome.done) == 2


def test_all_values_out_of_range_are_named_before_anything_starts():
    with pytest.raises(ScenarioError) as error:
        plan_of("model.hop_length=-1,3,0", "sand.mean=3,-4")
    assert "is -1" in str(error.value)
    assert "is 0" in str(error.value)
    assert "is -4" in str(error.value)


def test_keys_that_do_not_exist_are_named_together_with_values_out_of_range():
    with pytest.raises(ScenarioError) as error:
        make_varied_plan(DATA, ["model.hop_length=-1,3", "sand.men=2", "nowhere.key=1", "sand.mean=3,-4"])
    for said in ("nowhere.key", "sand.men", "is -1", "is -4"):
        assert said in str(error.value)


def test_a_scenario_at_fault_is_tried_once_and_stops_nobody(tmp_path):
    missing = json.dumps({"kind": "file", "path": str(tmp_path / "missing.asc")})
    plan = plan_of(f'ground={missing},{{"kind": "flat"}}')
    tried = []
    outcome = run_ensemble(plan, tmp_path / "out", counted(tried))
    bad, good = plan.members
    assert [e.id for e in outcome.done] == [good.id]
    assert [e.id for e in outcome.failed] == [bad.id]
    assert tried.count(bad.id) == 1
    assert "missing.asc" in read_failure(tmp_path / "out", bad.id).message
    assert state_of(tmp_path / "out", bad.id) == State.FAILED


def counted(tried):
    """Works here and notes the members that it was given."""

    class Counted(Here):
        def submit(self, function, *arguments):
            if function is task.bring_to_end:
                tried.append(arguments[1])
            return super().submit(function, *arguments)

    return given(Counted(), 1)


@pytest.mark.parametrize(("failures", "tries", "state"), [(1, 2, "done"), (2, 3, "done"), (9, 3, "failed")])
def test_an_error_of_the_system_is_tried_again_twice(tmp_path, monkeypatch, failures, tries, state):
    plan, tried = plan_of(), []
    whole = task._advance

    def advance(*arguments):
        if len(tried) <= failures:
            raise ArchiveError("cannot write") from OSError(28, "No space left on device")
        return whole(*arguments)

    monkeypatch.setattr(task, "_advance", advance)
    run_ensemble(plan, tmp_path, counted(tried))
    assert len(tried) == tries
    assert state_of(tmp_path, plan.members[0].id) == state
    if state == "failed":
        monkeypatch.undo()
        assert run_ensemble(plan, tmp_path, HERE, only=[State.WAITING]).done == []
        assert len(run_ensemble(plan, tmp_path, HERE, only=[State.FAILED]).done) == 1


def test_a_wish_to_stop_leaves_members_that_go_on_to_the_same_bits(tmp_path):
    plan = plan_of("model.hop_length=1,4")
    ended = []
    outcome = run_ensemble(
        plan, tmp_path, HERE, told=lambda one, *_: ended.append(one), stop=lambda: bool(ended)
    )
    assert outcome.waiting == [plan.members[1].id]
    assert run_ensemble(plan, tmp_path, HERE).complete
    for member in plan.members:
        alone = barchan.simulate(dict(member.scenario))
        with open_run(member_folder(tmp_path, member.id)) as run:
            assert (run.sand.values == alone.sand.values).all()


def test_a_damaged_checkpoint_costs_time_and_no_bits(tmp_path):
    plan = plan_of()
    (member,) = plan.members
    run_ensemble(plan, tmp_path, HERE)
    bed = read_report(tmp_path, member.id).bed
    (tmp_path / "reports" / f"{member.id}.json").unlink()
    run = member_folder(tmp_path, member.id)
    (run / "checkpoint.npz").write_bytes(b"half")
    (run / "log.jsonl").write_text("")
    assert run_ensemble(plan, tmp_path, HERE).complete
    assert read_report(tmp_path, member.id).bed == bed


def test_folders_that_are_no_ensembles_are_refused(tmp_path):
    with pytest.raises(ArchiveError, match=PLAN):
        barchan.open_ensemble(tmp_path)
    (tmp_path / "something").touch()
    with pytest.raises(ArchiveError, match="not empty"):
        run_ensemble(plan_of(), tmp_path, HERE)
    (tmp_path / PLAN).write_text('{"format": 99}')
    with pytest.raises(ArchiveError, match="format 99"):
        load_plan(tmp_path)
    file = tmp_path / "file"
    file.touch()
    with pytest.raises(ArchiveError, match="is a file, not a folder"):
        plan_of().save(file)


LONG = {**DATA, "run": {"steps": 40_000, "save_every": 4_000, "seed": 7}}


def writer_in(folder, timeout=60.0):
    """The process that writes some member, once it has saved a frame."""
    until = time.monotonic() + timeout
    while time.monotonic() < until:
        for run in (folder / "members").glob("*"):
            if (run / SCENARIO).is_file() and len(log_of(run)) > 2:
                lock = run / "writer.lock"
                number = lock.read_text() if lock.is_file() else ""
                if number.isdigit() and state_of(folder, run.name) == State.RUNNING:
                    return int(number)
        time.sleep(0.005)
    raise AssertionError("no member was begun")


@pytest.mark.extended
def test_a_worker_that_is_killed_in_mid_run_loses_nothing(tmp_path):
    plan = plan_of("model.hop_length=1,4", data=LONG)
    killed = []

    def kill():
        killed.append(writer_in(tmp_path))
        os.kill(killed[0], signal.SIGKILL)

    killer = threading.Thread(target=kill)
    killer.start()
    outcome = run_ensemble(plan, tmp_path, processes(2))
    killer.join()
    assert outcome.complete
    assert killed[0] not in (os.getpid(), None)
    assert set(ends(tmp_path).values()) == {1}
    assert any(e["event"] == "resume" for p in (tmp_path / "members").iterdir() for e in log_of(p))
    for member in plan.members:
        alone = barchan.simulate(dict(member.scenario))
        with open_run(member_folder(tmp_path, member.id)) as run:
            assert (run.sand.values == alone.sand.values).all()


def test_a_sweep_that_is_killed_goes_on_with_what_is_missing(tmp_path):
    plan = plan_of("model.hop_length=1,4", data=LONG)
    (tmp_path / "long.json").write_text(json.dumps(LONG))
    out = tmp_path / "out"
    command = [sys.executable, "-c", "from barchan.cli import main; main()", "sweep", "long.json"]
    words = ["--vary", "model.hop_length=1,4", "--workers", "1", "--out", str(out), "--quiet"]
    sweep = subprocess.Popen([*command, *words], cwd=tmp_path, start_new_session=True)
    writer_in(out)
    os.killpg(sweep.pid, signal.SIGKILL)
    sweep.wait()
    while State.RUNNING in {state_of(out, member.id) for member in plan.members}:
        time.sleep(0.01)  # the worker too has been killed, and its lock goes with it
    assert State.DONE not in {state_of(out, member.id) for member in plan.members[1:]}
    assert run_ensemble(load_plan(out), out, HERE).complete
    assert set(ends(out).values()) == {1}
    assert {m.id for m in load_plan(out).members} == {m.id for m in plan.members}


def test_ctrl_c_saves_the_members_and_tells_how_to_go_on(tmp_path):
    (tmp_path / "long.json").write_text(json.dumps({**LONG, "run": {**LONG["run"], "steps": 4_000_000}}))
    out = tmp_path / "out"
    command = [sys.executable, "-c", "from barchan.cli import main; main()", "sweep", "long.json"]
    words = ["--vary", "model.hop_length=1,4", "--workers", "1", "--out", str(out)]
    sweep = subprocess.Popen(
        [*command, *words], cwd=tmp_path, start_new_session=True, stdout=subprocess.PIPE, text=True
    )
    writer_in(out)
    os.killpg(sweep.pid, signal.SIGINT)
    told, _ = sweep.communicate(timeout=60)
    assert sweep.returncode == 130
    assert f"not at their end: 2; go on with: barchan sweep {out}" in told
    states = [state_of(out, member.id) for member in load_plan(out).members]
    assert states == [State.STOPPED, State.WAITING]
    assert not (out / "stop").exists()


@pytest.mark.extended
def test_a_dask_cluster_that_loses_a_worker_brings_each_member_to_its_end_once(tmp_path):
    distributed = pytest.importorskip("distributed")
    from barchan.ensembles.workers import dask_cluster

    plan = plan_of("model.hop_length=1,2,4", data=LONG)
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
    ) as cluster:
        killed = []

        def kill():
            killed.append(writer_in(tmp_path))
            os.kill(killed[0], signal.SIGKILL)

        killer = threading.Thread(target=kill)
        killer.start()
        outcome = run_ensemble(plan, tmp_path, dask_cluster(cluster.scheduler_address))
        killer.join()
    assert outcome.complete
    assert killed
    assert set(ends(tmp_path).values()) == {1}
    assert len(ends(tmp_path)) == 3


def test_a_cluster_that_does_not_answer_is_named(monkeypatch):
    pytest.importorskip("distributed")
    from barchan.ensembles import workers

    monkeypatch.setattr(workers, "PATIENCE", 0.2)
    with pytest.raises(BarchanError, match="no answer"):
        workers.dask_cluster("tcp://127.0.0.1:9")


def test_without_dask_the_advice_names_the_library(monkeypatch):
    from barchan.ensembles import workers

    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(BarchanError, match="pip install distributed"):
        workers.dask_cluster("tcp://127.0.0.1:9")


def test_workers_that_go_away_are_named_and_the_finished_stays(tmp_path):
    class Leaving(Here):
        def submit(self, function, *arguments):
            future = super().submit(function, *arguments)
            if function is task.bring_to_end and arguments[1] == plan.members[1].id:
                future = Future()
                future.cancel()
                future.set_running_or_notify_cancel()
            return future

    plan = plan_of("model.hop_length=1,4")
    with pytest.raises(BarchanError, match="went away"):
        run_ensemble(plan, tmp_path, given(Leaving(), 1))
    assert state_of(tmp_path, plan.members[0].id) == State.DONE
