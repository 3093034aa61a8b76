import json
import os
import signal
import time
from pathlib import Path

import httpx
import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from barchan.simulation import Simulation
from barchan.studio.protocol import FRAMES_IN_FLIGHT
from barchan.studio.server.app import NOT_ALLOWED
from barchan.studio.server.security import LARGEST_UPLOAD
from tests.studio.conftest import Browser, serving, small


def test_frames_show_the_bits_that_the_simulation_gives(served, scenario):
    with served.browser() as browser:
        browser.until_frame(lambda status: status["step"] > 0)
        browser.send("pause")
        header, fields = browser.until_frame(lambda status: not status["running"])
        alone = Simulation(scenario)
        alone.advance(header["status"]["step"])
    assert np.allclose(fields["depth"].reshape(32, 48), alone.bed.sand * alone.lattice.thickness)


def test_a_browser_that_confirms_nothing_gets_two_frames_while_the_run_goes_on(served):
    with served.browser(confirms=False) as browser:
        first = browser.until_frame()[0]["status"]["live"]
        browser.until_frame()
        with pytest.raises(TimeoutError):
            browser.drain(0.5)
        assert len(browser.frames) == FRAMES_IN_FLIGHT
        browser.send("confirm", run="a")
        later = browser.until_frame()[0]["status"]["live"]
    assert later > first + FRAMES_IN_FLIGHT


def memory(pid: int) -> float:
    """Resident memory of a process (MB)."""
    text = Path(f"/proc/{pid}/status").read_text()
    return int(next(line for line in text.splitlines() if line.startswith("VmRSS")).split()[1]) / 1024


@pytest.mark.skipif(not Path("/proc/self/status").is_file(), reason="needs /proc")
def test_a_stalled_browser_neither_halts_the_run_nor_grows_memory(served):
    def steps_in(browser: Browser, seconds: float) -> int:
        """Steps that were done while the browser took frames for so long."""
        first, end = browser.until_frame()[0]["status"]["live"], time.monotonic() + seconds
        while time.monotonic() < end:
            last = browser.until_frame()[0]["status"]["live"]
        return last - first

    with served.browser() as browser:
        browser.until_frame()
        browser.send("limit", rate=None)
        browser.send("run", until=1_000_000)
        browser.until_frame(lambda status: status["step"] > 3000)
        lively = steps_in(browser, 1.0)
        browser.confirms = False
        last = [browser.until_frame()[0]["status"]["live"] for _ in range(FRAMES_IN_FLIGHT)][-1]
        pids = os.getpid(), served.session.workers["a"].process.pid
        before = [memory(pid) for pid in pids]
        time.sleep(3.0)
        grown = [memory(pid) - known for pid, known in zip(pids, before, strict=True)]
        browser.send("confirm", run="a")
        stalled = browser.until_frame()[0]["status"]["live"] - last
        assert stalled > lively / 4  # in three times as long: how fast is for benchmarks
        assert max(grown) < 8.0


def test_a_live_parameter_changes_during_the_run(served):
    with served.browser() as browser:
        browser.until_frame()
        browser.send("set", key="model.hop_length", value=3.0, id=1, run="a")
        message = browser.until(
            lambda message, _: message.get("type") == "scenario" and message["events"] == 1
        )[0]
        assert message["scenario"]["model"]["hop_length"] == 3.0
        browser.until_message("done", id=1)


def test_rock_and_plants_are_painted_and_the_ground_is_sent_again(served):
    place = {"x": 20.0, "y": 12.0, "radius": 6.0}
    with served.browser() as browser:
        browser.send("create", scenario=small(model={"name": "nield_baas"}).data(), running=False)
        message = browser.until(lambda message, _: len(message.get("brushes", [])) == 5)[0]
        assert [brush["title"] for brush in message["brushes"]] == [
            "sand",
            "rock",
            "grass",
            "mesquite",
            "shrub",
        ]
        browser.send("view", fields=["grass"])
        rock = {**message["brushes"][1]["stroke"], **place, "amount": 6}
        browser.send("stroke", begin=True, end=True, stroke=rock)
        risen = browser.until(
            lambda _, fields: fields is not None and fields.get("ground", np.zeros(1)).any()
        )
        assert risen[1]["ground"].max() == pytest.approx(2.0, abs=0.4)
        grass = {**message["brushes"][2]["stroke"], **place, "amount": 0.5}
        browser.send("stroke", begin=True, end=True, stroke=grass)
        browser.until(lambda _, fields: fields is not None and fields["grass"].max() > 0.4)
        assert "ground" not in browser.frames[-1][1]
        browser.send("stroke", begin=True, stroke={**grass, "field": "gras"}, id=7)
        assert "did you mean" in browser.until_message("refused", id=7)["text"]
        browser.send("stroke", stroke={"kind": "wind", "wind": {"direction": 0}}, id=8)
        assert "no stroke" in browser.until_message("refused", id=8)["text"]


def test_the_last_frame_of_a_paused_run_is_followed_by_its_fields(served):
    with served.browser() as browser:
        browser.send("view", fields=["shadow"])
        browser.until_frame(lambda status: status["step"] > 30)
        browser.send("pause")
        browser.until(lambda header, fields: fields is not None and not header["status"]["running"])
        if "shadow" not in browser.frames[-1][1]:
            browser.until(lambda _, fields: fields is not None and "shadow" in fields)
        assert browser.frames[-1][0]["shown"] == ["shadow"]


@pytest.mark.extended
def test_paths_of_grains_come_with_frames_as_many_as_asked_for(served):
    lattice = {"rows": 16, "columns": 32, "cell_size": 0.01, "slab_height": 0.15e-3}
    grains = small(
        lattice=lattice, sand={"kind": "flat", "mean": 20}, model={"name": "wang_hu", "wind_speed": 12}
    )
    with served.browser() as browser:
        browser.send("paths", count=6)
        browser.send("create", scenario=grains.data(), running=False)
        message = browser.until(lambda message, _: message.get("paths") is True)[0]
        assert message["model"]["name"] == "wang_hu"
        paths = browser.until(lambda message, fields: fields is not None and message.get("paths"))[0]["paths"]
        points = [np.reshape(path, (-1, 3)) for path in paths]
        assert len(points) >= 6
        assert all((point >= 0).all() and (point[:, :2] <= (0.32, 0.16)).all() for point in points)
        assert max(np.abs(np.diff(point[:, 0])).max() for point in points) < 0.16
        browser.send("paths", count=0)
        browser.until(lambda message, fields: fields is not None and message.get("paths") == [])


def test_a_model_without_grains_has_no_paths(served):
    with served.browser() as browser:
        browser.send("paths", count=6)
        assert browser.until_message("scenario")["paths"] is False
        browser.until_frame(lambda status: status["step"] > 5)
        assert not any(header.get("paths") for header, _ in browser.frames)


def test_what_cannot_change_is_refused_and_the_run_goes_on(served):
    with served.browser() as browser:
        step = browser.until_frame()[0]["status"]["step"]
        browser.send("set", key="model.p_s", value=7, id=2, run="a")
        refused = browser.until_message("refused", id=2)
        assert refused["problems"][0]["key"] == "model.p_s"
        browser.send("set", key="lattice.rows", value=64, id=3, run="a")
        assert "cannot change" in browser.until_message("refused", id=3)["text"]
        browser.until_frame(lambda status: status["step"] > step)


def test_a_file_that_is_refused_is_named_as_its_user_knows_it(served):
    uploads = served.folder / "studio-uploads"
    uploads.mkdir(parents=True, exist_ok=True)
    (uploads / "hill.png").write_bytes(b"no picture")
    with served.browser() as browser:
        content = {**small().data(), "ground": {"kind": "file", "path": str(uploads / "hill.png")}}
        browser.send("create", scenario=content, run="a", id=5)
        refused = browser.until_message("refused", id=5)
        assert "'hill.png': cannot be read" in refused["problems"][0]["message"]
        assert str(served.folder) not in json.dumps(refused)


def test_nonsense_is_answered_and_harms_nothing(served):
    with served.browser() as browser:
        browser.until_frame()
        for text in (
            "{",
            "[]",
            "3",
            '{"command": 5}',
            '{"command": "dance"}',
            '{"command": "stroke"}',
            '{"command": "look"}',
        ):
            browser.connection.send(text)
        browser.send("stroke", stroke={"x": "north"})
        browser.send("set", id=9)
        browser.until_message("refused", id=9)
        browser.until_frame()


def test_a_flood_of_messages_closes_the_line(served):
    with served.browser() as browser, pytest.raises(ConnectionClosed):
        browser.flood(20_000)


def test_a_killed_worker_is_message_of_and_replaced(served):
    with served.browser() as browser:
        browser.until_frame(lambda status: status["step"] > 5)
        os.kill(served.session.workers["a"].process.pid, signal.SIGKILL)
        assert browser.until_message("lost")["run"] == "a"
        browser.send("revive")
        browser.until_frame(lambda status: status["step"] > 0)
    with served.browser() as browser:
        browser.until_frame()


def test_ten_reloads_leave_one_session_and_one_worker(served):
    before = None
    for _ in range(10):
        with served.browser() as browser:
            browser.until_message("scenario")
            status = browser.until_frame()[0]["status"]
        pid = served.session.workers["a"].process.pid
        assert before is None or (pid == before[0] and status["step"] >= before[1])
        before = pid, status["step"]
    assert list(served.session.workers) == ["a"]


def test_a_second_window_takes_over(served):
    with served.browser() as first:
        first.until_frame()
        with served.browser() as second:
            second.until_frame()
            with pytest.raises(ConnectionClosed) as closed:
                first.drain(5.0)
            assert closed.value.rcvd.code == 4001


def last_halt(browser, run):
    """The step that the last frame of a run shows, 0 where it shows it running."""
    status = next(header["status"] for header, _ in reversed(browser.frames) if header["run"] == run)
    return 0 if status["running"] else status["step"]


@pytest.mark.extended
def test_two_models_run_step_by_step_on_the_same_ground(served):
    with served.browser() as browser:
        browser.until_frame()
        browser.send("compare", model="momiji")
        browser.until(lambda message, _: message.get("run") == "b" and message.get("type") == "scenario")
        browser.until(
            lambda message, _: message.get("run") == "b" and message.get("status", {}).get("step", 0) > 40
        )
        browser.send("pause")
        browser.until_message("lockstep", running=False)
        # Each shows every meeting: the last frame of one that waits there may have come before the pause did.
        while not (halted := {name: last_halt(browser, name) for name in "ab"})["a"] == halted["b"] > 40:
            browser.receive()
        seeds = {t["run"]: t["scenario"]["run"]["seed"] for t in browser.messages if t["type"] == "scenario"}
        browser.send("alone")
        browser.until_message("runs", runs=["a"])
    assert seeds["a"] == seeds["b"]


@pytest.mark.extended
def test_a_run_beside_a_changed_one_names_what_differs_from_the_scenario_that_was_loaded(served):
    with served.browser() as browser:
        browser.until_message("scenario")
        loaded = small(title="Sand", model={"hop_length": 5, "p_s": 0.6}).data()
        browser.send("create", scenario=loaded, running=False)
        browser.until_message("scenario", loaded=2)
        changed = {**loaded, "model": {**loaded["model"], "hop_length": 7, "p_s": 0.5}}
        browser.send("create", scenario=changed, running=False, changed=True, id=1)
        browser.until_message("done", id=1)
        browser.send("compare", key="model.hop_length", value=5, id=2)
        told = browser.until_message("scenario", run="b")["scenario"]
        assert told["title"] == "Sand, changed: model.p_s 0.5"


@pytest.mark.extended
def test_alone_again_leads_back_to_the_run_that_was_compared_and_both_can_be_saved(served):
    with served.browser() as browser:
        browser.until_frame(lambda status: status["step"] >= 20)
        browser.send("pause")
        before = browser.until_frame(lambda status: not status["running"])[0]["status"]["step"]
        browser.send("bookmark", bookmarks=[{"id": "m", "name": "horns"}])
        browser.send("compare", model="momiji")
        browser.until(lambda head, _: head.get("run") == "b" and head.get("status", {}).get("step", 0) > 10)
        browser.send("pause")
        for number, run in enumerate("ab"):
            browser.send("save", run=run, name=f"saved-{run}", id=number)
        saved = [browser.until_message("done")["step"] for _ in "ab"]
        browser.send("alone")
        scenario = browser.until_message("scenario", run="a", branch=1)
        after = browser.until_frame(lambda status: status["step"] == before)[0]["status"]
    assert saved[0] == saved[1]
    assert [one["name"] for one in scenario["bookmarks"]] == ["horns"]
    assert not after["running"]


def test_a_run_that_another_scenario_takes_the_place_of_is_set_aside_and_both_take_turns(served):
    with served.browser() as browser:
        browser.until_frame(lambda status: status["step"] >= 20)
        told = next(head for head in browser.messages if head.get("type") == "scenario")
        other = told["scenario"] | {"title": "The other one"}
        browser.send("create", scenario=other, aside=True, running=False, id=1)
        browser.until_message("done", id=1)
        for comes_back, kept in ((True, 20), (False, 0), (True, 20)):
            browser.send("alone")
            told = browser.until_message("scenario")["scenario"]
            assert (told["title"] != "The other one") is comes_back
            status = browser.until_frame(lambda status, kept=kept: status["live"] >= kept)[0]["status"]
            assert not status["running"]


def save_and_go_on(browser):
    """Save the run as ``saved`` and go on for some steps; both steps."""
    browser.until_frame(lambda status: status["step"] >= 20)
    browser.send("pause")
    browser.send("save", name="saved", id=1)
    saved = browser.until_message("done", id=1)["step"]
    browser.send("run", until=saved + 7)
    browser.until_frame(lambda status: status["step"] == saved + 7)
    return saved, saved + 7


def test_a_run_in_whose_place_a_saved_one_is_opened_is_set_aside_and_both_take_turns(served):
    with served.browser() as browser:
        saved, before = save_and_go_on(browser)
        browser.send("open", name="saved", id=2)
        assert browser.until_message("done", id=2)["aside"] == ""
        for number, step in enumerate((before, saved), start=3):
            browser.send("alone", id=number)
            assert browser.until_message("done", id=number)["aside"] == ""
            browser.until_frame(lambda status, step=step: status["live"] == step)
        browser.send("open", name="none", id=9)
        browser.until_message("refused", id=9)
        browser.send("alone", id=10)
        browser.until_frame(lambda status: status["live"] == before)


@pytest.mark.extended
def test_a_saved_run_that_is_opened_from_two_sets_the_one_before_them_aside(served):
    with served.browser() as browser:
        _, before = save_and_go_on(browser)
        browser.send("compare", model="momiji")
        browser.until(lambda head, _: head.get("run") == "b" and head.get("status", {}).get("step", 0) > 10)
        browser.send("open", name="saved", id=2)
        assert browser.until_message("done", id=2)["aside"] == ""
        assert list(served.session.workers) == ["a"]
        browser.send("alone", id=3)
        told = browser.until_message("scenario", run="a", step=before)
        assert len(told["branches"]) == 2


def test_another_scenario_opened_from_two_values_runs_alone_and_the_one_before_them_comes_back(served):
    other = small(title="Another", model={"hop_length": 3}).data()
    with served.browser() as browser:
        browser.until_frame(lambda status: status["step"] >= 20)
        browser.send("compare", key="model.hop_length", value=10, id=1)
        browser.until(lambda head, _: head.get("run") == "b" and head.get("status", {}).get("step", 0) > 10)
        refused = {**other, "lattice": {**other["lattice"], "rows": 10**7, "columns": 10**7}}
        browser.send("create", scenario=refused, aside=True, run="b", id=2)
        browser.until_message("refused", id=2)
        assert list(served.session.workers) == ["a", "b"]
        browser.send("create", scenario=other, aside=True, run="b", id=3)
        browser.until_message("runs", runs=["a"])
        assert served.session.scenarios == {"a": other}
        status = browser.until_frame(lambda status: status["step"] >= 20)[0]["status"]
        assert status["running"]
        browser.send("alone", back=True, id=4)
        assert len(browser.until_message("scenario", run="a")["branches"]) == 2
        assert list(served.session.workers) == ["a"]


@pytest.mark.extended
def test_a_change_of_one_of_two_begins_both_again_each_with_its_own_model(served):
    with served.browser() as browser:
        browser.until_frame()
        browser.send("compare", key="model.hop_length", value=10, id=1)
        browser.until_message("done", id=1)
        right = served.session.scenarios["b"]
        larger = {**right, "lattice": {**right["lattice"], "rows": 40}}
        browser.send("create", scenario=larger, changed=True, run="b", id=2)
        browser.until_message("done", id=2)
        while (left := served.session.scenarios["a"])["lattice"]["rows"] != 40:
            browser.receive()
        assert left["model"]["hop_length"] == 5
        assert list(served.session.workers) == ["a", "b"]


def test_two_scenarios_that_are_started_together_run_in_lockstep_and_leave_the_run_before_set_aside(served):
    with served.browser() as browser:
        browser.until_frame()
        first = served.session.scenarios["a"]
        other = {**first, "title": "Other", "model": {**first["model"], "hop_length": 9}}
        browser.send("create", scenario=first, beside=other, running=True, aside=True, id=1)
        assert browser.until_message("done", id=1)["aside"] == first["title"]
        browser.until(lambda head, _: head.get("run") == "b" and head.get("status", {}).get("step", 0) > 4)
        assert [one["model"]["hop_length"] for one in served.session.scenarios.values()] == [5, 9]
        assert served.session.lockstep.running
        browser.send("create", scenario=first, beside={**other, "lattice": {"rows": -1}}, aside=True, id=2)
        assert browser.until_message("refused", id=2)["problems"]
        assert list(served.session.workers) == ["a", "b"]
        browser.send("alone", back=True, id=3)
        browser.until_message("done", id=3)
        assert list(served.session.workers) == ["a"]


@pytest.mark.extended
def test_two_that_are_opened_run_to_their_scenarios_end_and_leave_the_run_before_set_aside(served):
    with served.browser() as browser:
        browser.until_frame()
        browser.send("compare", key="model.p_s", value=0.9)
        browser.until(lambda head, _: head.get("run") == "b" and head.get("status", {}).get("step", 0) > 10)
        browser.send("pause")
        browser.send("save", name="pair", id=1)
        saved = browser.until_message("done", id=1)["step"]
        browser.send("alone", id=2)
        browser.until_message("done", id=2)
        browser.send("run", until=90)
        browser.until_frame(lambda status: status["step"] == 90)
        browser.send("open", name="pair", id=3)
        done = browser.until_message("done", id=3)
        assert (done["step"], done["aside"]) == (saved, "")
        browser.send("run")
        browser.until_message("lockstep", running=True)
        browser.until_message("lockstep", running=False)
        while not last_halt(browser, "a") == last_halt(browser, "b") == 100:
            browser.receive()
        browser.send("alone", id=4)
        assert browser.until_message("done", id=4)["stays"]
        assert list(served.session.workers) == ["a"]
        browser.send("alone", id=5)
        browser.until_frame(lambda status: status["live"] == 90)


def test_the_line_needs_token_host_and_origin(served):
    for options in (
        {"additional_headers": {"Host": "evil.example"}},
        {"origin": "http://evil.example"},
        {"origin": f"http://127.0.0.1:{served.port + 1}"},
    ):
        with pytest.raises(InvalidStatus), served.connection(**options):
            pass
    with served.connection(origin=served.address):
        pass
    with served.connection(token="guess") as connection, pytest.raises(ConnectionClosed) as closed:
        connection.recv(timeout=10)
    assert closed.value.rcvd.code == NOT_ALLOWED  # a code that the page can read


def test_the_http_interface_needs_the_token_and_this_servers_name(served):
    token = {"x-barchan-token": served.guard.token}
    for path in ("presets", "schema", "colours", "pictures/barchans"):
        assert httpx.get(f"{served.address}/api/{path}", trust_env=False).status_code == 403
    assert (
        httpx.get(f"{served.address}/api/schema", headers={**token, "host": "evil.example"}).status_code
        == 421
    )
    answer = httpx.get(f"{served.address}/api/schema", headers=token, trust_env=False)
    assert "hop_length" in answer.text
    assert "default-src 'self'" in answer.headers["content-security-policy"]


def test_uploads_are_data_of_limited_size_with_plain_names(served):
    def upload(name: str, content: bytes) -> httpx.Response:
        headers = {"x-barchan-token": served.guard.token}
        url = f"{served.address}/api/upload"
        return httpx.post(url, params={"name": name}, content=content, headers=headers, trust_env=False)

    good = upload("hill.npy", b"0123")
    assert good.status_code == 200
    assert good.json()["path"] == str(served.folder / "studio-uploads" / "hill.npy")
    beside = upload("../hill.npy", b"0").json()["path"]
    assert beside == str(served.folder / "studio-uploads" / "hill-2.npy")
    assert upload("hill.py", b"0").status_code == 400
    assert upload("hill.npy", bytes(LARGEST_UPLOAD + 1)).status_code == 413
    kept = sorted(path.name for path in (served.folder / "studio-uploads").iterdir())
    assert kept == ["hill-2.npy", "hill.npy"]


def test_an_upload_that_was_refused_is_deleted_unless_it_was_sent_before(served):
    uploads = served.folder / "studio-uploads"

    def ask(method: str, name: str, content: bytes = b"") -> httpx.Response:
        headers = {"x-barchan-token": served.guard.token}
        url = f"{served.address}/api/upload"
        return httpx.request(
            method, url, params={"name": name}, content=content, headers=headers, trust_env=False
        )

    for content in (b"1", b"2"):
        ask("POST", "my hill.npy", content)
    ask("POST", "my hill.npy", b"1")
    (uploads / "older.npy").write_bytes(b"3")
    for name in ("my-hill.npy", "my-hill-2.npy", "older.npy", "../scenario.json", "none.npy"):
        assert ask("DELETE", name).status_code == 200
    assert sorted(path.name for path in uploads.iterdir()) == ["my-hill.npy", "older.npy"]
    assert httpx.delete(f"{served.address}/api/upload?name=my-hill.npy", trust_env=False).status_code == 403


def test_a_scenario_from_the_browser_opens_no_file_beyond_the_folder(served, scenario, tmp_path):
    data = {**scenario.data(), "ground": {"kind": "file", "path": "/etc/passwd.npy"}}
    with served.browser() as browser:
        browser.until_frame()
        browser.send("create", scenario=data, id=4)
        assert browser.until_message("refused", id=4)["problems"][0]["key"] == "ground.path"
        for name in ("../x", "/tmp/x", "a/b", ""):
            browser.send("save", name=name, id=5)
            assert "cannot be a run's name" in browser.until_message("refused", id=5)["text"]


def test_a_wind_from_the_browser_opens_no_file_beyond_the_folder(served):
    with served.browser() as browser:
        browser.until_frame()
        browser.send("wind", wind={"kind": "record", "path": "/etc/passwd"}, id=4, run="a")
        assert browser.until_message("refused", id=4)["problems"][0]["key"] == "wind.path"


def test_a_recorded_wind_has_its_roses(served):
    clock = {"grain_diameter": 0.00025, "reference_speed": 8}
    recorded = small(wind={"kind": "record"}, clock=clock)
    with served.browser() as browser:
        browser.until_frame()
        browser.send("rose", run="a", id=1)
        assert browser.until_message("done", id=1)["rose"]["days"] is None
        browser.send("create", scenario=recorded.data(), running=False)
        browser.until(lambda message, _: message.get("scenario", {}).get("wind", {}).get("kind") == "record")
        browser.send("rose", run="a", id=2)
        rose = browser.until_message("done", id=2)["rose"]
    record = recorded.wind.record
    assert np.sum(rose["shares"]) + rose["calms"] == pytest.approx(1.0)
    assert np.shape(rose["shares"]) == (16, len(rose["limits"]) + 1)
    assert rose["days"] == pytest.approx(record.seconds / 86_400)
    assert len(rose["sand"]) == 16
    assert 0 <= rose["crest"] < 180


def test_a_broken_scenario_names_every_bad_key_and_what_is_left(served):
    text = (
        '{\n"barchan": 5,\n"model": {"name": "werner", "hop_lenght": 3, "p_s": 0.5},\n"sand": {"mean": -1}\n}'
    )
    with served.browser() as browser:
        browser.send("check", name="mine.json", text=text, id=6)
        answer = browser.until_message("done", id=6)
    assert [problem["key"] for problem in answer["problems"]] == ["sand.mean", "model.hop_lenght"]
    assert "mine.json:3" in [problem["place"] for problem in answer["problems"]]
    assert answer["scenario"]["model"]["p_s"] == 0.5


def test_a_run_is_saved_and_opened_again(served):
    with served.browser() as browser:
        browser.until_frame(lambda status: status["step"] > 35)
        browser.send("pause")
        status = browser.until_frame(lambda status: not status["running"])[0]["status"]
        browser.send("save", name="mine", id=1)
        assert browser.until_message("done", id=1)["step"] == status["step"]
    with serving(served.folder, archive=served.folder / "mine") as again, again.browser() as browser:
        header = browser.until_frame()[0]
        assert header["status"]["step"] == status["step"]
        assert header["history"][:3] == [0, 10, 20]
        browser.send("look", step=20)
        assert not browser.until_frame(lambda status: status["looking"])[0]["status"]["can_branch"]


def test_a_scenario_can_start_with_a_ground_of_its_own_file(tmp_path):
    path = tmp_path / "elsewhere" / "ground.npy"
    path.parent.mkdir()
    np.save(path, np.zeros((32, 48)))
    mine = small(ground={"kind": "file", "path": str(path)})
    with serving(tmp_path / "folder", mine) as server, server.browser() as browser:
        message = browser.until_message("scenario")
        browser.send("create", scenario=message["scenario"], id=1)
        browser.until_message("scenario")


def test_the_same_model_beside_begins_with_the_values_of_the_first(tmp_path):
    scenario = small(model={"name": "werner", "p_s": 0.3})
    with serving(tmp_path, scenario) as served, served.browser() as browser:
        browser.until_frame()
        browser.send("compare", model="werner", id=3)
        browser.until(lambda message, _: message.get("run") == "b" and message.get("type") == "scenario")
        second = browser.messages[-1]["scenario"]
        assert second["model"]["p_s"] == 0.3


def test_a_stroke_stamps_every_one_of_its_places(served):
    with served.browser() as browser:
        message = browser.until_message("scenario")
        browser.send("pause")
        before = browser.until_frame(lambda status: not status["running"])[0]["status"]["volume"]
        sand = {**message["brushes"][0]["stroke"], "radius": 0.6, "amount": 4, "falloff": "none"}
        browser.send("stroke", begin=True, end=True, stroke=sand, places=[[10.5, 8.5], [30.5, 20.5]], id=5)
        status = browser.until_frame(lambda status: status["undo"] == 1)[0]["status"]
    assert status["volume"] - before == pytest.approx(
        2 * 4 / 3
    )  # two cells of 1 m², slabs of a third of a metre


def test_a_run_is_not_saved_under_a_name_in_use(served):
    (served.folder / "mine").mkdir()
    (served.folder / "mine" / "notes.txt").write_text("kept")
    with served.browser() as browser:
        browser.until_frame()
        browser.send("save", name="mine", id=5)
        refused = browser.until_message("refused", id=5)["text"]
    assert "'mine' is in use" in refused
    assert "--" not in refused
