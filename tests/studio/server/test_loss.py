"""A process that is lost takes nothing along that the user would miss."""

import os
import signal

import pytest

from barchan.studio.server import autosave, kept_states
from barchan.studio.server.kept_states import KeptStates
from barchan.studio.server.starts import Starts
from tests.studio.conftest import serving, small
from tests.studio.server.test_autosave import go_two_ways, step_on_disk, until

KILLED = -signal.SIGKILL


@pytest.fixture
def eager(monkeypatch):
    monkeypatch.setattr(kept_states, "EVERY", 0.2)


def kept_step(served, name="a") -> int | None:
    return served.session.kept.common_step([name])


def lose(served, browser, name="a") -> dict:
    os.kill(served.session.workers[name].process.pid, signal.SIGKILL)
    return browser.until_message("lost", run=name, code=KILLED)


def test_a_lost_run_goes_on_from_the_state_that_the_server_kept(eager, served):
    with served.browser() as browser:
        browser.until_frame(lambda _: (kept_step(served) or 0) > 0)
        kept = lose(served, browser)["kept"]
        assert kept > 0
        browser.send("revive", kept=kept)
        status = browser.until_frame(lambda status: status["step"] == kept)[0]["status"]
        assert not status["running"]
        browser.send("run", until=kept + 5)
        browser.until_frame(lambda status: status["step"] == kept + 5)


def test_branches_and_earlier_states_on_disk_come_through_the_loss(eager, tmp_path, monkeypatch):
    monkeypatch.setattr(autosave, "SOON", 0.05)
    home = tmp_path / "home"
    with serving(tmp_path, small(), home=home) as served, served.browser() as browser:
        go_two_ways(browser)
        until(lambda: step_on_disk(home) == 30 and kept_step(served) == 30)
        lose(served, browser)
        browser.messages.clear()
        browser.send("revive", kept=30)
        described = browser.until_message("scenario", branch=2)
        assert described["branches"] == [
            {"number": 1, "began": 0, "step": 40},
            {"number": 2, "began": 20, "step": 30},
        ]
        browser.send("look", step=10)
        browser.until_frame(lambda status: status["step"] == 10 and status["can_branch"])
        browser.send("switch", branch=1)
        browser.until_frame(lambda status: status["step"] == 40)
        assert not any(message["type"] == "refused" for message in browser.messages)


@pytest.mark.extended
def test_two_lost_runs_go_on_from_the_same_step(eager, served):
    with served.browser() as browser:
        browser.until_frame()
        browser.send("compare", model="momiji")
        browser.until_frame(lambda _: (served.session.kept.common_step(["a", "b"]) or 0) > 0)
        kept = lose(served, browser, "b")["kept"]
        assert kept is not None
        browser.frames.clear()
        browser.send("revive", kept=kept)
        for name in "ab":
            browser.until(lambda h, f: f is not None and h["run"] == name and h["status"]["step"] == kept)  # noqa: B023


@pytest.mark.extended
def test_a_scenario_chosen_while_the_process_ends_in_another_one_is_begun(served):
    with served.browser() as browser:
        browser.until_frame()
        pid = served.session.workers["a"].process.pid
        os.kill(pid, signal.SIGSTOP)
        browser.send("create", scenario=small(title="first").data())
        browser.send("create", scenario=small(title="second").data())
        browser.send("saved", id=1)
        browser.until_message("done", id=1)
        os.kill(pid, signal.SIGKILL)
        message = browser.until(lambda m, _: m.get("type") == "scenario" and m["scenario"]["title"])[0]
        assert message["scenario"]["title"] == "second"


@pytest.mark.extended
def test_a_scenario_that_was_refused_is_not_what_restarts(served):
    large = {**small().data(), "title": "large", "lattice": {"rows": 65536, "columns": 65536}}
    with served.browser() as browser:
        browser.until_frame()
        browser.send("create", scenario=large, id=3)
        text = browser.until_message("refused")["text"]
        assert "65,536 × 65,536 cells, for which a run needs about" in text
        lose(served, browser)
        browser.send("revive")
        assert browser.until_message("scenario")["scenario"]["lattice"]["rows"] == 32


def test_the_start_that_ended_a_process_is_not_tried_again():
    starts = Starts()
    starts.add("a", {"command": "start"})
    assert starts.lost("a") is None
    starts.add("a", {"command": "start"})
    newest = starts.add("a", {"command": "start"})
    assert starts.lost("a") == newest.request


def test_states_of_a_run_that_was_replaced_are_not_offered():
    from struct import pack

    from barchan.studio.protocol import STATE_HEAD, STATE_MAGIC

    def state(number, step):
        return STATE_MAGIC + pack(STATE_HEAD, number, step)

    kept = KeptStates()
    kept.begun("a", 1, resumed=False)
    kept.take("a", state(1, 900))
    kept.take("a", state(1, 40))
    assert kept.common_step(["a"]) == 40
    kept.begun("a", 2, resumed=False)
    assert kept.common_step(["a"]) is None
    kept.take("a", state(1, 920))
    assert kept.common_step(["a"]) is None
