"""Bookmarks: the moment of each is kept to the bit, whatever else of a run's past is forgotten."""

import json

import numpy as np
import pytest

from barchan.errors import BarchanError
from barchan.simulation import SetParameter, Simulation, State
from barchan.studio.worker import bookmarks as bookmarks_module
from barchan.studio.worker import history as history_module
from barchan.studio.worker.bookmarks import Bookmark, Bookmarks, bookmark_from, identity
from barchan.studio.worker.history import History
from barchan.studio.worker.rescue import from_bytes, to_bytes
from barchan.studio.worker.run import started, states_of
from barchan.studio.worker.saved_runs import open_saved_run, save_run
from barchan.studio.worker.state_files import FileNames, StateNames
from tests.studio.conftest import small
from tests.studio.worker.test_run import run_to


def marked(run, name="moment"):
    """Set a bookmark at what a run shows."""
    events = len(run.shown.events)
    run.mark(Bookmark(name, name, run.shown.steps_done, run.branches.current, events))
    return run.shown.bed.sand.copy()


def test_a_marked_state_between_those_that_are_kept_is_found_again_to_the_bit(scenario):
    run = started(scenario)
    run_to(run, 13)
    sand = marked(run)
    run_to(run, 40)
    assert run.history.steps == [0, 10, 13, 20, 30, 40]
    run.look(13)
    assert np.array_equal(run.shown.bed.sand, sand)


def test_a_mark_ahead_of_the_run_is_kept_when_the_run_comes_there(scenario):
    run = started(scenario)
    run.mark(Bookmark("ahead", "ahead", 17))
    run_to(run, 25)
    assert run.history.steps == [0, 10, 17, 20]
    alone = Simulation(scenario)
    alone.advance(17)
    assert np.array_equal(run.history.at(17).arrays["bed/sand"], alone.bed.sand)


def test_marked_states_are_held_while_every_second_other_one_is_forgotten(monkeypatch):
    """Room for five: with 40 there are six, so 10 and 30 go; 33 is marked and stays."""
    monkeypatch.setattr(history_module, "MOST_STATES", 5)
    history = History(10, marks={"one": 33})
    for step in (0, 10, 20, 30, 33, 40, 60):
        history.keep(State({"step": step}, {"sand": np.full(4, step)}))
    assert history.steps == [0, 20, 33, 40, 60]


def test_marks_that_fill_all_the_room_end_the_forgetting(monkeypatch):
    monkeypatch.setattr(history_module, "MOST_STATES", 2)
    history = History(10, marks={"one": 10, "two": 20, "three": 30})
    for step in (0, 10, 20, 30):
        history.keep(State({"step": step}, {"sand": np.full(4, step)}))
    assert history.steps == [0, 10, 20, 30]


def test_what_is_painted_at_a_step_that_is_kept_already_belongs_to_its_bookmark(scenario):
    run = started(scenario)
    run_to(run, 10)
    run.live.apply(SetParameter(key="model.p_s", value=0.9))
    marked(run)
    assert len(Simulation.from_state(run.history.at(10)).events) == 1


def test_a_branch_knows_the_bookmarks_of_the_past_that_it_shares_and_no_others(scenario):
    run = started(scenario)
    run_to(run, 10)
    marked(run, "early")
    run_to(run, 30)
    marked(run, "late")
    run.look(20)
    run.branch()
    assert [one.id for one in run.bookmarks] == ["early", "late"]
    assert [one.id for one in run.bookmarks_here()] == ["early"]
    run.switch(1)
    assert [one.id for one in run.bookmarks_here()] == ["early", "late"]


def test_bookmarks_are_saved_beside_the_run_and_found_when_it_is_opened(scenario, tmp_path):
    run = started(scenario)
    run_to(run, 13)
    sand = marked(run, "horns")
    run_to(run, 30)
    save_run(states_of(run), tmp_path / "mine", bookmarks=run.bookmarks_here())
    again = open_saved_run(tmp_path / "mine")
    assert [(one.name, one.step) for one in again.bookmarks] == [("horns", 13)]
    again.look(13)
    assert np.array_equal(again.shown.bed.sand, sand)


@pytest.mark.parametrize(
    "text", ["", "[", "[5]", '[{"id": "a"}]', '{"a": 1}', '[{"id": 1, "name": 2, "step": "x"}]']
)
def test_a_damaged_file_of_bookmarks_leaves_the_run_good(scenario, tmp_path, text):
    run = started(scenario)
    run_to(run, 10)
    save_run(states_of(run), tmp_path / "mine")
    (tmp_path / "mine" / "bookmarks.json").write_text(text)
    assert list(open_saved_run(tmp_path / "mine").bookmarks) == []


def test_bookmarks_come_through_the_loss_of_a_process(scenario, tmp_path):
    run = started(scenario)
    run_to(run, 10)
    marked(run, "kept")
    again, _ = from_bytes(to_bytes(run, 1, StateNames(tmp_path, FileNames())))
    assert [one.name for one in again.bookmarks] == ["kept"]


def test_a_run_has_a_limited_number_of_bookmarks(monkeypatch):
    monkeypatch.setattr(bookmarks_module, "MOST", 1)
    bookmarks = Bookmarks([Bookmark("a", "first", 5)])
    bookmarks.set(Bookmark("a", "renamed", 99))
    assert [(one.name, one.step) for one in bookmarks] == [("renamed", 5)]
    with pytest.raises(BarchanError, match="allowed: no more"):
        bookmarks.set(Bookmark("b", "second", 5))


@pytest.mark.parametrize(
    "data",
    [5, {}, {"id": "a", "name": "b", "step": "x"}, {"id": "a", "name": "b", "camera": 5}]
    + [
        {"id": "a", "name": "b", "camera": {"position": value}}
        for value in ([1e999], [0] * 99, [{}], {"x": 1})
    ],
)
def test_data_that_are_no_bookmark_are_refused(data):
    with pytest.raises(BarchanError, match="no bookmark"):
        bookmark_from(data)


def test_a_bookmark_comes_through_a_file_as_it_was():
    camera = {"viewpoint": "oblique", "position": [1.0, 2.5, -3.0], "zoom": 1.0}
    bookmark = Bookmark("a", "the horns", 40, 2, 1, "slope", camera)
    assert bookmark_from(json.loads(json.dumps(vars(bookmark)))) == bookmark


def test_runs_of_one_scenario_and_seed_have_one_identity_whatever_their_words_and_changes():
    plain = Simulation(small())
    changed = Simulation(small(title="another title"))
    changed.apply(SetParameter(key="model.p_s", value=0.9))
    assert identity(plain) == identity(changed)
    assert identity(Simulation(small(run={"steps": 100, "seed": 8, "save_every": 10}))) != identity(plain)
