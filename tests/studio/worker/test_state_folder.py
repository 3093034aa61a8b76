"""A run on disk: its branches, its earlier states and its moments are there when it is opened again."""

import json
import time
from dataclasses import asdict

import numpy as np
import pytest

from barchan.archive import checkpoint
from barchan.simulation import SetParameter
from barchan.studio.worker import state_files
from barchan.studio.worker.bookmarks import Bookmark
from barchan.studio.worker.rescue import from_bytes, to_bytes
from barchan.studio.worker.run import started
from barchan.studio.worker.state_files import FileNames, StateFiles, StateNames
from barchan.studio.worker.state_folder import beside_newest, open_newest, write_newest
from tests.studio.conftest import PATIENCE, small
from tests.studio.worker.test_rescue import Bench
from tests.studio.worker.test_run import run_to


class Disk:
    """Where a studio keeps a run, one state after the other."""

    def __init__(self, home) -> None:
        self.states = home / "states"
        self.home, self.names, self.count = home, FileNames(), 0

    def keep(self, run) -> StateFiles:
        files = StateFiles(self.states, self.names)
        beside = beside_newest(run, files)
        self.count += 1
        write_newest(run.live.state(), beside, self.newest)
        assert not files.write()
        return files

    @property
    def newest(self):
        return self.home / f"{self.count:06d}" / "a"

    def beside(self) -> dict:
        return json.loads((self.newest / "studio.json").read_text())


@pytest.fixture
def disk(tmp_path):
    return Disk(tmp_path)


def mark(run, name: str) -> None:
    step, branch = run.live.steps_done, run.branches.current
    run.mark(Bookmark(name, name, step, branch, len(run.live.events)))


def branched():
    """A run of 40 steps, and a branch of it from step 20 on that goes another way for 15 steps."""
    run = started(small())
    run_to(run, 17)
    mark(run, "early")
    run_to(run, 35)
    mark(run, "late")
    run_to(run, 40)
    run.look(20)
    run.branch()
    run.live.apply(SetParameter(key="model.hop_length", value=2.0))
    run_to(run, 35)
    mark(run, "elsewhere")
    return run


def test_every_branch_is_there_again_with_its_changes_measures_and_moments(disk):
    run = branched()
    disk.keep(run)
    again, lost = open_newest(disk.newest)
    assert lost == []
    assert again.branches.listing(35) == [
        {"number": 1, "began": 0, "step": 40},
        {"number": 2, "began": 20, "step": 35},
    ]
    assert again.branches.current == 2
    assert again.bookmarks.data() == run.bookmarks.data()
    for number, steps, changes in ((1, 60, 0), (2, 50, 1)):
        run.switch(number)
        again.switch(number)
        assert len(again.live.events) == changes
        assert again.measures.rows == run.measures.rows
        assert again.history.marks == run.history.marks
        run_to(run, steps)
        run_to(again, steps)
        assert np.array_equal(again.live.bed.sand, run.live.bed.sand)
        assert again.measures.rows == run.measures.rows


def test_one_looks_back_and_goes_on_from_an_earlier_state_with_the_same_bits(disk):
    run = branched()
    disk.keep(run)
    again, _ = open_newest(disk.newest)
    assert again.history.steps == [0, 10, 17, 20, 30, 35]
    again.switch(1)
    assert again.history.steps == [0, 10, 17, 20, 30, 35, 40]
    again.look(30)
    again.branch()
    assert again.branches.current == 3
    run_to(again, 40)
    run.switch(1)
    assert np.array_equal(again.live.bed.sand, run.live.bed.sand)


def test_a_state_that_stands_still_is_written_once_whichever_branches_have_it(disk):
    run = branched()
    first = disk.keep(run)
    # Branch 2 had passed 0, 10, 17, 20, 30; branch 1 those up to 20 too, then 30, 35, and ended at 40.
    assert len(first.needed) == 5 + 2 + 1
    assert sorted(path.name for path in disk.states.iterdir()) == sorted(first.needed)
    written = {path: path.stat().st_mtime_ns for path in disk.states.iterdir()}
    run_to(run, 45)
    second = disk.keep(run)
    assert len(second.needed) == len(first.needed) + 2  # those of steps 35, which is marked, and 40
    assert {path: path.stat().st_mtime_ns for path in written} == written
    run.switch(1)
    run_to(run, 41)
    run.switch(2)
    third = disk.keep(run)
    assert set(third.needed) - set(second.needed) != set()  # branch 1 ends elsewhere now
    assert read_steps(disk, [disk.beside()["others"][0]["newest"]]) == [41]


def read_steps(disk, names) -> list[int]:
    return [checkpoint.read_checkpoint(disk.states / name).step for name in names]


@pytest.mark.parametrize(
    ("most", "kept"),
    [
        (100, list(range(0, 100, 10))),
        (6, [0, 20, 40, 60, 80]),
        (4, [0, 40, 80]),
        (2, [0, 80]),
        (1, [80]),
        (0, []),
    ],
)
def test_earlier_states_on_disk_are_thinned_and_the_oldest_go_first(disk, monkeypatch, most, kept):
    """Those of a run of 100 steps, kept every 10; room for a number of states, which are of one size."""
    run = started(small())
    run_to(run, 100)
    size = sum(array.nbytes for array in run.live.state().arrays.values())
    files = StateFiles(disk.states, disk.names)
    names = files.add_earlier(run.history, 100, most * size)
    assert not files.write()
    assert read_steps(disk, names) == kept
    assert sum((disk.states / name).stat().st_size for name in names) <= most * size + 20_000 * len(names)
    assert run.history.steps == list(range(0, 101, 10))


def test_no_more_than_a_number_of_earlier_states_is_kept_on_disk_however_small(disk, monkeypatch):
    monkeypatch.setattr(state_files, "MOST_STATES", 4)
    run = started(small())
    run_to(run, 100)
    assert len(StateFiles(disk.states, disk.names).add_earlier(run.history, 100)) <= 4


def test_a_folder_of_a_version_that_kept_no_branches_opens_as_before(disk):
    run = started(small())
    run_to(run, 13)
    mark(run, "horns")
    run_to(run, 30)
    disk.keep(run)
    beside = {
        "every": run.history.every,
        "rows": run.measures.rows,
        "bookmarks": [asdict(bookmark) for bookmark in run.bookmarks],
    }
    (disk.newest / "studio.json").write_text(json.dumps(beside))
    again, lost = open_newest(disk.newest)
    assert lost == []
    assert [branch["number"] for branch in again.branches.listing(30)] == [1]
    assert again.history.steps == [30]
    assert again.history.marks == {"horns": 13}
    assert again.measures.rows == run.measures.rows


def test_a_damaged_branch_is_named_and_all_else_opens(disk):
    disk.keep(branched())
    (disk.states / disk.beside()["others"][0]["newest"]).write_bytes(b"damaged")
    again, lost = open_newest(disk.newest)
    assert len(lost) == 1
    assert lost[0].startswith("Branch 1 of this run cannot be opened any more: ")
    assert again.branches.numbers == [2]
    again.look(10)
    again.branch()
    assert again.branches.current == 3
    bench = Bench()
    bench.send("open_folder", folder=str(disk.newest), number=1)
    assert [message["text"] for message in bench.messages("refused")] == lost


def test_a_damaged_earlier_state_leaves_a_gap_and_no_other_loss(disk):
    disk.keep(branched())
    names = disk.beside()["states"]
    (disk.states / names[1]).write_bytes(b"damaged")
    (disk.states / names[2]).unlink()
    again, lost = open_newest(disk.newest)
    assert lost == []
    assert again.history.steps == [0, 20, 30, 35]
    assert again.branches.numbers == [1, 2]


def answer_to(bench, **request) -> dict:
    """The answer of a worker to a request that takes longer than a step."""
    bench.send(**request, id=1)
    end = time.monotonic() + PATIENCE
    while not (found := bench.messages("done")):
        assert time.monotonic() < end
        bench.worker.work()
    return found[0]


def test_where_earlier_states_find_no_room_the_newest_one_is_kept_and_it_is_said(tmp_path, monkeypatch):
    bench = Bench()
    bench.send("start", scenario=small().data(), number=1)
    run_to(bench.worker.commands.current, 25)
    write = checkpoint.write_checkpoint

    def full(path, state):
        if path.parent.name == "states":
            path.with_suffix(".partial").write_text("half")
            raise OSError(28, "No space left on device")
        write(path, state)

    monkeypatch.setattr(checkpoint, "write_checkpoint", full)
    request = {"command": "keep_in", "states": str(tmp_path / "states"), "known": None}
    answer = answer_to(bench, **request, folder=str(tmp_path / "1" / "a"))
    assert answer["lacking"] == "No space left on device"
    assert answer["fingerprint"] is None
    assert list((tmp_path / "states").iterdir()) == []
    assert open_newest(tmp_path / "1" / "a")[0].live.steps_done == 25
    monkeypatch.undo()
    answer = answer_to(bench, **request, folder=str(tmp_path / "2" / "a"))
    assert answer["lacking"] == ""
    assert open_newest(tmp_path / "2" / "a")[0].history.steps == [0, 10, 20]
    again = answer_to(bench, **{**request, "known": answer["fingerprint"]}, folder=str(tmp_path / "3" / "a"))
    assert not again["written"]


def test_the_file_of_a_thing_is_its_own_for_as_long_as_it_exists():
    names = FileNames()
    run = started(small())
    run_to(run, 20)
    first, second = run.history.states[:2]
    assert names.of(first) == names.of(first) != names.of(second)
    before = names.of(first)
    del first
    run.history.states.clear()
    assert names.of(second) not in {before}
    assert len(names._known) == 1


def test_a_lost_process_leaves_the_branches_and_earlier_states_that_are_on_disk(disk):
    run = branched()
    disk.keep(run)
    run_to(run, 38)
    data = to_bytes(run, 1, StateNames(disk.states, disk.names))
    again, lost = from_bytes(data)
    assert lost == []
    assert again.branches.listing(38) == run.branches.listing(38)
    assert again.history.steps == [0, 10, 17, 20, 30, 38]  # step 35 was the newest, not an earlier one
    assert [one.name for one in again.bookmarks] == ["early", "late", "elsewhere"]
    for one in (run, again):
        one.switch(1)
        run_to(one, 44)
    assert np.array_equal(again.live.bed.sand, run.live.bed.sand)
    assert again.measures.rows == run.measures.rows


def test_a_branch_that_was_not_on_disk_yet_is_named_when_a_process_is_lost(disk):
    data = to_bytes(branched(), 1, StateNames(disk.states, disk.names))
    again, lost = from_bytes(data)
    assert len(lost) == 1
    assert lost[0].startswith("Branch 1 of this run cannot be opened any more: ")
    assert again.branches.listing(35) == [{"number": 2, "began": 20, "step": 35}]
