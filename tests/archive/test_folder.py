"""The folder of a run: who may write to it, and what is never destroyed."""

import json
import os
import shutil
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest

from barchan.archive import Archive, open_run, resume, run, run_info
from barchan.archive.folder import log_of
from barchan.entry import load
from barchan.errors import ArchiveError
from barchan.simulation import Simulation, Stroke
from tests.tiny import tiny


def names_in(folder):
    return {path.name for path in folder.iterdir()}


def test_a_run_is_a_folder_of_these_files(fresh):
    assert names_in(fresh) == {"scenario.json", "frames.zarr", "checkpoint.npz", "events.jsonl", "log.jsonl"}


def test_the_scenario_in_the_folder_is_complete_and_has_the_seed_that_was_drawn(tmp_path):
    simulation = Simulation(tiny(run__seed=None))
    run(simulation, tmp_path / "run")
    assert load(tmp_path / "run") == simulation.scenario
    assert load(tmp_path / "run").run.seed is not None


def test_the_log_tells_of_start_frames_and_end(fresh):
    entries = log_of(fresh)
    assert [entry["event"] for entry in entries] == ["start", *["frame"] * 5, "stop"]
    assert entries[0]["seed"] == 7
    assert [entry["step"] for entry in entries[1:]] == [0, 5, 10, 15, 20, 20]
    assert entries[-1]["reason"] == "all steps done"


def test_folders_on_the_way_are_made(tmp_path):
    run(Simulation(tiny()), tmp_path / "a" / "b" / "run")
    assert run_info(tmp_path / "a" / "b" / "run").frames == 5


def test_an_empty_folder_may_be_used(tmp_path):
    run(Simulation(tiny()), tmp_path)
    assert run_info(tmp_path).frames == 5


def test_a_folder_that_is_not_empty_is_refused_and_left_alone(tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(ArchiveError, match="is not empty; choose another folder, or add overwrite=True"):
        run(Simulation(tiny()), tmp_path)
    assert names_in(tmp_path) == {"letter.txt"}


def test_a_run_is_not_overwritten_unless_asked(fresh, whole, same_frames):
    with pytest.raises(ArchiveError, match="is not empty"):
        run(Simulation(tiny(run__seed=8)), fresh)
    same_frames(whole, fresh)


def test_a_run_is_replaced_when_asked_and_what_is_not_its_own_stays(tmp_path, fresh, same_frames):
    (fresh / "letter.txt").write_text("dear")
    (fresh / "pictures").mkdir()
    (fresh / "pictures" / "dune.png").write_bytes(b"png")
    run(Simulation(tiny(run__seed=8)), fresh, overwrite=True)
    run(Simulation(tiny(run__seed=8)), tmp_path / "other")
    same_frames(tmp_path / "other", fresh)
    assert len(log_of(fresh)) == 7
    assert (fresh / "letter.txt").read_text() == "dear"
    assert (fresh / "pictures" / "dune.png").read_bytes() == b"png"


def test_a_folder_that_holds_no_run_is_not_overwritten_even_when_asked(tmp_path):
    (tmp_path / "frames.zarr").mkdir()
    (tmp_path / "frames.zarr" / "precious").write_text("data")
    with pytest.raises(ArchiveError, match="holds no run; it is not overwritten"):
        run(Simulation(tiny()), tmp_path, overwrite=True)
    assert (tmp_path / "frames.zarr" / "precious").read_text() == "data"


@pytest.mark.parametrize("left", ["writer.lock", "scenario.json.partial"])
def test_what_a_run_killed_at_its_very_start_leaves_can_be_overwritten(tmp_path, left):
    (tmp_path / left).write_text("")
    run(Simulation(tiny()), tmp_path, overwrite=True)
    assert run_info(tmp_path).frames == 5


@pytest.mark.parametrize("left", ["scenario.json.partial", "events.jsonl.partial", "checkpoint.partial"])
def test_overwriting_leaves_no_unfinished_file_of_the_run_before(fresh, left):
    (fresh / left).write_text("half a sen")
    run(Simulation(tiny(sand={"kind": "flat", "mean": 0})), fresh, overwrite=True)
    run(Simulation(tiny()), fresh.parent / "other")
    assert names_in(fresh) == names_in(fresh.parent / "other")


@pytest.mark.parametrize(
    ("below", "said"),
    [
        ("file", "{} is a file, not a folder"),
        ("file/run", "cannot write to {}: "),
        ("file/a/b", "cannot write to {}: "),
    ],
)
def test_a_place_that_is_no_folder_is_a_clear_error(tmp_path, below, said):
    (tmp_path / "file").write_text("not a folder")
    with pytest.raises(ArchiveError, match=said.format(tmp_path / below)):
        run(Simulation(tiny()), tmp_path / below)
    assert (tmp_path / "file").read_text() == "not a folder"


def test_a_folder_that_is_being_written_is_refused_with_the_writers_number(tmp_path):
    archive = Archive.create(tmp_path / "run", Simulation(tiny()))
    for attempt in (
        lambda: resume(tmp_path / "run"),
        lambda: run(Simulation(tiny()), tmp_path / "run", overwrite=True),
    ):
        with pytest.raises(ArchiveError, match=f"is being written by process {os.getpid()}"):
            attempt()
    archive.close()
    assert resume(tmp_path / "run").reason == "all steps done"


def test_another_process_is_refused_while_a_run_is_written(tmp_path):
    archive = Archive.create(tmp_path / "run", Simulation(tiny()))
    code = f"import barchan; barchan.resume({str(tmp_path / 'run')!r})"
    other = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True)
    archive.close()
    assert other.returncode == 1
    assert f"is being written by process {os.getpid()}" in other.stderr


def test_a_lock_that_a_killed_writer_left_hinders_nobody(fresh):
    (fresh / "writer.lock").write_text("12345")
    assert resume(fresh, steps=25).simulation.steps_done == 25


def test_a_writer_that_fails_lets_go_of_the_folder(tmp_path):
    def fail(_simulation):
        raise RuntimeError("on purpose")

    with pytest.raises(RuntimeError, match="on purpose"):
        run(Simulation(tiny()), tmp_path / "run", progress=fail)
    assert not (tmp_path / "run" / "writer.lock").exists()
    assert resume(tmp_path / "run").reason == "all steps done"


def test_two_processes_never_write_one_folder_even_when_the_first_just_leaves(monkeypatch, fresh):
    leaving = Archive(fresh)
    arrived = []
    unlink = Path.unlink

    def arrive_in_between(path, **given):
        monkeypatch.setattr(Path, "unlink", unlink)
        try:
            arrived.append(Archive(fresh))
        except ArchiveError:
            arrived.append(None)
        unlink(path, **given)

    monkeypatch.setattr(Path, "unlink", arrive_in_between)
    leaving.close()
    both = None
    if arrived[0] is not None:
        with suppress(ArchiveError):
            both = Archive(fresh)
        arrived[0].close()
    if both is not None:
        both.close()
    assert both is None


@pytest.mark.parametrize("cut", [1, 5, 30])
def test_a_log_line_that_was_cut_short_is_passed_over(fresh, cut):
    log = fresh / "log.jsonl"
    log.write_text(log.read_text()[:-cut])
    entries = log_of(fresh)
    assert len(entries) == (6 if cut > 1 else 7)
    resume(fresh, steps=25)
    again = [entry["event"] for entry in log_of(fresh)]
    assert again[: len(entries)] == [entry["event"] for entry in entries]
    assert again[len(entries) :] == ["resume", "frame", "stop"]


def test_a_run_that_ends_tells_why_and_one_that_goes_on_tells_nothing(fresh):
    assert run_info(fresh).stopped == "all steps done"
    archive = Archive(fresh)
    archive.log("resume", step=20)
    archive.close()
    assert run_info(fresh).stopped is None


def test_events_are_a_line_each(tmp_path):
    simulation = Simulation(tiny())
    simulation.apply(Stroke(x=1.0, y=2.0, radius=3.0, amount=4))
    run(simulation, tmp_path / "run")
    (line,) = (tmp_path / "run" / "events.jsonl").read_text().splitlines()
    assert json.loads(line) == {
        "step": 0,
        "kind": "stroke",
        "x": 1.0,
        "y": 2.0,
        "radius": 3.0,
        "amount": 4,
        "falloff": "smooth",
    }


@pytest.mark.parametrize("missing", ["log.jsonl", "events.jsonl"])
def test_a_run_without_its_log_or_events_can_still_be_read_and_resumed(fresh, missing):
    (fresh / missing).unlink()
    assert run_info(fresh).frames == 5
    resume(fresh, steps=25)
    with open_run(fresh) as dataset:
        assert dataset.sizes["step"] == 6


@pytest.mark.parametrize("missing", ["frames.zarr", "checkpoint.npz"])
def test_a_run_without_frames_or_checkpoint_begins_anew(fresh, whole, same_frames, missing):
    shutil.rmtree(fresh / missing) if missing == "frames.zarr" else (fresh / missing).unlink()
    resume(fresh)
    same_frames(whole, fresh)


def test_a_run_killed_while_its_store_of_frames_was_made_begins_anew(fresh, whole, same_frames):
    (fresh / "checkpoint.npz").unlink()
    (fresh / "frames.zarr" / "zarr.json").unlink()
    resume(fresh)
    same_frames(whole, fresh)
