"""Work on the page: brushes, files, defaults, comparisons, what was stored by another version."""

import io
import json

import numpy as np
import pytest
from PIL import Image

from tests.studio.browser.test_messages import fill

RUN = "window.barchan.app.runs[0]"
SCENARIO = f"{RUN}.description.scenario"

pytestmark = pytest.mark.extended


def test_a_quick_stroke_of_the_brush_leaves_one_even_ridge(studio):
    page = studio.page
    flat = {
        "barchan": 5,
        "lattice": {"rows": 48, "columns": 64},
        "sand": {"kind": "flat", "mean": 0},
        "run": {"seed": 1},
    }
    studio.ask(f"window.barchan.app.create({json.dumps(flat)}, false)")
    studio.until(f"{SCENARIO}.sand.mean === 0 && {RUN}.status?.volume === 0")
    studio.ask("window.barchan.stage.look('top')")
    page.get_by_role("tab", name="Paint").click()
    page.get_by_label("radius").fill("3")
    page.get_by_label("radius").press("Enter")
    page.locator("[data-paint=strength]").fill("3")
    page.locator("[data-paint=strength]").press("Enter")
    page.get_by_text("paint (B)").click()
    scene = page.locator(".scene canvas").first.bounding_box()
    middle = scene["y"] + scene["height"] / 2
    page.mouse.move(scene["x"] + 0.4 * scene["width"], middle)
    page.mouse.down()
    page.mouse.move(scene["x"] + 0.6 * scene["width"], middle)  # one event for the whole way
    page.mouse.up()
    studio.until(f"{RUN}.status.undo === 1")
    studio.catch_up()
    depth = np.array(studio.ask(f"[...{RUN}.depth]")).reshape(48, 64)
    along = depth[np.argmax(depth.sum(axis=1))]
    painted = along[np.flatnonzero(along)[0] + 2 : np.flatnonzero(along)[-1] - 1]
    assert painted.size > 6
    assert painted.min() > 0.5 * painted.max()


def test_a_stored_look_of_another_shape_is_replaced_where_it_does_not_fit(studio):
    page = studio.page
    odd = {
        "smoothing": "much",
        "limits": 3,
        "overlays": "plants",
        "theme": "sepia",
        "contours": "count",
        "count": 5,
    }
    studio.ask(f"localStorage.setItem('barchan-look', JSON.stringify({json.dumps(odd)}))")
    studio.ask("localStorage.setItem('barchan-panel', '[1')")
    page.reload()
    studio.step_beyond(-1)
    look = studio.ask("window.barchan.app.view.look")
    assert (look["contours"], look["count"]) == ("count", 5)
    assert look["limits"] is None
    assert look["theme"] == "system"
    assert look["smoothing"] is None
    page.get_by_role("tab", name="View").click()
    assert page.get_by_label("smoothing").is_visible()


def test_smoothing_suits_the_material_until_one_is_chosen(studio):
    page = studio.page
    older = json.dumps({"smoothing": 1, "count": 5})
    studio.ask(f"localStorage.setItem('barchan-look', JSON.stringify({older}))")
    page.reload()
    studio.step_beyond(-1)
    page.get_by_role("tab", name="View").click()
    shown = page.locator(".row", has=page.get_by_label("smoothing"))
    assert "1 ×" in shown.inner_text()
    studio.ask("window.barchan.app.runs[0].description.materials.werner = 'snow'")
    studio.ask("window.barchan.app.changed.send()")
    assert "0 ×" in shown.inner_text()
    assert studio.ask("window.barchan.app.view.look.count") == 5
    studio.ask("window.barchan.app.view.set({ smoothing: 1 })")
    page.reload()
    studio.step_beyond(-1)
    assert studio.ask("window.barchan.app.view.look.smoothing") == 1
    page.get_by_role("tab", name="View").click()
    page.get_by_role("button", name="Smooth as suits the material").click()
    assert studio.ask("window.barchan.app.view.look.smoothing") is None


def picture() -> bytes:
    content = io.BytesIO()
    Image.fromarray(np.tile(np.linspace(0, 255, 32).astype(np.uint8), (24, 1))).save(content, "PNG")
    return content.getvalue()


def test_grounds_and_records_are_chosen_in_the_panel(studio):
    page = studio.page
    page.locator("summary", has_text="Ground").click()
    page.locator("[data-path='ground']").select_option("file")
    sheet = page.get_by_role("dialog")
    sheet.get_by_label("Ground from a file").set_input_files(
        {"name": "plan b.png", "mimeType": "image/png", "buffer": picture()}
    )
    sheet.get_by_role("button", name="use it").click()
    studio.until(f"{SCENARIO}.ground.path?.endsWith('plan-b.png')")
    sheet.wait_for(state="detached")
    page.get_by_role("button", name="use another file").wait_for()
    scenario = {**studio.ask(SCENARIO), "clock": {}, "ground": {"kind": "flat"}}
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    page.get_by_role("tab", name="Wind").click()
    page.locator("[data-path='wind.kind']").select_option("record")
    sheet.get_by_role("button", name="the made-up record").click()
    studio.until(f"{SCENARIO}.wind.kind === 'record'")
    assert page.locator("[data-path='path']").get_attribute("placeholder") == "bundled example"
    page.get_by_role("button", name="use another record").click()
    sheet.get_by_label("Wind from a record").set_input_files(
        {"name": "my winds.csv", "mimeType": "text/csv", "buffer": b"seconds,speed\n0,1\n"}
    )
    sheet.get_by_role("button", name="use it").click()
    sheet.get_by_role("alert").filter(has_text="no column for the direction").wait_for()


def test_a_record_is_asked_for_first_and_brings_the_clock_that_it_needs(studio):
    page = studio.page
    assert studio.ask(f"{SCENARIO}.clock") is None
    page.get_by_role("tab", name="Wind").click()
    page.locator("[data-path='wind.kind']").select_option("record")
    sheet = page.get_by_role("dialog")
    sheet.get_by_text("it gets one with its defaults, and the run begins again").wait_for()
    assert studio.ask(f"{SCENARIO}.wind.kind") != "record"
    sheet.get_by_role("button", name="the made-up record").click()
    studio.until(f"{SCENARIO}.wind.kind === 'record' && {SCENARIO}.clock !== null")
    page.get_by_text("The winds are of the made-up record that ships with Barchan.").wait_for()
    assert studio.page.locator(".toast.error").count() == 0


HILL = "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n0 0 0\n0 2 0\n0 0 0\n"
WINDS = "time,speed (m/s),direction\n2020-01-01T00:00,8,90\n2020-01-02T00:00,9,90\n"


def test_a_sheet_refuses_a_file_of_the_other_kind_and_says_where_it_belongs(studio):
    page = studio.page
    before = studio.ask(SCENARIO)
    sheet = page.get_by_role("dialog")
    ground = (lambda: page.locator("[data-path='ground']").select_option("file"), "Ground from a file")
    wind = (lambda: page.locator("[data-path='wind.kind']").select_option("record"), "Wind from a record")
    page.locator("summary", has_text="Ground").click()
    _refused(sheet, *ground, "wind.csv", WINDS, "wind.csv is a record of winds, not a terrain; choose it")
    told = _refused(sheet, *ground, "note.pdf", "x", "note.pdf is of an unknown kind")
    assert ".npy" in told
    assert ".csv" not in told
    page.get_by_role("tab", name="Wind").click()
    _refused(sheet, *wind, "hill.asc", HILL, "hill.asc is a terrain, not a record of winds; choose it")
    told = _refused(sheet, *wind, "note.pdf", "x", "note.pdf is of an unknown kind")
    assert ".csv" in told
    assert ".npy" not in told
    assert studio.ask(SCENARIO) == before


def _refused(sheet, ask, label: str, name: str, text: str, words: str) -> str:
    ask()
    sheet.get_by_label(label).set_input_files(
        {"name": name, "mimeType": "text/plain", "buffer": text.encode()}
    )
    sheet.get_by_role("button", name="use it").click()
    trouble = sheet.get_by_role("alert").filter(has_text=words)
    trouble.wait_for()
    told = trouble.inner_text()
    sheet.get_by_role("button", name="Close").click()
    sheet.wait_for(state="detached")
    return told


def test_a_record_dropped_onto_a_scenario_without_a_clock_leads_to_one(studio):
    rows = "\n".join(f"2020-01-{1 + day:02}T00:00,{8 + day % 5},90" for day in range(28))
    studio.drop_file("east.csv", "text/csv", f"time,speed (m/s),direction\n{rows}\n".encode())
    toast = studio.page.locator(".toast", has_text="The winds of east.csv blow by a clock")
    toast.get_by_role("button", name="add a clock and begin again").click()
    studio.until(f"{SCENARIO}.wind.path?.endsWith('east.csv') && {SCENARIO}.clock !== null")


def test_all_defaults_come_back_at_once(studio):
    page = studio.page
    fill(studio, "model.p_s", "0.3")
    studio.until(f"{SCENARIO}.model.p_s === 0.3")
    rows = studio.ask(f"{SCENARIO}.lattice.rows")
    assert rows == 48
    page.get_by_role("button", name="put all defaults back").click()
    studio.until(f"{SCENARIO}.model.p_s === 0.6")
    studio.until(f"{SCENARIO}.lattice.rows !== 48")
    assert studio.ask(f"{SCENARIO}.run.seed") == 3


def test_a_branch_is_noted_with_the_step_at_which_it_begins(studio):
    page = studio.page
    studio.step_beyond(60)
    studio.pause()
    page.keyboard.press("PageUp")
    page.keyboard.press("PageUp")
    studio.until(f"{RUN}.status.looking")
    page.get_by_role("button", name="Go on from here").click()
    studio.until_logged("A new branch begins at step")
    began = studio.ask(f"{RUN}.description.branches.at(-1).began")
    assert f"begins at step {began}." in studio.log()


def test_changes_of_parameters_are_undone_from_their_list(studio):
    page = studio.page
    before = studio.ask(f"{SCENARIO}.model.p_s")
    mean = studio.ask(f"{SCENARIO}.sand.mean")
    studio.step_beyond(10)
    page.locator("summary", has_text="Sand at the start").click()
    fill(studio, "sand.mean", "5")
    studio.until(f"{SCENARIO}.sand.mean === 5")
    fill(studio, "model.p_s", "0.25")
    studio.until(f"{SCENARIO}.model.p_s === 0.25")
    assert "sand.mean 5, model.p_s 0.25" in studio.ask(f"{SCENARIO}.title")
    page.locator("summary", has_text="Changes").click()
    page.get_by_role("button", name="undo step").click()
    studio.until(f"{SCENARIO}.model.p_s === {before}")
    page.get_by_role("button", name="undo from the start: sand").click()
    studio.until(f"{SCENARIO}.sand.mean === {mean}")
    assert "sand.mean" not in studio.ask(f"{SCENARIO}.title")


def test_changes_are_lines_of_the_log_in_the_words_of_the_panel(studio):
    page = studio.page
    studio.step_beyond(10)
    studio.pause()
    hop, mean = (studio.ask(f"{SCENARIO}.{key}") for key in ("model.hop_length", "sand.mean"))
    step = studio.status()["live"]
    fill(studio, "model.hop_length", "9")
    studio.until_logged(f"step {step}: hop length {hop} → 9 cells")
    fill(studio, "model.hop_length", "11")  # within one gesture: the same line
    studio.until_logged(f"step {step}: hop length {hop} → 11 cells")
    assert "→ 9 cells" not in studio.log()
    studio.ask(
        f"void window.barchan.app.ask({{ command: 'wind', wind: {{ ...{SCENARIO}.wind, direction: 240 }} }})"
    )
    studio.until_logged(f"step {step}: wind ")
    page.locator("summary", has_text="Sand at the start").click()
    fill(studio, "sand.mean", "5")
    studio.until_logged(f"from the start: sand › mean {mean} → 5")
