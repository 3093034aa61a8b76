"""The comparison report: which worker does what, and what is left of it."""

import re
from pathlib import Path

import pytest

from barchan.errors import BarchanError
from barchan.figures.comparison import style_of
from barchan.studio.server.reports import Reports
from barchan.studio.server.workspace import Workspace


class Worker:
    """Notes what it is asked for."""

    def __init__(self):
        self.asked = []

    def send(self, command, **content):
        self.asked.append((command, content))


class Session:
    """Two workers, and what the browser gets."""

    def __init__(self, folder, names="ab"):
        self.workspace = Workspace(folder)
        self.workers = {name: Worker() for name in names}
        self.told = []

    def tell(self, kind, **content):
        self.told.append((kind, content))

    def last(self, name):
        return self.workers[name].asked[-1]


@pytest.fixture
def session(tmp_path):
    return Session(tmp_path)


@pytest.fixture
def reports(session):
    """A report on two runs that both are being saved; a folder has been begun for each."""
    reports = Reports(session)
    reports.begin(40, 7)
    for name in "ab":
        folder = session.workspace.folder / "studio-exports" / "1" / "members" / name
        assert session.last(name) == (
            "save_folder",
            {"folder": str(folder), "until": 40, "id": f"report 1 {name}"},
        )
        folder.mkdir(parents=True)
    return reports


def left(session):
    return [path.name for path in (session.workspace.folder / "studio-exports").rglob("*")]


def test_the_report_is_written_when_both_runs_are_saved_and_nothing_else_is_left(session, reports):
    assert reports.takes({"type": "progress", "id": "report 1 a", "done": 1, "of": 2})
    assert session.told == [("progress", {"id": 7, "done": 8, "of": 100})]  # 0.3 × (0.5 + 0) / 2
    reports.takes({"type": "done", "id": "report 1 b", "frames": 3})
    reports.takes({"type": "done", "id": "report 1 a", "frames": 3})
    command, content = session.last("a")
    assert command == "report_to"
    assert [run.rpartition("/")[2] for run in content["runs"]] == ["a", "b"]
    (session.workspace.folder / "studio-exports" / "1" / "comparison.html").write_text("x")
    reports.takes({"type": "done", "id": content["id"], "file": "1/comparison.html"})
    assert session.told[-1] == ("done", {"id": 7, "file": "1/comparison.html"})
    assert left(session) == ["1", "comparison.html"]


def test_of_a_report_that_is_broken_off_nothing_is_left_when_both_workers_have_left_it(session, reports):
    reports.break_off(8)
    assert session.told == []
    reports.break_off(7)
    assert session.told[-1][1]["text"] == "broken off"
    for name in "ab":
        assert session.last(name) == ("break_off", {"of": f"report 1 {name}"})
        assert left(session)
        reports.takes({"type": "refused", "id": f"report 1 {name}", "text": "broken off"})
    assert left(session) == []


def test_a_run_that_is_lost_ends_its_report(session, reports):
    reports.lose("b")
    assert session.told[-1][0] == "refused"
    assert "run b has ended" in session.told[-1][1]["text"]
    reports.takes({"type": "done", "id": "report 1 a", "frames": 3})
    assert left(session) == []
    reports.begin(40, 9)  # another one may be begun


def test_what_a_worker_refuses_is_the_answer(session, reports):
    reports.takes({"type": "refused", "id": "report 1 a", "text": "no room on the disk"})
    kind, content = session.told[-1]
    assert (kind, content["id"], content["text"]) == ("refused", 7, "no room on the disk")


def test_other_messages_are_not_taken(reports):
    for given in (None, 7, "compare 1 a"):
        assert not reports.takes({"type": "done", "id": given})


def test_one_run_has_no_report_and_two_have_one_at_a_time(tmp_path, reports):
    with pytest.raises(BarchanError, match="needs two runs"):
        Reports(Session(tmp_path, "a")).begin(40, 7)
    with pytest.raises(BarchanError, match="being made already"):
        reports.begin(40, 8)


def test_the_lines_of_a_report_are_those_of_the_page():
    """Dark and full on the left, blue and dashed on the right, as in the light theme of the page."""
    style = (Path(__file__).parents[3] / "web" / "src" / "style.css").read_text("utf-8").partition("}")[0]
    colours = dict(re.findall(r"--([\w-]+): ([^;]+);", style))
    sides = [colours[colours[side].removeprefix("var(--").removesuffix(")")] for side in ("left", "right")]
    assert [style_of(at)["color"] for at in (0, 1)] == sides
    assert [style_of(at)["linestyle"] for at in (0, 1)] == ["-", "--"]
