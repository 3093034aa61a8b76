"""What leaves the page: distances, pictures, the section over time, the report of two runs."""

import io
import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from barchan.scenario import load_scenario
from tests.studio.browser.test_truth import LISTEN

PLANE = {
    "lattice.rows": "48",
    "lattice.columns": "64",
    "lattice.cell_size": "1",
    "ground": json.dumps({"kind": "ramp", "height": 16.0}),
    "sand": json.dumps({"kind": "flat", "mean": 0}),
    "run.seed": "3",
    "title": json.dumps("A plane"),
}
"""Ground that rises to the east by 16 m in 64 m, without sand."""


def show_plane(studio):
    scenario = load_scenario("barchans", list(PLANE.items())).data()
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    studio.until("window.barchan.app.runs[0].ready && window.barchan.app.runs[0].surface[63] > 15")


def measured(page):
    names, values = page.locator(".ruler th").all_inner_texts(), page.locator(".ruler td").all_inner_texts()
    return dict(zip(names, values, strict=True))


def test_the_ruler_measures_a_plane_between_two_places_by_keys_and_by_mouse(studio):
    """32 m east, 24 m north are 40 m (3-4-5); 1 in 4 to the east is 8 m: 11.31°, sqrt(40² + 8²) m long."""
    show_plane(studio)
    page = studio.page
    page.keyboard.press("m")
    for number in ("8.5", "10.5", "40.5", "34.5"):
        page.keyboard.type(number)
        page.keyboard.press("Tab")
    assert measured(page) == {
        "distance": "40 m",
        "height difference": "8 m",
        "along the surface": "40.79 m",
        "slope": "11.31°",
        "azimuth": "53.13°",
    }
    studio.ask("window.barchan.stage.look('top')")
    red = studio.picture()
    assert ((red[..., 0] > 120) & (red[..., 1] < 60) & (red[..., 2] < 60)).sum() > 100
    studio.drag((0.7, 0.7), (0.5, 0.7))
    azimuth = float(measured(page)["azimuth"].rstrip("°"))
    assert azimuth == pytest.approx(270.0, abs=0.5)
    assert measured(page)["height difference"].startswith("-")
    page.locator(".ruler input").first.press("Escape")
    assert page.locator(".ruler").is_hidden()


@pytest.mark.extended
def test_messages_leave_the_scene_to_the_ruler(studio):
    show_plane(studio)
    page = studio.page
    studio.ask("window.barchan.app.note('error', 'Something was refused.')")
    toast = page.locator(".toast.error", has_text="Something was refused.")
    scene = page.locator(".scene").bounding_box()
    assert toast.bounding_box()["y"] < scene["y"] + scene["height"] / 2
    page.keyboard.press("m")
    studio.picture()
    page.screenshot(path=studio.folder / "ruler-and-messages.png")
    measuring = page.locator(".scene").bounding_box()
    for message in page.locator(".messages").locator(".toast, .notice").all():
        if message.is_visible():
            assert message.bounding_box()["y"] >= measuring["y"] + measuring["height"]
    assert measuring["height"] > scene["height"] / 2
    toast.get_by_role("button", name="Dismiss").click()
    page.keyboard.press("m")
    page.locator(".ruler").wait_for(state="hidden")
    assert page.locator(".scene").bounding_box() == scene


@pytest.mark.extended
def test_the_ruler_leaves_the_middle_of_the_field_free(studio):
    """At 1280 × 720 with a view open below: what is at the middle of the scene is the scene."""
    page = studio.page
    page.set_viewport_size({"width": 1280, "height": 720})
    show_plane(studio)
    page.keyboard.press("1")
    page.keyboard.press("m")
    for number in ("8.5", "10.5", "40.5", "34.5"):
        page.keyboard.type(number)
        page.keyboard.press("Tab")
    ruler, scene = page.locator(".ruler").bounding_box(), page.locator(".scene").bounding_box()
    assert ruler["y"] + ruler["height"] < scene["y"] + scene["height"] / 3
    page.screenshot(path=studio.folder / "ruler-low.png")


@pytest.mark.extended
def test_two_clicks_measure_as_a_drag_does(studio):
    show_plane(studio)
    page = studio.page
    studio.ask("window.barchan.stage.look('top')")
    page.keyboard.press("m")
    page.locator(".ruler input").first.evaluate("(input) => input.blur()")
    studio.picture()  # the view has come to rest
    studio.drag((0.5, 0.7), (0.5, 0.7))
    assert page.locator(".ruler .hint").is_visible()
    assert [box.input_value() != "" for box in page.locator(".ruler input").all()] == [
        True,
        True,
        False,
        False,
    ]
    assert measured(page) == {}  # one place is no distance
    studio.drag((0.7, 0.7), (0.7, 0.7))
    assert page.locator(".ruler .hint").is_hidden()
    assert float(measured(page)["azimuth"].rstrip("°")) == pytest.approx(90.0, abs=0.5)


def open_sheet(page, name):
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name=name).click()
    return page.get_by_role("dialog")


def saved_picture(page, sheet):
    with page.expect_download() as download:
        sheet.get_by_role("button", name="save PNG").click()
    return np.asarray(Image.open(download.value.path()).convert("RGB")).astype(float)


@pytest.mark.extended
def test_a_picture_goes_on_across_the_seams_of_its_tiles(studio):
    """Of 700 × 540 pixels in tiles of at most 512: beside each seam neighbours differ as elsewhere."""
    studio.step_beyond(60)
    studio.pause()
    coded = studio.ask(
        """window.barchan.stage.render({ width: 700, height: 540 }).then((blob) => blob.arrayBuffer())
            .then((buffer) => Array.from(new Uint8Array(buffer)))"""
    )
    picture = np.asarray(Image.open(io.BytesIO(bytes(coded))).convert("RGB")).astype(float)
    assert picture.shape == (540, 700, 3)
    for along, across in ((1, 0), (0, 1)):
        steps = np.abs(np.diff(picture, axis=along)).mean(axis=(across, 2))
        assert steps[511] < 2 * np.median(steps[500:524])


@pytest.mark.extended
def test_a_picture_has_the_size_and_the_words_that_are_asked_for(studio):
    show_plane(studio)
    page = studio.page
    sheet = open_sheet(page, "Picture with title")
    studio.ask(LISTEN)
    sheet.get_by_label("Size").select_option("free")
    sheet.get_by_label("Width (pixels)").fill("640")
    sheet.get_by_label("Height (pixels)").fill("360")
    assert saved_picture(page, sheet).shape == (360, 640, 3)
    words = studio.ask("window.words")
    version = studio.ask("window.barchan.app.version")
    assert "A plane" in words
    assert f"step 0 · seed 3 · Barchan {version}" in words
    assert any(str(word).endswith("m · heights to scale") or "heights ×" in str(word) for word in words)


@pytest.mark.extended
def test_a_picture_has_a_title_of_ones_own_which_the_next_one_keeps(studio):
    show_plane(studio)
    page = studio.page
    sheet = open_sheet(page, "Picture with title")
    assert sheet.get_by_label("Title", exact=True).input_value() == "A plane"
    sheet.get_by_label("Title", exact=True).fill("A ramp to the east")
    studio.ask(LISTEN)
    saved_picture(page, sheet)
    words = studio.ask("window.words")
    assert "A ramp to the east" in words
    assert "A plane" not in words
    sheet.wait_for(state="detached")
    sheet = open_sheet(page, "Picture with title")
    assert sheet.get_by_label("Title", exact=True).input_value() == "A ramp to the east"


@pytest.mark.extended
def test_the_section_over_time_is_saved_as_table_and_picture(studio):
    studio.step_beyond(45)
    studio.pause()
    page = studio.page
    page.keyboard.press("3")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save the elevations").click()
    head, *rows = Path(download.value.path()).read_text().splitlines()
    assert head.split(",")[:2] == ["step", "0.0000"]
    assert [int(row.split(",")[0]) for row in rows[:5]] == [0, 10, 20, 30, 40]
    with page.expect_download() as download:
        page.get_by_role("button", name="Save a picture with colour bar").click()
    with Image.open(download.value.path()) as picture:
        assert picture.size == (1440, 1000)


@pytest.mark.extended
def test_the_report_of_two_runs_is_broken_off_and_written(studio):
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 20")
    studio.pause()
    page = studio.page
    sheet = open_sheet(page, "Comparison report")
    sheet.get_by_role("button", name="write the report").click()
    sheet.get_by_role("button", name="cancel").click()
    sheet.get_by_text("Broken off").wait_for()
    with page.expect_download(timeout=120_000) as download:
        sheet.get_by_role("button", name="write the report").click()
    text = Path(download.value.path()).read_text("utf-8")
    assert "werner" in text
    assert "momiji" in text
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


@pytest.mark.extended
def test_charts_are_tall_enough_to_read_also_of_two_runs(studio):
    """What is below the drawer's edge is scrolled to."""
    studio.pause()
    studio.page.set_viewport_size({"width": 1280, "height": 720})
    studio.page.keyboard.press("2")
    heights = "[...document.querySelectorAll('.u-over')].map((plot) => plot.clientHeight)"
    studio.until(f"{heights}.length >= 5")
    assert min(studio.ask(heights)) >= 90
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].ready")
    studio.until("document.querySelectorAll('.run-names > span').length === 2")
    assert min(studio.ask(heights)) >= 90
    studio.page.screenshot(path=studio.folder / "charts-of-two.png")
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")
    studio.page.keyboard.press("2")


@pytest.mark.extended
def test_a_lost_graphics_card_is_said_and_the_picture_comes_back(studio):
    studio.pause()
    before = studio.picture().std()
    assert before > 5
    studio.ask("window.barchan.stage.renderer.forceContextLoss()")
    notice = studio.page.locator(".notice", has_text="taken the graphics card away")
    notice.wait_for()
    studio.page.get_by_role("button", name="One step").click()  # the run goes on unseen
    studio.until("window.barchan.app.runs[0].status.running === false")
    studio.ask("window.barchan.stage.renderer.forceContextRestore()")
    notice.wait_for(state="hidden")
    assert studio.picture().std() == pytest.approx(before, rel=0.2)
    studio.errors[:] = [said for said in studio.errors if "Context Lost" not in said]
