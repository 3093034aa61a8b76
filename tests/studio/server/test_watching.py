"""Browsers that watch beside the one that commands: they see all, and change nothing."""

import socket
import time
from contextlib import contextmanager

import httpx
import pytest
from websockets.exceptions import ConnectionClosed

from barchan.studio.commands import COMMANDS
from barchan.studio.server import launch
from barchan.studio.server.app import FULL, NOT_ALLOWED
from barchan.studio.server.security import Guard
from tests.studio.conftest import Browser


@contextmanager
def watcher(served, confirms=True):
    with served.connection(served.guard.watch_token) as connection:
        yield Browser(connection, confirms)


def test_watchers_see_the_scene_the_status_and_the_measures_that_the_commanding_browser_sees(served):
    with served.browser() as owner, watcher(served) as one, watcher(served) as other:
        owner.until_frame(lambda status: status["step"] > 30)
        owner.send("pause")
        shown, fields = owner.until_frame(lambda status: not status["running"])
        for browser in (one, other):
            seen, its = browser.until_frame(lambda status: not status["running"])
            assert seen["status"]["step"] == shown["status"]["step"]
            assert (its["depth"] == fields["depth"]).all()
            assert "ground" in browser.frames[0][1]
            assert browser.frames[0][0]["measures_replaced"]
            assert next(m for m in browser.messages if m["type"] == "hello")["watching"]
            assert any(message["type"] == "scenario" for message in browser.messages)


def test_every_command_of_a_watcher_is_refused_and_changes_nothing(served):
    """All of the table except the word that a frame was drawn, with and without what they ask for."""
    with served.browser() as owner, watcher(served) as browser:
        owner.until_frame(lambda status: status["step"] > 5)
        owner.send("pause")
        before = owner.until_frame(lambda status: not status["running"])[0]["status"]
        scenario = served.session.scenarios["a"]
        full = {"scenario": scenario, "key": "model.hop_length", "value": 9, "name": "x", "look": {}}
        for number, name in enumerate(name for name in COMMANDS if name != "confirm"):
            for at, content in enumerate(({}, full)):
                browser.send(name, id=100 * number + at, **content)
                answer = browser.until(lambda message, _: message.get("id") is not None)[0]
                browser.messages.clear()
                assert (answer["type"], answer["command"]) == ("refused", name)
                assert "only watches" in answer["text"]
        owner.send("run", steps=1)
        after = owner.until_frame(lambda status: status["step"] > before["step"])[0]["status"]
        assert after["step"] == before["step"] + 1
        assert served.session.scenarios == {"a": scenario}
        assert not any(message.get("type") == "refused" for message in owner.messages)


def test_the_token_of_watchers_opens_nothing_but_what_the_page_needs_to_show_a_run(served):
    headers = {"x-barchan-token": served.guard.watch_token}
    for path in ("schema", "colours", "files"):
        assert httpx.get(f"{served.address}/api/{path}", headers=headers).status_code == 200
    for path in ("presets", "formats", "exports/1/dunes.asc", "pictures/barchans", "watching"):
        assert httpx.get(f"{served.address}/api/{path}", headers=headers).status_code == 403
    upload = f"{served.address}/api/upload?name=a.csv"
    assert httpx.post(upload, headers=headers, content=b"1,2").status_code == 403
    assert not (served.folder / "studio-uploads").exists()


def test_both_tokens_are_drawn_apart_and_no_other_one_may_watch(served):
    assert served.guard.watch_token not in (served.guard.token, Guard(1).watch_token)
    with served.connection("wrong") as connection, pytest.raises(ConnectionClosed) as closed:
        connection.recv(timeout=5)
    assert closed.value.rcvd.code == NOT_ALLOWED


def test_the_commanding_browser_is_told_how_many_watch_and_gets_the_link(served):
    with served.browser() as owner:
        owner.until_message("watchers", count=0)
        with watcher(served), watcher(served):
            owner.until_message("watchers", count=2)
        owner.until_message("watchers", count=0)
    headers = {"x-barchan-token": served.guard.token}
    answer = httpx.get(f"{served.address}/api/watching", headers=headers).json()
    assert answer == {"token": served.guard.watch_token, "addresses": []}  # it serves this computer only


def test_other_computers_addresses_of_a_server_that_lets_them_in():
    guard = Guard(8127, ("127.0.0.1", "localhost", "::1", "0.0.0.0", "10.0.0.7", "fd00::7"))
    assert guard.for_watchers()["addresses"] == ["http://10.0.0.7:8127", "http://[fd00::7]:8127"]


def test_a_second_commanding_browser_takes_over_and_watchers_stay(served):
    with watcher(served) as browser, served.browser() as first:
        first.until_frame()
        with served.browser() as second:
            with pytest.raises(ConnectionClosed) as closed:
                first.drain(10.0)
            assert closed.value.rcvd.code == 4001
            second.until_frame()
            second.send("pause")
            second.until_frame(lambda status: not status["running"])
            browser.until_frame(lambda status: not status["running"])


@pytest.mark.extended
def test_a_stalled_watcher_neither_slows_the_others_nor_is_sent_more_than_two_frames(served):
    with served.browser() as owner, watcher(served, confirms=False) as stalled:
        owner.send("run")
        first = owner.until_frame()[0]["status"]["live"]
        owner.until_frame(lambda status: status["live"] > first + 200)
        end = time.monotonic() + 1
        while time.monotonic() < end:
            try:
                data = stalled.connection.recv(timeout=0.3)
            except TimeoutError:
                break
            stalled.frames += [data] if isinstance(data, bytes) else []
        assert len(stalled.frames) <= 2
        stalled.confirms = True
        stalled.send("confirm", run="a")
        assert stalled.until_frame()[0]["status"]["live"] > first + 200  # the newest one, not those between


@pytest.mark.extended
def test_watchers_see_a_run_whose_commanding_browser_stalls_or_has_gone(served):
    with watcher(served) as browser:
        with served.browser(confirms=False) as owner:
            owner.until_frame()
            owner.send("run")
            at = browser.until_frame()[0]["status"]["live"]
            at = browser.until_frame(lambda status: status["live"] > at + 50)[0]["status"]["live"]
        browser.until_frame(lambda status: status["live"] > at + 50)


@pytest.mark.extended
def test_both_runs_of_a_pair_are_seen_by_one_who_comes_later(served):
    with served.browser() as owner:
        owner.until_frame()
        owner.send("compare", model="momiji", id=1)
        owner.until_frame(lambda _: owner.frames[-1][0]["run"] == "b")
        with watcher(served) as browser:
            browser.until(lambda header, fields: fields is not None and header["run"] == "b")
            hello = next(message for message in browser.messages if message["type"] == "hello")
            assert hello["runs"] == ["a", "b"]
            owner.send("alone")
            browser.until_message("runs", runs=["a"])


def test_the_look_of_the_commanding_browser_reaches_those_who_watch_and_those_who_come_later(served):
    with served.browser() as owner, watcher(served) as early:
        owner.send("share_look", look={"field": "slope"})
        assert early.until_message("look")["look"] == {"field": "slope"}
        with watcher(served) as late:
            late.until_message("look", look={"field": "slope"})
        owner.send("share_look", look=5, id=4)
        owner.until_message("refused", id=4)


def test_more_than_the_most_watchers_are_refused_with_a_reason(served, monkeypatch):
    monkeypatch.setattr("barchan.studio.server.audience.MOST_WATCHERS", 1)
    with watcher(served) as browser:
        browser.until_frame()
        with watcher(served) as second, pytest.raises(ConnectionClosed) as closed:
            second.receive()
        assert closed.value.rcvd.code == FULL


def test_a_server_that_lets_others_in_knows_its_names_in_the_network_and_no_loopback_among_them(monkeypatch):
    monkeypatch.setattr(socket, "gethostname", lambda: "classroom")
    addresses = [(0, 0, 0, "", ("127.0.1.1", 0)), (0, 0, 0, "", ("10.1.2.3", 0)), (0, 0, 0, "", ("::1", 0))]
    monkeypatch.setattr(socket, "getaddrinfo", lambda *_: addresses)
    monkeypatch.setattr(launch, "_outward", lambda: ["10.1.2.4"])
    assert launch.names_of("0.0.0.0") == ["classroom", "10.1.2.3", "10.1.2.4"]
    assert launch.names_of("127.0.0.1") == []
