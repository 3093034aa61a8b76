"""What studios leave on disk: whole states of studios that have ended, and nothing else, is offered."""

import shutil
from pathlib import Path

import pytest

from barchan.errors import BarchanError
from barchan.studio.server import unfinished
from barchan.studio.server.autosave_folder import ASIDE, AutosaveFolder
from barchan.studio.server.unfinished import Unfinished
from barchan.studio.server.user_data import data_folder


def member(step: int) -> dict:
    return {"title": "Two winds", "model": "werner1995", "step": step, "steps": 100}


def write(folder: AutosaveFolder, **steps: int | None) -> bool:
    """Keep runs at these steps, None for one that is as it was."""
    partial = folder.next()
    for run, step in steps.items():
        if step is not None:
            (partial / run).mkdir()
            (partial / run / "checkpoint.npz").write_text(f"{run} at {step}")
    return folder.commit(
        partial, {run: None if step is None else member(step) for run, step in steps.items()}
    )


def ended(home: Path, name: str, step: int) -> Path:
    """The folder of a studio that ended at a step."""
    folder = AutosaveFolder(home)
    folder.path = home / name
    assert write(folder, a=step)
    folder.close()
    return folder.path


def steps_in(home: Path) -> dict[str, list[int]]:
    runs = Unfinished(home).look().runs
    return {name: [run.step for run in found.members] for name, found in runs.items()}


def test_the_newest_state_of_a_studio_that_ended_is_offered_and_takes_no_more_room_than_one(tmp_path):
    folder = AutosaveFolder(tmp_path)
    for step in (10, 20, 30):
        assert write(folder, a=step)
    folder.close()
    assert steps_in(tmp_path) == {folder.path.name: [30]}
    assert len([path for path in folder.path.iterdir() if path.is_dir()]) == 1


def test_a_studio_that_runs_is_left_alone(tmp_path):
    folder = AutosaveFolder(tmp_path)
    write(folder, a=10)
    assert steps_in(tmp_path) == {}
    with pytest.raises(BarchanError, match="is open in another studio, process"):
        Unfinished(tmp_path).open(folder.path.name)
    assert folder.path.is_dir()
    folder.close()


def test_one_studio_takes_what_another_has_left_and_no_second_one_does(tmp_path):
    name = ended(tmp_path, "20260101-000000-1", 10).name
    adopted = Unfinished(tmp_path).open(name)
    assert [path.name for path in adopted.runs.folders] == ["a"]
    assert steps_in(tmp_path) == {}
    with pytest.raises(BarchanError, match="another studio"):
        Unfinished(tmp_path).discard(name)
    adopted.release()
    assert steps_in(tmp_path) == {name: [10]}
    Unfinished(tmp_path).discard(name)
    assert not (tmp_path / name).exists()


def test_what_was_half_written_is_not_offered_and_the_state_before_it_is(tmp_path):
    folder = AutosaveFolder(tmp_path)
    write(folder, a=10)
    partial = folder.next()
    (partial / "a").mkdir()
    folder.close()
    assert steps_in(tmp_path) == {folder.path.name: [10]}


def test_a_studio_that_ended_before_it_kept_anything_leaves_nothing(tmp_path):
    folder = AutosaveFolder(tmp_path)
    folder.next()
    folder.close()
    assert steps_in(tmp_path) == {}
    assert not folder.path.exists()


def test_what_the_user_has_ended_is_not_offered_even_where_it_could_not_be_deleted(tmp_path, monkeypatch):
    folder = AutosaveFolder(tmp_path)
    write(folder, a=10)

    def interrupted(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr(shutil, "rmtree", interrupted)
    with pytest.raises(KeyboardInterrupt):
        folder.discard()
    folder.close()
    monkeypatch.undo()
    assert folder.path.is_dir()
    assert steps_in(tmp_path) == {}
    assert list(tmp_path.iterdir()) == []


def test_a_state_that_comes_after_the_user_has_ended_the_studio_is_not_kept(tmp_path):
    folder = AutosaveFolder(tmp_path)
    write(folder, a=10)
    folder.forsake()
    assert not write(folder, a=20)
    folder.close()
    assert steps_in(tmp_path) == {}


def test_a_folder_that_is_emptied_offers_nothing_until_another_state_comes(tmp_path):
    """As that of the run that is set aside, which is gone back to."""
    folder = AutosaveFolder(tmp_path, ASIDE)
    write(folder, a=10)
    folder.empty()
    assert [path.name for path in folder.path.iterdir()] == ["writer.lock"]
    assert write(folder, a=20)
    folder.close()
    assert steps_in(tmp_path) == {folder.path.name: [20]}


def test_the_run_that_was_set_aside_is_offered_after_the_one_in_its_place(tmp_path):
    names = ["20260101-000000-1", f"20260102-000000-1{ASIDE}", "20260102-000000-1"]
    for step, name in enumerate(names, start=1):
        ended(tmp_path, name, step)
    assert list(steps_in(tmp_path)) == [names[2], names[1], names[0]]


def test_a_damaged_state_is_named_left_where_it_is_and_never_opened(tmp_path):
    path = ended(tmp_path, "20260101-000000-1", 10)
    whole = ended(tmp_path, "20260102-000000-1", 20).name
    (path / "000001" / "a" / "checkpoint.npz").write_text("a at 1")
    found = Unfinished(tmp_path).look()
    assert list(found.runs) == [whole]
    assert len(found.broken) == 1
    assert str(path / "000001" / "a" / "checkpoint.npz") in found.broken[0]
    with pytest.raises(BarchanError, match="damaged"):
        Unfinished(tmp_path).open(path.name)
    assert path.is_dir()


def test_two_runs_that_are_not_at_one_step_are_not_kept_in_place_of_two_that_are(tmp_path):
    folder = AutosaveFolder(tmp_path)
    assert write(folder, a=10, b=10)
    assert not write(folder, a=30, b=20)
    folder.close()
    assert steps_in(tmp_path) == {folder.path.name: [10, 10]}


def test_a_run_that_is_as_it_was_is_kept_beside_one_that_was_changed(tmp_path):
    folder = AutosaveFolder(tmp_path)
    write(folder, a=10, b=10)
    assert write(folder, a=None, b=10)
    folder.close()
    runs = Unfinished(tmp_path).look().runs[folder.path.name]
    assert [(path / "checkpoint.npz").read_text() for path in runs.folders] == ["a at 10", "b at 10"]


def write_with(folder: AutosaveFolder, step: int, *names: str, run: str = "a") -> None:
    """Keep a run that needs these files beside its newest state, as its worker writes them."""
    folder.states.mkdir(parents=True, exist_ok=True)
    for name in names:
        (folder.states / name).write_text(name)
    partial = folder.next()
    (partial / run).mkdir()
    assert folder.commit(partial, {run: member(step)}, {run: names})


def in_states(folder: AutosaveFolder) -> list[str]:
    return sorted(path.name for path in folder.states.iterdir())


def test_files_that_the_newest_state_needs_stay_and_all_others_are_deleted(tmp_path):
    folder = AutosaveFolder(tmp_path)
    write_with(folder, 10, "first", "second")
    (folder.states / "half.partial").write_text("")
    write_with(folder, 20, "second", "third")
    assert in_states(folder) == ["second", "third"]
    folder.close()
    assert steps_in(tmp_path) == {folder.path.name: [20]}


def test_files_of_a_run_that_is_as_it_was_stay_and_those_of_a_run_that_has_ended_go(tmp_path):
    folder = AutosaveFolder(tmp_path)
    write_with(folder, 10, "of b", run="b")
    partial = folder.next()
    (partial / "a").mkdir()
    (folder.states / "of a").write_text("")
    assert folder.commit(partial, {"a": member(10), "b": None}, {"a": ["of a"], "b": []})
    assert in_states(folder) == ["of a", "of b"]
    write_with(folder, 20, "of a")
    assert in_states(folder) == ["of a"]
    folder.close()


def test_files_are_no_state_by_themselves_and_go_with_what_the_user_has_ended(tmp_path):
    folder = AutosaveFolder(tmp_path)
    folder.next()
    folder.states.mkdir()
    (folder.states / "first").write_text("")
    folder.close()
    assert steps_in(tmp_path) == {}
    assert list(tmp_path.iterdir()) == []
    write_with(folder, 10, "first")
    folder.discard()
    assert list(tmp_path.iterdir()) == []


def test_a_run_of_which_nothing_is_known_is_not_kept(tmp_path):
    folder = AutosaveFolder(tmp_path)
    assert not write(folder, a=None, b=10)
    folder.close()
    assert steps_in(tmp_path) == {}


def test_the_oldest_go_beyond_a_number_and_a_size_but_never_the_newest(tmp_path, monkeypatch):
    for day in range(1, 15):
        ended(tmp_path, f"202601{day:02d}-000000-1", day)
    assert list(steps_in(tmp_path).values()) == [[day] for day in range(14, 4, -1)]
    monkeypatch.setattr(unfinished, "LARGEST", 1)
    assert list(steps_in(tmp_path).values()) == [[14]]
    assert len(list(tmp_path.iterdir())) == 1


@pytest.mark.parametrize("name", ["..", "none", "a/b", ""])
def test_a_name_from_the_page_leads_nowhere_else(tmp_path, name):
    home = tmp_path / "home"
    home.mkdir()
    with pytest.raises(BarchanError, match="not kept any more"):
        Unfinished(home).discard(name)
    assert Unfinished(None).look().runs == {}


def test_a_folder_that_somebody_deletes_under_a_studio_is_made_again(tmp_path):
    folder = AutosaveFolder(tmp_path)
    write(folder, a=10)
    shutil.rmtree(folder.path)
    with pytest.raises(FileNotFoundError):
        folder.next()
    assert write(folder, a=20)
    folder.close()
    assert steps_in(tmp_path) == {folder.path.name: [20]}


def test_the_user_data_of_each_system_has_its_customary_place(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    assert data_folder("linux", {"XDG_DATA_HOME": "/data"}) == Path("/data/barchan")
    assert data_folder("linux", {"XDG_DATA_HOME": "relative"}) == tmp_path / ".local/share/barchan"
    assert data_folder("darwin", {}) == tmp_path / "Library/Application Support/barchan"
    assert data_folder("win32", {"LOCALAPPDATA": "/local"}) == Path("/local/barchan")
