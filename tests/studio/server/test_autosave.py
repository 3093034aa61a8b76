"""A studio that ends unexpectedly takes no run along."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from contextlib import contextmanager

import numpy as np
import pytest
from websockets.sync.client import connect

from barchan.archive import open_run
from barchan.archive.checkpoint import read_checkpoint
from barchan.simulation import SetParameter, Simulation
from barchan.studio.server import autosave, autosave_folder
from barchan.studio.server.together import read_together
from barchan.studio.server.unfinished import Unfinished
from tests.studio.conftest import PATIENCE, Browser, serving, small


@pytest.fixture
def eager(monkeypatch):
    monkeypatch.setattr(autosave, "EVERY", 0.2)
    monkeypatch.setattr(autosave, "SOON", 0.05)


def until(condition):
    end = time.monotonic() + PATIENCE
    while not (found := condition()):
        assert time.monotonic() < end
        time.sleep(0.02)
    return found


def step_on_disk(home):
    """The step of the newest state in a studio's folder, whether or not the studio runs."""
    newest = sorted(home.glob("*[0-9]/[0-9][0-9][0-9][0-9][0-9][0-9]/a/checkpoint.npz"))
    try:
        return read_checkpoint(newest[-1]).step if newest else 0
    except OSError:  # it has just made room for the next one
        return 0


def left_in(home):
    (name, runs), *_ = Unfinished(home).look().runs.items()
    return name, runs


def alone(step: int, change_at: int) -> Simulation:
    simulation = Simulation(small())
    simulation.advance(change_at)
    simulation.apply(SetParameter(key="model.p_s", value=0.9))
    simulation.advance(step - change_at)
    return simulation


def test_a_run_is_on_disk_on_every_pause_and_goes_on_with_the_same_bits_changes_and_moments(
    tmp_path, monkeypatch
):
    monkeypatch.setattr(autosave, "SOON", 0.05)
    home = tmp_path / "home"
    with serving(tmp_path, small(), home=home) as first, first.browser() as browser:
        browser.send("pause")
        browser.send("restart", running=False)
        browser.send("run", until=30)
        browser.until_message("scenario")
        browser.until_frame(lambda status: status["step"] == 30)
        browser.send("set", key="model.p_s", value=0.9)
        browser.send("bookmark", bookmarks=[{"id": "horns", "name": "Horns", "step": 30}])
        browser.send("run", until=45)
        browser.until_frame(lambda status: status["step"] == 45)
        until(lambda: step_on_disk(home) == 45)
    name, left = left_in(home)
    assert [(run.model, run.step, run.steps) for run in left.members] == [("werner", 45, 100)]
    with serving(tmp_path, small(), home=home) as second, second.browser() as browser:
        browser.until_frame()
        browser.send("open_unfinished", name=name, id=1)
        assert browser.until_message("done", id=1)["step"] == 45
        described = [one for one in browser.messages if one["type"] == "scenario"][-1]
        assert [one["name"] for one in described["bookmarks"]] == ["Horns"]
        assert described["changes"]
        assert described["scenario"]["model"]["p_s"] == 0.9
        browser.send("run", until=60)
        browser.until_frame(lambda status: status["step"] == 60)
        until(lambda: step_on_disk(home) == 60)
        until(lambda: not (home / name).exists())
    state = read_checkpoint(left_in(home)[1].folders[0] / "checkpoint.npz")
    assert np.array_equal(state.arrays["bed/sand"], alone(60, 30).bed.sand)


def go_two_ways(browser):
    """From a run of 40 steps, look back at step 20 and go on from there, another way, to step 30."""
    browser.send("pause")
    browser.send("restart", running=False)
    browser.send("run", until=40)
    browser.until_frame(lambda status: status["step"] == 40)
    browser.send("look", step=20)
    browser.until_frame(lambda status: status["looking"])
    browser.send("branch", id=1)
    assert browser.until_message("done", id=1)["step"] == 20
    browser.send("set", key="model.p_s", value=0.9)
    browser.send("bookmark", bookmarks=[{"id": "horns", "name": "Horns"}])
    browser.send("run", until=30)
    browser.until_frame(lambda status: status["step"] == 30 and not status["looking"])


@pytest.mark.extended
@pytest.mark.skipif(sys.platform != "linux", reason="the user's data are elsewhere")
def test_after_a_kill_the_branches_are_there_and_one_looks_back_as_before(tmp_path):
    scenario = tmp_path / "winds.json"
    scenario.write_text(json.dumps(small().data()))
    home = tmp_path / "barchan" / "studio-autosave"
    with studio(tmp_path, tmp_path, str(scenario)) as process:
        with browser_of(process) as browser:
            go_two_ways(browser)
            until(lambda: step_on_disk(home) == 30)
        os.kill(process.pid, signal.SIGKILL)
        process.wait(20)
    with studio(tmp_path, tmp_path, str(scenario)) as process, browser_of(process) as browser:
        browser.until_frame()
        browser.send("open_unfinished", name=left_in(home)[0], id=1)
        assert browser.until_message("done", id=1)["step"] == 30
        described = [one for one in browser.messages if one["type"] == "scenario"][-1]
        assert described["branch"] == 2
        assert described["branches"] == [
            {"number": 1, "began": 0, "step": 40},
            {"number": 2, "began": 20, "step": 30},
        ]
        assert [(one["name"], one["branch"]) for one in described["bookmarks"]] == [("Horns", 2)]
        assert described["scenario"]["model"]["p_s"] == 0.9
        browser.send("switch", branch=1)
        described = browser.until_message("scenario", branch=1)
        assert described["scenario"]["model"]["p_s"] == 0.6
        browser.until_frame(lambda status: status["step"] == 40)
        browser.send("look", step=30)
        browser.until_frame(lambda status: status["step"] == 30 and status["can_branch"])
        browser.send("look", step=None)
        browser.send("save", name="first", id=2)
        browser.until_message("done", id=2)
    sand = read_checkpoint(tmp_path / "first" / "checkpoint.npz").arrays["bed/sand"]
    uninterrupted = Simulation(small())
    uninterrupted.advance(40)
    assert np.array_equal(sand, uninterrupted.bed.sand)
    with open_run(tmp_path / "first") as dataset:
        assert list(dataset["step"].values) == [0, 10, 20, 30, 40]


@pytest.mark.extended
def test_a_studio_that_the_user_ends_leaves_nothing(eager, tmp_path):
    home = tmp_path / "home"
    with serving(tmp_path, small(), home=home) as served:
        until(lambda: step_on_disk(home) > 0)
        served.session.autosave.forsake()
    assert list(home.iterdir()) == []


@pytest.mark.extended
def test_a_disk_that_is_full_is_said_once_and_the_run_goes_on(eager, tmp_path, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(autosave_folder.AutosaveFolder, "next", full)
    with serving(tmp_path, small(), home=tmp_path / "home") as served, served.browser() as browser:
        text = browser.until_message("refused")["text"]
        assert "The run is not kept on disk: No space left on device." in text
        browser.until_frame(lambda status: status["step"] == 100)
    assert sum(message["type"] == "refused" for message in browser.messages) == 1


@pytest.mark.extended
def test_what_cannot_be_opened_stays_on_disk_and_is_named(eager, tmp_path):
    home = tmp_path / "home"
    with serving(tmp_path, small(), home=home):
        until(lambda: step_on_disk(home) > 0)
    name, left = left_in(home)
    (left.folders[0] / "checkpoint.npz").write_bytes(b"")
    with serving(tmp_path, small(), home=home) as served, served.browser() as browser:
        browser.send("open_unfinished", name=name, id=1)
        text = browser.until_message("refused", id=1)["text"]
        assert "checkpoint.npz: damaged" in text
        assert "checkpoint.npz" in served.session.unfinished.look().broken[0]
    assert (home / name).is_dir()


@pytest.mark.extended
def test_a_pair_that_was_interrupted_goes_on_side_by_side(eager, tmp_path):
    home = tmp_path / "home"
    with serving(tmp_path, small(), home=home) as served, served.browser() as browser:
        browser.until_frame()
        browser.send("compare", model="momiji")
        until(lambda: len(list(home.glob("*/*[0-9]/b/checkpoint.npz"))) == 1)
    name, left = left_in(home)
    step = left.members[0].step
    assert [run.model for run in left.members] == ["werner", "momiji"]
    with serving(tmp_path, small(), home=home) as served, served.browser() as browser:
        browser.until_frame()
        browser.send("open_unfinished", name=name, id=1)
        assert browser.until_message("done", id=1)["step"] == step
        for run in "ab":
            browser.until(lambda h, f: f is not None and h["run"] == run and h["status"]["step"] == step)  # noqa: B023


@contextmanager
def studio(folder, home, *names):
    """The studio as the command line starts it: the process, its address, and its first lines."""
    command = [sys.executable, "-c", "from barchan.cli import main; main()", "studio", *names]
    environment = {**os.environ, "XDG_DATA_HOME": str(home), "COLUMNS": "400"}
    options = ["--no-browser", "--port", "0", "--folder", str(folder)]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    process = subprocess.Popen([*command, *options], env=environment, **pipes)
    try:
        yield process
    finally:
        process.kill()
        process.wait(20)
        process.stdout.close()


@contextmanager
def browser_of(process):
    """The browser's end of the connection to a studio that the command line has started."""
    address = re.search(r"http://(\S+?)/\S*token=([\w-]+)", line_with(process, "http"))
    url = f"ws://{address[1]}/connection?token={address[2]}"
    with connect(url, max_size=None, compression=None, proxy=None) as connection:
        yield Browser(connection)


def line_with(process, words: str) -> str:
    return next(line for line in process.stdout if re.search(words, line))


@pytest.mark.extended
@pytest.mark.skipif(sys.platform != "linux", reason="the user's data are elsewhere")
def test_the_terminal_says_after_a_kill_where_the_run_stopped_and_ctrl_c_leaves_nothing(tmp_path):
    scenario = tmp_path / "winds.json"
    scenario.write_text(json.dumps(small(title="Two winds").data()))
    home = tmp_path / "barchan" / "studio-autosave"
    with studio(tmp_path, tmp_path, str(scenario), "--run.steps", "40") as process:
        line_with(process, "http")
        until(lambda: step_on_disk(home) == 40)
        os.kill(process.pid, signal.SIGKILL)
    with studio(tmp_path, tmp_path, str(scenario)) as process:
        said = line_with(process, "stopped unexpectedly")
        assert "a run of 'Two winds' stopped unexpectedly at step 40 on" in said
        until(lambda: len(list(home.iterdir())) == 2)
        process.send_signal(signal.SIGINT)
        process.wait(20)
    left = left_in(home)[1]
    uninterrupted = Simulation(small())
    uninterrupted.advance(40)
    sand = read_checkpoint(left.folders[0] / "checkpoint.npz").arrays["bed/sand"]
    assert left.members[0].step == 40
    assert np.array_equal(sand, uninterrupted.bed.sand)
    assert len(list(home.iterdir())) == 1


@pytest.mark.extended
def test_a_run_that_is_set_aside_is_offered_as_a_run_of_its_own(eager, tmp_path):
    home = tmp_path / "home"

    def offered() -> list[tuple[str, int]]:
        runs = [
            read_together(path.parent).members
            for path in home.glob("*/[0-9][0-9][0-9][0-9][0-9][0-9]/*.json")
        ]
        return sorted((run.title, run.step) for (run,) in runs)

    with serving(tmp_path, small(title="First"), home=home) as served, served.browser() as browser:
        browser.send("pause")
        browser.send("restart", running=False)
        browser.send("run", until=30)
        browser.until_frame(lambda status: status["step"] == 30)
        other = small(title="Second").data()
        browser.send("create", scenario=other, aside=True, running=False, id=1)
        assert browser.until_message("done", id=1)["aside"] == "First"
        browser.send("run", until=20)
        until(lambda: offered() == [("First", 30), ("Second", 20)])
        browser.send("alone", id=2)
        assert browser.until_message("done", id=2)["aside"] == "Second"
        browser.send("run", until=40)
        until(lambda: offered() == [("First", 40), ("Second", 20)])
    found = Unfinished(home).look().runs
    name = next(name for name, runs in found.items() if runs.members[0].title == "Second")
    with serving(tmp_path, small(), home=home) as served, served.browser() as browser:
        browser.until_frame()
        browser.send("open_unfinished", name=name, id=1)
        assert browser.until_message("done", id=1)["step"] == 20


@pytest.mark.extended
def test_a_run_whose_place_aside_another_one_takes_is_offered_until_the_studio_ends(eager, tmp_path):
    home = tmp_path / "home"

    def offered() -> list[tuple[str, bool]]:
        listed = Unfinished(home).look().data()["unfinished"]
        return [(one["runs"][0]["title"], one["aside"]) for one in listed]

    with serving(tmp_path, small(title="First"), home=home) as served, served.browser() as browser:
        for number, title in enumerate(("Second", "Third", "Fourth"), 1):
            browser.send("run", until=10 * number)
            browser.until_frame(lambda status, end=10 * number: status["step"] >= min(end, 10))
            before = len(list(home.glob("*-aside*/[0-9]*[0-9]/a")))
            browser.send("create", scenario=small(title=title).data(), aside=True, running=False, id=number)
            assert (
                browser.until_message("done", id=number)["ended"] == (None, None, "First", "Second")[number]
            )
            until(lambda before=before: len(list(home.glob("*-aside*/[0-9]*[0-9]/a"))) == before + 1)
        assert offered() == [("Second", True), ("First", True)]
        (first,) = (
            one["name"]
            for one in Unfinished(home).look().data()["unfinished"]
            if one["runs"][0]["title"] == "First"
        )
        browser.send("open_unfinished", name=first, id=9)
        assert browser.until_message("done", id=9)["step"] == 10
        until(lambda: offered() == [("Second", True)])
        served.session.autosave.forsake()
    assert not any(home.iterdir())


@pytest.mark.extended
@pytest.mark.skipif(sys.platform != "linux", reason="the user's data are elsewhere")
@pytest.mark.parametrize("then", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_ctrl_c_leaves_nothing_to_offer_whatever_signal_follows_it(tmp_path, then):
    """It is pressed again, or its terminal is closed before the studio has ended."""
    home = tmp_path / "barchan" / "studio-autosave"
    with studio(tmp_path, tmp_path, "barchans", "--lattice.rows", "32", "--lattice.columns", "48") as process:
        line_with(process, "http")
        until(lambda: step_on_disk(home) > 0)
        process.send_signal(signal.SIGINT)
        time.sleep(0.1)  # the first signal is to be the first
        process.send_signal(then)
        process.wait(20)
    found = Unfinished(home).look()
    assert (found.runs, found.broken) == ({}, [])


@pytest.mark.extended
def test_a_pair_that_is_saved_opens_side_by_side_with_both_histories(served, tmp_path):
    with served.browser() as browser:
        browser.until_frame()
        browser.send("compare", key="model.p_s", value=0.9)
        browser.until_message("lockstep", running=False)
        browser.send("save", name="pair", id=2)
        saved = browser.until_message("done", id=2)
        browser.send("saved", id=3)
        assert browser.until_message("done", id=3)["saved"] == ["pair"]
        browser.send("alone")
        browser.until_message("runs", runs=["a"])
        browser.frames.clear()
        browser.send("open", name="pair", id=4)
        assert browser.until_message("done", id=4)["step"] == saved["step"] == 100
        for run, p_s in (("a", 0.6), ("b", 0.9)):
            browser.send("look", step=50, run=run)
            browser.until(lambda h, f: f is not None and h["run"] == run and h["status"]["step"] == 50)  # noqa: B023
            assert served.session.scenarios[run]["model"]["p_s"] == p_s
    for folder in ("werner-a", "werner-b"):
        with open_run(served.folder / "pair" / folder) as dataset:
            assert list(dataset["step"].values) == list(range(0, 101, 10))
    with serving(tmp_path, archive=served.folder / "pair") as again, again.browser() as browser:
        for run in "ab":
            browser.until(lambda h, f: f is not None and h["run"] == run and h["status"]["step"] == 100)  # noqa: B023
        assert again.session.lockstep is not None
