"""The files that a scenario names travel with its run, wherever their names came from."""

import json
import shutil

import numpy as np
import pytest

import barchan
from barchan.archive import branch, open_run, reopen, resume, run
from barchan.archive.folder import events_of, scenario_of
from barchan.errors import ArchiveError
from barchan.scenario import load_scenario
from barchan.simulation import SetWind, Simulation
from barchan.wind import Recorded
from tests.tiny import COLUMNS, ROWS, data


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder, the one worked in, with a terrain and a record in it."""
    home = tmp_path / "home"
    (home / "terrain").mkdir(parents=True)
    monkeypatch.chdir(home)
    np.save("terrain/hill.npy", np.linspace(0.0, 3.0, ROWS * COLUMNS).reshape(ROWS, COLUMNS))
    hours = "".join(f"2020-01-0{1 + h // 24} {h % 24:02}:00,{8 + h % 5},270\n" for h in range(72))
    (home / "wind.csv").write_text(f"time,speed (m/s),direction\n{hours}")
    return home


def from_file(folder):
    named = {**data(), "ground": {"kind": "file", "path": "hill.npy"}}
    (folder / "terrain/scenario.json").write_text(json.dumps(named))
    return load_scenario("terrain/scenario.json")


def from_command_line(_):
    return load_scenario(data(), [("ground.kind", "file"), ("ground.path", "terrain/hill.npy")])


def from_python(_):
    return barchan.load(data(), ground={"kind": "file", "path": "terrain/hill.npy"})


WAYS = pytest.mark.parametrize("way", [from_file, from_command_line, from_python])


@WAYS
def test_a_run_is_moved_checked_run_again_resumed_and_branched_without_its_sources(folder, tmp_path, way):
    first = run(Simulation(way(folder)), folder / "run").path
    with open_run(first) as dataset:
        frames = dataset.load()
    moved = tmp_path / "elsewhere" / "run"
    shutil.copytree(first, moved)
    shutil.rmtree(folder / "terrain")
    shutil.rmtree(first)

    again = run(Simulation(scenario_of(moved)), tmp_path / "again").path
    with open_run(again) as dataset:
        assert np.array_equal(dataset["sand"], frames["sand"])
    assert branch(moved, 10).run(tmp_path / "branch").reason == "all steps done"
    assert resume(moved, steps=25).simulation.steps_done == 25
    for one in (moved, again, tmp_path / "branch"):
        assert (one / json.loads((one / "scenario.json").read_text())["ground"]["path"]).is_file()
        assert str(folder) not in (one / "scenario.json").read_text()


def test_a_record_that_an_event_brings_travels_too(folder, tmp_path):
    simulation = Simulation(barchan.load(data(), clock={}))
    simulation.advance(3)
    simulation.apply(SetWind(wind=Recorded(path="wind.csv")))
    first = run(simulation, folder / "run").path
    shutil.move(first, tmp_path / "moved")
    (folder / "wind.csv").unlink()
    assert events_of(tmp_path / "moved")[0]["wind"]["path"].startswith(str(tmp_path / "moved" / "files"))
    assert branch(tmp_path / "moved", 8).run(tmp_path / "branch").reason == "all steps done"
    assert resume(tmp_path / "moved", steps=25).simulation.steps_done == 25


def test_a_file_that_was_changed_since_is_refused(folder):
    first = run(Simulation(from_python(folder)), folder / "run").path
    (kept,) = first.glob("files/*/hill.npy")
    np.save(kept, np.zeros((ROWS, COLUMNS)))
    for attempt in (reopen, branch):
        with pytest.raises(ArchiveError, match="its digest differs"):
            attempt(first)
    kept.unlink()
    with pytest.raises(ArchiveError, match="is missing"):
        resume(first)


def test_what_says_where_a_raster_lies_is_kept_beside_it(folder):
    (folder / "terrain/hill.prj").write_text("LOCAL_CS")
    first = run(Simulation(from_python(folder)), folder / "run").path
    assert [path.name for path in sorted(first.glob("files/*/*"))] == ["hill.npy", "hill.prj"]


def test_a_run_that_is_replaced_leaves_no_files_of_the_old_one(folder):
    first = run(Simulation(from_python(folder)), folder / "run").path
    run(Simulation(barchan.load(data())), first, overwrite=True)
    assert not (first / "files").exists()
