"""Films of the scene: of kept states by the studio's own camera, and recorded while the run goes on."""

import io
import json
import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from barchan.scenario import load_scenario
from tests.studio.browser.conftest import SMALL

RUN = "window.barchan.app.runs[0]"


def open_sheet(page, name):
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name=name).click()
    return page.get_by_role("dialog")


def pictures_of(path, suffix):
    """The pictures of a film, as another library reads them."""
    if suffix == ".webp":
        with Image.open(path) as film:
            return [np.asarray(frame.convert("RGB")) for frame in _frames(film)]
    av = pytest.importorskip("av")
    with av.open(str(path)) as film:
        return [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]


def _frames(film):
    for at in range(film.n_frames):
        film.seek(at)
        yield film


def keep(path, name):
    """Keep a film to look at, where a folder for that is stated."""
    if folder := os.environ.get("BARCHAN_LOOK"):
        shutil.copy(path, Path(folder) / name)


@pytest.mark.extended
def test_a_film_of_kept_states_is_drawn_by_the_camera_of_the_scene(studio):
    page = studio.page
    studio.step_beyond(60)
    studio.ask("window.barchan.stage.turn(0.2, 0)")
    before = studio.ask("window.barchan.stage.standpoint()")
    sheet = open_sheet(page, "Film of what was just seen")
    sheet.get_by_label("States of the film, the last ones").fill("4")
    sheet.get_by_label("Degrees that the camera turns").fill("30")
    with page.expect_download(timeout=120_000) as download:
        sheet.get_by_role("button", name="write the film").click()
    suffix = Path(download.value.suggested_filename).suffix
    path = download.value.path()
    keep(path, f"states{suffix}")
    pictures = pictures_of(path, suffix)
    assert [picture.shape for picture in pictures] == [(720, 1280, 3)] * 4
    turned = np.abs(pictures[0].astype(float) - pictures[-1]).mean()
    assert turned > 5
    after = studio.ask("window.barchan.stage.standpoint()")
    assert after["position"] == pytest.approx(before["position"], abs=1e-6)
    studio.until("window.barchan.app.running")
    assert list((studio.folder / "studio-exports").rglob(f"barchans{suffix}"))


OUT = """(() => {
    const { stage, app } = window.barchan;
    const shoot = stage.shoot.bind(stage);
    window.farthest = [];
    stage.shoot = async (options) => {
        const shot = await shoot(options);
        const camera = stage.camera.clone();
        camera.aspect = options.width / options.height;
        camera.updateProjectionMatrix();
        camera.updateMatrixWorld();
        const { min, max } = stage.terrain(app.runs[0]).box();
        for (const x of [min.x, max.x]) for (const y of [min.y, max.y]) for (const z of [min.z, max.z])
            window.farthest.push(Math.abs(min.clone().set(x, y, z).project(camera).x));
        return shot;
    };
})()"""
"""Note for each picture how far aside the corners of the field lie, as shares of half its width."""


@pytest.mark.extended
def test_a_field_that_fills_a_wide_window_is_whole_in_a_film(studio):
    page = studio.page
    page.set_viewport_size({"width": 1600, "height": 520})
    wide = {**SMALL, "lattice.rows": "24", "lattice.columns": "96"}
    scenario = {**load_scenario("barchans", list(wide.items())).data(), "title": "Wide"}
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    studio.until(f"{RUN}.ready && {RUN}.rows === 24")
    studio.ask("window.barchan.app.send({ command: 'run', until: 20 })")
    studio.until(f"{RUN}.status.step === 20 && !window.barchan.app.running")
    studio.ask("window.barchan.app.view.set({ turning: false })")
    studio.picture()
    studio.ask("window.barchan.stage.turn(0.01, 0, 0.9)")
    before = studio.ask("window.barchan.stage.standpoint()")
    studio.ask(OUT)
    sheet = open_sheet(page, "Film of what was just seen")
    sheet.get_by_label("States of the film, the last ones").fill("2")
    with page.expect_download(timeout=120_000):
        sheet.get_by_role("button", name="write the film").click()
    farthest = studio.ask("window.farthest")
    assert len(farthest) == 16
    assert max(farthest) < 1
    studio.until("!window.barchan.stage.steady")
    assert studio.ask("window.barchan.stage.standpoint()")["position"] == pytest.approx(before["position"])


@pytest.mark.extended
@pytest.mark.parametrize(("kept", "states", "rate"), [(16, 16, 4), (100, 100, 10), (400, 300, 30)])
def test_a_film_is_proposed_to_last_ten_seconds_where_enough_states_are_kept(studio, kept, states, rate):
    """Of 16 states it lasts 4 s: fewer than 4 pictures a second are no film."""
    studio.pause()
    step = studio.status()["step"]
    studio.ask(
        f"void ({RUN}.history = Array.from({{ length: {kept - 1} }}, (_, at) => at - {kept} + {step}))"
    )
    sheet = open_sheet(studio.page, "Film of what was just seen")
    assert sheet.get_by_label("States of the film, the last ones").input_value() == str(states)
    assert sheet.get_by_label("Frames a second").input_value() == str(rate)
    assert f"a film of {states // rate} s" in sheet.get_by_role("status").inner_text()
    sheet.get_by_label("Frames a second").fill("2")
    assert f"a film of {states // 2} s" in sheet.get_by_role("status").inner_text()


@pytest.mark.extended
def test_a_film_that_is_broken_off_leaves_nothing_and_the_run_as_it_was(studio):
    page = studio.page
    studio.step_beyond(60)
    studio.pause()
    stood = studio.status()["step"]
    sheet = open_sheet(page, "Film of what was just seen")
    sheet.get_by_label("Name of the file").fill("given-up")
    sheet.get_by_role("button", name="write the film").click()
    sheet.get_by_role("button", name="cancel").click()
    sheet.get_by_text("Broken off").wait_for()
    studio.until(f"{RUN}.status.step === {stood} && !{RUN}.status.looking")
    assert list((studio.folder / "studio-exports").rglob("given-up*")) == []
    assert not studio.ask("window.barchan.stage.steady")


FRAMES_SEEN = """(() => {
    const { app, stage } = window.barchan;
    window.unlike = [];
    window.seen = 0;
    const look = () => {
        const tiled = stage.canvas.width < stage.host.clientWidth;
        const covered = document.querySelector(".scene canvas[aria-hidden]") !== null;
        const names = document.querySelector(".names").textContent;
        const step = document.querySelector("[data-status=step]").textContent;
        if (tiled && !covered) window.unlike.push("a tile is seen");
        if (tiled && !names.includes(`step ${step}`)) window.unlike.push(`${names}, not ${step}`);
        window.seen += tiled;
        requestAnimationFrame(look);
    };
    look();
})()"""


@pytest.mark.extended
def test_while_a_film_of_two_runs_is_drawn_the_scene_stays_whole_and_says_how_far_it_is(studio):
    page = studio.page
    studio.ask("window.barchan.app.ask({ command: 'compare', key: 'model.hop_length', value: 10 })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 60")
    studio.pause()
    sent = []
    page.on("request", lambda request: request.method == "POST" and sent.append(request.url))
    sheet = open_sheet(page, "Film of what was just seen")
    sheet.get_by_label("States of the film, the last ones").fill("5")
    sheet.get_by_label("Name of the file").fill("pair")
    studio.ask(FRAMES_SEEN)
    sheet.get_by_role("button", name="write the film").click()
    sheet.get_by_text("picture 1 of 5").wait_for()
    sheet.get_by_text("picture 2 of 5").wait_for(timeout=120_000)
    sheet.get_by_role("button", name="cancel").click()
    sheet.get_by_text("Broken off").wait_for()
    assert sum("/films/" in url for url in sent) < 5
    assert studio.ask("window.unlike") == []
    assert studio.ask("window.seen") > 0
    assert page.locator(".scene canvas[aria-hidden]").count() == 0
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


def begin_recording(studio):
    studio.page.keyboard.press("v")
    studio.page.get_by_role("button", name="begin", exact=True).click()
    studio.page.get_by_text("recording 0:").wait_for()


def record_some(studio):
    """Record the scene until some pictures of it were drawn."""
    begin_recording(studio)
    drawn = studio.ask("window.barchan.stage.drawn")
    studio.until(f"window.barchan.stage.drawn > {drawn + 8}")


@pytest.mark.extended
def test_the_scene_is_recorded_while_it_runs(studio):
    page = studio.page
    record_some(studio)
    with page.expect_download() as download:
        page.get_by_role("button", name="stop and save").click()
    suffix = Path(download.value.suggested_filename).suffix
    path = download.value.path()
    keep(path, f"recorded{suffix}")
    pictures = pictures_of(path, suffix)
    assert len(pictures) > 1
    assert pictures[-1].std() > 10
    assert np.abs(pictures[0].astype(float) - pictures[-1]).max() > 5
    assert page.get_by_role("group", name="Recording").is_hidden()


BOXES = """() => {
    const box = (element) => element.getBoundingClientRect();
    const shown = (one) => one.checkVisibility();
    const [messages, scene] = [".messages", ".scene"].map((name) => box(document.querySelector(name)));
    const within = (one) => [
        Math.max(one.left, messages.left), Math.max(one.top, messages.top),
        Math.min(one.right, messages.right), Math.min(one.bottom, messages.bottom),
    ];
    const all = (names) => [...document.querySelectorAll(names)].filter(shown).map(box);
    const sides = ({ left, top, right, bottom }) => [left, top, right, bottom];
    return {
        scene: sides(scene),
        tools: all(".ruler, .recording, .timeline, .dock, .panel, .bar").map(sides),
        ruler: all(".ruler").map(sides),
        messages: all(".toast").map(within).filter((one) => one[0] < one[2] && one[1] < one[3]),
    };
}"""
"""Sides (left, top, right, bottom) of what is seen on the page; of scrolled messages their visible parts."""


def overlap(one: list[float], other: list[float]) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


@pytest.mark.extended
@pytest.mark.parametrize("size", [(1280, 720), (1600, 1000), (1024, 700)])
def test_messages_ruler_and_bar_of_a_recording_never_lie_over_one_another(studio, size):
    """With as many messages as are shown at once, with and without the ruler, a recording and the section."""
    page = studio.page
    page.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
    studio.pause()
    for recording in (False, True):
        if recording:
            begin_recording(studio)
        for dock in (False, True):
            if dock:
                page.keyboard.press("1")
            for ruler in (False, True):
                if ruler:
                    page.keyboard.press("m")
                empty = page.evaluate(BOXES)
                for number in range(5):
                    text = (
                        f"Refusal {number}: " + "a value that the model does not allow, with its reason. " * 2
                    )
                    studio.ask(f"window.barchan.app.note('error', '{text}')")
                seen = page.evaluate(BOXES)
                case = f"{recording=}, {dock=}, {ruler=}"
                assert seen["messages"], case
                tools = seen["tools"]
                pairs = [(one, other) for one in seen["messages"] for other in tools]
                pairs += [(one, other) for at, one in enumerate(tools) for other in tools[:at]]
                assert [pair for pair in pairs if overlap(*pair)] == [], case
                for _, top, _, bottom in seen["ruler"]:
                    assert seen["scene"][1] <= top, case
                    assert bottom <= seen["scene"][3], case
                if recording:
                    assert seen["scene"] == empty["scene"], case
                studio.ask("window.barchan.app.notices.dismissAll()")
                if ruler:
                    page.locator(".ruler input").first.press("Escape")
            if dock:
                page.keyboard.press("1")
    page.get_by_role("button", name="discard").click()


@pytest.mark.extended
def test_a_recording_that_begins_under_messages_has_the_shape_of_the_scene(studio):
    page = studio.page
    studio.pause()
    page.keyboard.press("m")
    page.locator(".ruler input").first.evaluate("(input) => input.blur()")
    studio.ask("window.barchan.app.note('error', 'Something was refused.')")
    begin_recording(studio)
    width, height = studio.ask(
        "(({ width, height }) => [width, height])(window.barchan.files.recorder.canvas)"
    )
    scene = page.locator(".scene").bounding_box()
    assert width / height == pytest.approx(scene["width"] / scene["height"], rel=0.01)
    page.get_by_role("button", name="discard").click()
    page.keyboard.press("m")


@pytest.mark.extended
def test_a_browser_that_cannot_record_says_so(studio):
    studio.ask("void delete window.MediaRecorder")
    studio.page.keyboard.press("v")
    studio.page.locator(".toast", has_text="cannot record what it draws").wait_for()


@pytest.mark.extended
def test_reading_a_file_is_broken_off_and_the_run_stays_as_it_was(studio, tmp_path):
    """Points on a grid as text, some 20 MB, which take seconds to read."""
    page = studio.page
    side = 1000
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    table = io.StringIO()
    np.savetxt(table, np.stack([x.ravel(), y.ravel(), (x % 50).ravel()], axis=1), fmt="%.3f")
    (tmp_path / "points.xyz").write_text(table.getvalue())
    before = studio.ask(f"{RUN}.description.scenario.ground")
    page.locator("summary", has_text="File").click()
    with page.expect_file_chooser() as chooser:
        page.get_by_role("menuitem", name="Load a scenario").click()
    chooser.value.set_files(tmp_path / "points.xyz")
    sheet = page.get_by_role("dialog", name="Reading points.xyz")
    sheet.get_by_role("button", name="cancel").click()
    sheet.wait_for(state="detached")
    assert studio.ask(f"{RUN}.description.scenario.ground") == before
    stood = studio.status()["step"]
    studio.step_beyond(stood + 2)
    assert page.locator(".toast.error").count() == 0


@pytest.mark.extended
def test_escape_ends_a_recording_and_saves_it_and_says_how_long_it_is(studio):
    page = studio.page
    record_some(studio)
    with page.expect_download() as download:
        page.keyboard.press("Escape")
    assert download.value.path().stat().st_size > 0
    studio.until_logged(f"saved as {download.value.suggested_filename}, 0:")
    assert page.get_by_role("group", name="Recording").is_hidden()


@pytest.mark.extended
def test_escape_while_a_film_is_written_asks_before_it_breaks_anything_off(studio):
    """Escape pressed again and again loses nothing: it asks, and takes the question back."""
    page = studio.page
    studio.step_beyond(60)
    studio.pause()
    sheet = open_sheet(page, "Film of what was just seen")
    sheet.get_by_label("Name of the file").fill("escaped")
    sheet.get_by_role("button", name="write the film").click()
    sheet.get_by_role("button", name="cancel").wait_for()
    question = sheet.get_by_role("alertdialog", name="Break it off?")
    for asked in (True, False, True):
        page.keyboard.press("Escape")
        assert question.is_visible() == asked
        assert sheet.get_by_role("button", name="cancel").is_visible()
    sheet.get_by_role("button", name="Close").click()
    assert question.is_hidden()
    page.mouse.click(5, 300)
    assert question.is_visible()
    question.get_by_role("button", name="break it off").click()
    sheet.get_by_text("nothing was written").wait_for()
    assert question.is_hidden()
    page.keyboard.press("Escape")
    sheet.wait_for(state="detached")
    assert list((studio.folder / "studio-exports").rglob("escaped*")) == []
