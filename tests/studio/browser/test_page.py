"""The studio as its users meet it: a server of its own, a real browser, small fields."""

import io
import json
import os
import re
import signal
import time
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from barchan.scenario import load_scenario
from tests.studio.browser.conftest import SMALL, children_of


def test_the_surface_is_drawn_and_changes(studio):
    studio.step_beyond(50)
    first = studio.picture()
    assert first.std() > 5
    assert len(np.unique(first.reshape(-1, 3), axis=0)) > 200
    studio.step_beyond(300)
    assert np.abs(studio.picture() - first).max() > 40


def test_run_pause_and_step(studio):
    studio.pause()
    step = studio.status()["step"]
    studio.page.keyboard.press(".")
    studio.until(f"window.barchan.app.runs[0].status.step === {step + 1}")
    studio.page.get_by_label("Number of steps").fill("25")
    studio.page.get_by_role("button", name="Do these steps").click()
    studio.until(f"window.barchan.app.runs[0].status.step === {step + 26}")
    assert studio.page.locator("[data-status=step]").inner_text().replace("\u202f", "") == str(step + 26)
    studio.page.get_by_role("button", name="Restart").click()
    studio.until("window.barchan.app.runs[0].status.step === 0")


def test_a_live_parameter_changes_at_once_and_another_restarts(studio):
    studio.step_beyond(30)
    hop = studio.page.locator("[data-path='model.hop_length']")
    hop.fill("3")
    hop.press("Enter")
    studio.until("window.barchan.app.runs[0].description.scenario.model.hop_length === 3")
    assert studio.status()["step"] >= 30
    studio.page.locator("summary", has_text="Sand at the start").click()
    studio.page.locator("[data-path='sand.mean']").fill("6")
    studio.page.locator("[data-path='sand.mean']").press("Enter")
    studio.until("window.barchan.app.runs[0].description.scenario.sand.mean === 6")
    studio.until("window.barchan.app.runs[0].status.volume === 48 * 64 * 6 / 3")
    assert studio.ask("window.barchan.app.runs[0].description.scenario.model.hop_length") == 3


@pytest.mark.extended
def test_the_page_names_the_material_that_the_model_declares(studio):
    studio.step_beyond(0)
    studio.pause()
    studio.ask("window.barchan.app.runs[0].description.materials.werner = 'snow'")
    studio.ask("window.barchan.app.described.send(window.barchan.app.runs[0])")
    studio.ask("window.barchan.app.changed.send()")
    page = studio.page
    assert page.locator("summary", has_text="Snow at the start").count() == 1
    assert page.locator("[data-look=field] option").first.inner_text() == "snow, as it looks"
    assert page.locator("[data-status=volume]").locator("xpath=preceding-sibling::dt").inner_text() == "snow"


@pytest.mark.extended
def test_a_wrong_value_is_reported_beside_its_row(studio):
    box = studio.page.locator("[data-path='model.p_s']")
    box.fill("5")
    box.press("Enter")
    studio.until("document.querySelector('[data-trouble=\"model.p_s\"]')?.textContent.includes('allowed')")


@pytest.mark.extended
def test_winds_in_turn_with_a_curve(studio):
    page = studio.page
    page.get_by_role("tab", name="Wind").click()
    page.locator("[data-path='wind.kind']").select_option("regimes")
    page.get_by_text("+ add a regime").click()
    page.locator("[data-path='regimes.1.speed']").fill("2")
    page.locator("[data-path='regimes.1.speed']").press("Enter")
    studio.until("window.barchan.app.runs[0].description.scenario.wind.regimes?.[1]?.speed === 2")
    page.locator("[data-path='regimes.1.final_speed']").fill("8")
    page.locator("[data-path='regimes.1.final_speed']").press("Enter")
    wind = "window.barchan.app.runs[0].description.scenario.wind"
    grip = page.get_by_label("Control point 1")
    grip.scroll_into_view_if_needed()
    box = grip.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + 40, box["y"] - 20, steps=4)
    page.mouse.up()
    studio.until(f"{wind}.regimes?.[1]?.speed_ramp.kind === 'bezier'")
    moved = float(re.search(r"time ([0-9.]+)", grip.get_attribute("aria-valuetext"))[1])
    assert moved > 0.4
    studio.until(f"Math.abs({wind}.regimes[1].speed_ramp.time_1 - {moved}) < 0.006")
    grip.focus()
    page.keyboard.press("ArrowLeft")
    studio.until(f"{wind}.regimes[1].speed_ramp.time_1 < {moved - 0.01}")
    page.get_by_label("Up: regime 2").click()
    studio.until(f"{wind}.regimes[0].speed_ramp.kind === 'bezier'")
    page.get_by_label("Remove: regime 2").click()
    studio.until(f"{wind}.regimes.length === 1")


SNOW = {
    "barchan": 5,
    "lattice": {"rows": 32, "columns": 48, "cell_size": 0.1},
    "sand": {"kind": "flat", "mean": 6},
    "wind": {"kind": "steady", "speed": 10, "unit": "m/s", "snowfall": 0.01, "temperature": -10},
    "model": {"name": "snow", "beneath": [{"mass": 5, "density": 300, "age": 24}]},
    "run": {"steps": 10000, "seed": 3, "save_every": 10},
}


@pytest.mark.extended
def test_snow_shows_its_layers_its_balance_its_brushes_and_a_curve_of_its_temperature(studio):
    page, run = studio.page, "window.barchan.app.runs[0]"
    studio.ask(f"window.barchan.app.create({json.dumps(SNOW)}, true)")
    studio.until(f"{run}.description.model.name === 'snow' && {run}.status?.step > 5")
    studio.pause()
    page.keyboard.press("1")
    plot = page.locator(".view canvas.plot:visible")
    drawn = []
    for by in ("age", "density", "state"):
        page.locator("[data-strata]").select_option(by)
        studio.catch_up()
        time.sleep(0.4)
        drawn.append(plot.screenshot())
    assert len(set(drawn)) == 3
    plot.hover(position={"x": 300, "y": 60})
    studio.until("document.querySelector('.readout').textContent.includes('bonded')")
    page.keyboard.press("2")
    parts = f"{run}.status.balance.parts"
    balance = studio.ask(parts)
    assert balance["fallen"] > 0
    assert balance["held"] == balance["at the start"] + balance["fallen"] - balance["left"]
    assert "fallen" in page.locator(".balance").text_content()
    page.get_by_role("tab", name="Paint").click()
    for what, number in (("snowfall", "density"), ("ice nucleus", None)):
        page.locator("[data-paint=what]").select_option(what)
        assert page.locator("[data-paint=density]").count() == (number is not None)
        page.get_by_text("paint (B)").click()
        studio.drag((0.5, 0.5), (0.52, 0.5))
        page.get_by_text("paint (B)").click()
        studio.until(f"{run}.status.undo === 1")
        studio.until(f"{parts}['entered'] > 0" if number else f"Math.max(...{run}.ground) > 0.05")
        page.keyboard.press("Control+z")
        studio.until(f"{run}.status.undo === 0")
        studio.until(f"JSON.stringify({parts}) === '{json.dumps(balance, separators=(',', ':'))}'")
    page.get_by_role("tab", name="Wind").click()
    page.locator("[data-path='wind.kind']").select_option("regimes")
    for key, value in (("temperature", "-20"), ("final_temperature", "-2")):
        box = page.locator(f"[data-path='regimes.0.{key}']")
        box.fill(value)
        box.press("Enter")
        studio.until(f"{run}.description.scenario.wind.regimes?.[0]?.{key} === {value}")
    curve = page.get_by_label("Curve of the temperature")
    grip = curve.get_by_label("Control point 2")
    grip.focus()
    page.keyboard.press("ArrowUp")
    studio.until(f"{run}.description.scenario.wind.regimes[0].temperature_ramp.kind === 'bezier'")


@pytest.mark.extended
def test_a_recorded_wind_shows_its_roses(studio):
    scenario = load_scenario("recorded-wind", list(SMALL.items())).data()
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    studio.page.get_by_role("tab", name="Wind").click()
    studio.until("document.querySelectorAll('.roses .speed-2').length >= 16")
    assert "calm" in studio.page.locator(".roses").inner_text()
    studio.page.locator("[data-path='wind.kind']").select_option("steady")
    studio.until("document.querySelector('.roses') && !document.querySelector('.roses .speed-2')")


def test_painting_and_undoing(studio):
    studio.pause()
    before = studio.status()["volume"]
    studio.page.get_by_role("tab", name="Paint").click()
    studio.page.keyboard.press("b")
    studio.drag((0.45, 0.55), (0.5, 0.55), (0.55, 0.6))
    studio.until(f"window.barchan.app.runs[0].status.volume > {before}")
    studio.until("window.barchan.app.runs[0].status.undo === 1")
    studio.catch_up()
    after = studio.status()["volume"]
    studio.page.keyboard.press("Control+z")
    studio.until(f"window.barchan.app.runs[0].status.volume === {before}")
    studio.page.keyboard.press("Control+Shift+z")
    studio.until(f"window.barchan.app.runs[0].status.volume === {after}")


@pytest.mark.extended
def test_what_is_painted_on_is_drawn_as_steep_as_before_until_that_is_chosen_anew(studio):
    page = studio.page
    studio.pause()
    steep = "window.barchan.stage.terrain(window.barchan.app.runs[0]).exaggeration"
    before = studio.ask(steep)
    page.get_by_role("tab", name="Paint").click()
    page.keyboard.press("b")
    page.locator("[data-paint=what]").select_option("rock")
    assert "Rock rises under the sand" in page.locator(".forms .hint:visible").first.inner_text()
    page.locator("[data-paint=strength]").fill("60")
    page.locator("[data-paint=strength]").press("Enter")
    studio.drag((0.45, 0.55), (0.5, 0.55), (0.55, 0.6))
    studio.until("window.barchan.app.runs[0].status.undo === 1")
    studio.catch_up()
    studio.picture()
    assert studio.ask(steep) == before
    page.get_by_role("tab", name="View").click()
    page.get_by_label("automatic", exact=True).first.click()
    page.get_by_label("automatic", exact=True).first.click()
    studio.picture()
    assert studio.ask(steep) < before


@pytest.mark.extended
def test_time_line_and_export_count_the_states_alike(studio):
    page = studio.page
    studio.pause()
    studio.ask("window.barchan.app.send({ command: 'run', steps: 7 })")
    studio.until("!window.barchan.app.running && window.barchan.app.runs[0].status.step % 10 > 0")
    kept = page.locator(".timeline output").inner_text().removesuffix(" states kept")
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Export for other programs").click()
    assert f"all {kept} that are kept" in page.get_by_label("States", exact=True).inner_text()
    page.keyboard.press("Escape")
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Picture with title and scale").click()
    assert page.get_by_role("textbox", name="Title", exact=True).input_value() == "Barchans"


@pytest.mark.extended
def test_painting_rock_and_plants(studio):
    run = "window.barchan.app.runs[0]"
    scenario = load_scenario("nebkhas", list(SMALL.items())).data()
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    studio.until(
        f"{run}.description.model.name === 'nield_baas' && {run}.fits && !window.barchan.app.running"
    )
    page = studio.page
    page.get_by_role("tab", name="Paint").click()
    page.keyboard.press("b")
    page.locator("[data-paint=what]").select_option("rock")
    page.locator("[data-paint=strength]").fill("9")
    page.locator("[data-paint=strength]").press("Enter")
    studio.drag((0.45, 0.5), (0.5, 0.55))
    studio.until(f"Math.max(...{run}.ground) > 1")
    page.locator("[data-paint=what]").select_option("shrub")
    studio.ask("window.barchan.app.view.set({ overlays: ['shrub'] })")
    before = studio.picture()
    studio.drag((0.55, 0.6), (0.6, 0.62))
    studio.until(f"Math.max(...({run}.fields.get('shrub') ?? [0])) > 0.1")
    assert np.abs(studio.picture() - before).max() > 20
    page.locator("[data-paint=way]").select_option("erase")
    studio.until(f"{run}.status.undo === 2")
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    studio.until(f"Math.max(...{run}.ground) === 0 && {run}.status.redo === 2")


@pytest.mark.extended
def test_paths_of_grains_are_drawn_over_the_bed(studio):
    sizes = {"lattice.rows": "24", "lattice.columns": "32", "sand.mean": "60"}
    scenario = load_scenario("first-grains", list(sizes.items())).data()
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    run = "window.barchan.app.runs[0]"
    studio.until(f"{run}.paths.length >= 20")
    studio.until("!window.barchan.app.running")
    studio.page.get_by_role("tab", name="View").click()
    drawn = studio.picture()
    studio.page.get_by_label("paths").fill("0")
    studio.page.get_by_label("paths").press("Enter")
    studio.until(f"{run}.paths.length === 0")
    assert np.abs(studio.picture() - drawn).max() > 60


@pytest.mark.extended
def test_a_broken_file_names_each_bad_key_and_the_rest_is_loaded_when_asked(studio):
    text = json.dumps({"barchan": 5, "title": "Half good", "model": {"name": "werner", "p_s": 7, "hop": 2}})
    studio.ask(f"window.barchan.files.load('mine.json', {json.dumps(text)})")
    dialog = studio.page.get_by_role("dialog")
    problems = dialog.locator("li").all_inner_texts()
    assert [problem.split(":")[0] for problem in problems] == ["model.p_s", "model.hop"]
    assert studio.ask("window.barchan.app.runs[0].description.scenario.title").startswith("Barchans")
    dialog.get_by_text("load the rest").click()
    studio.until("window.barchan.app.runs[0].description.scenario.title === 'Half good'")
    assert "model.p_s" in studio.log()


@pytest.mark.extended
def test_two_models_side_by_side(studio):
    studio.page.get_by_label("Compare with another model").select_option("momiji")
    studio.until("window.barchan.app.runs[1]?.status?.step > 60")
    studio.pause()
    studio.until("new Set(window.barchan.app.runs.map((run) => run.status.step)).size === 1")
    each = studio.picture()
    studio.ask("window.barchan.app.view.set({ side: 'difference' })")
    time.sleep(0.3)
    assert np.abs(studio.picture() - each).mean() > 2
    studio.page.get_by_label("Compare with another model").select_option("")
    studio.until("window.barchan.app.runs.length === 1")


def test_a_reload_in_mid_run_goes_on_with_the_same_run(studio):
    studio.step_beyond(100)
    step = studio.status()["step"]
    workers = children_of(studio.process.pid)
    studio.page.reload()
    studio.step_beyond(step)
    assert children_of(studio.process.pid) == workers


@pytest.mark.extended
def test_a_killed_worker_is_reported_and_restarted(studio):
    studio.page.reload()
    studio.step_beyond(5)
    worker = next(
        child
        for child in children_of(studio.process.pid)
        if b"spawn_main" in Path(f"/proc/{child}/cmdline").read_bytes()
    )
    os.kill(worker, signal.SIGKILL)
    studio.until("window.barchan.app.runs[0].lost")
    studio.page.get_by_role("button", name="restart the run").click()
    studio.until("!window.barchan.app.runs[0].lost && window.barchan.app.running")


def test_saving_and_opening_a_run(studio):
    studio.step_beyond(40)
    studio.pause()
    step = studio.status()["step"]
    page = studio.page
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Save the run").click()
    page.get_by_label("Name of the run").fill("mine")
    page.get_by_role("dialog").get_by_role("button", name="save", exact=True).click()
    studio.until_logged("Saved")
    assert (studio.folder / "mine" / "scenario.json").is_file()
    page.keyboard.press("r")
    studio.until(f"window.barchan.app.runs[0].status.step < {step}")
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Open a saved run").click()
    page.get_by_role("dialog").get_by_role("button", name="mine").click()
    studio.until(f"window.barchan.app.runs[0].status.step === {step}")


@pytest.mark.extended
def test_looking_back_and_going_on_from_there(studio):
    studio.step_beyond(60)
    studio.pause()
    live = studio.status()["live"]
    studio.ask("window.barchan.app.send({ command: 'look', step: 20 })")
    studio.until("window.barchan.app.runs[0].status.looking")
    assert studio.status()["step"] == 20
    studio.page.get_by_role("button", name="Return to now").click()
    studio.until(f"window.barchan.app.runs[0].status.step === {live}")
    studio.page.get_by_label("Look back through the run").press("Home")
    studio.until("window.barchan.app.runs[0].status.step === 0")
    studio.page.get_by_role("button", name="Go on from here").click()
    studio.until("window.barchan.app.runs[0].status.live === 0")
    studio.page.get_by_label("Branch", exact=True).select_option("1")
    studio.until(f"window.barchan.app.runs[0].status.live === {live}")
    studio.page.get_by_label("Branch", exact=True).select_option("2")
    studio.until("window.barchan.app.runs[0].status.live === 0")


@pytest.mark.extended
def test_views_and_keys(studio):
    page = studio.page
    studio.step_beyond(50)
    for key, name in (("1", "Section"), ("2", "Measures"), ("3", "Space–time"), ("4", "Log")):
        page.keyboard.press(key)
        assert page.get_by_role("tab", name=name).get_attribute("aria-selected") == "true"
    page.keyboard.press("1")
    studio.until("window.barchan.app.runs[0].fields.has('shadow')")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save the section as CSV").click()
    rows = Path(download.value.path()).read_text().splitlines()
    assert rows[0] == "distance_m,x_m,y_m,elevation_m,ground_m,slope_degrees,shadow"
    assert len(rows) > 64
    page.keyboard.press("?")
    assert page.get_by_role("dialog").get_by_text("restart with the same seed").is_visible()


@pytest.mark.extended
@pytest.mark.parametrize("looking", [False, True])
def test_the_space_time_diagram_begins_where_the_run_began(studio, looking):
    studio.step_beyond(60)
    studio.pause()
    studio.page.reload()
    studio.step_beyond(60)
    if looking:
        studio.page.keyboard.press("PageUp")
        studio.until("window.barchan.app.runs[0].status.looking")
    studio.page.keyboard.press("3")
    studio.until("parseInt(document.querySelector('.view:not([hidden]) .readout')?.textContent) >= 6")


@pytest.mark.extended
def test_an_image_dropped_onto_the_scene_is_the_ground(studio):
    heights = np.zeros((48, 64), np.uint8)
    heights[:, :32] = 255
    file = io.BytesIO()
    Image.fromarray(heights).save(file, "PNG")
    studio.drop_file("plateau.png", "image/png", file.getvalue())
    studio.page.get_by_role("dialog").get_by_role("button", name="use it").click()
    run = "window.barchan.app.runs[0]"
    studio.until(f"{run}.description.scenario.ground.kind === 'file' && {run}.ground[0] > 1")
    ground = np.array(studio.ask(f"[...{run}.ground]")).reshape(48, 64)
    assert ground[:, 8:24].min() == ground.max() == pytest.approx(5.1)
    assert ground[:, 40:56].max() == 0
    assert (studio.folder / "studio-uploads" / "plateau.png").is_file()


@pytest.mark.extended
def test_an_elevation_model_brings_its_own_lattice_and_its_holes_are_reported(studio):
    """Heights of 0.05 m a column; the hole of -9999 in the middle of the slope is filled with the slope."""
    rows = [[f"{0.05 * column:.2f}" for column in range(40)] for _ in range(20)]
    rows[9][20] = rows[10][20] = "-9999"
    head = "ncols 40\nnrows 20\nxllcorner 500000\nyllcorner 4000000\ncellsize 2.5\n"
    text = head + "\n".join(" ".join(row) for row in rows)
    studio.drop_file("dem.asc", "text/plain", text.encode())
    run = "window.barchan.app.runs[0]"
    studio.until(f"{run}.description.scenario.ground.kind === 'file' && {run}.ground.length === 800")
    ground = np.array(studio.ask(f"[...{run}.ground]")).reshape(20, 40)
    np.testing.assert_allclose(ground, np.broadcast_to(0.05 * np.arange(40), (20, 40)), atol=1e-3)
    assert studio.ask(f"{run}.description.scenario.ground.missing") == [-9999]
    assert studio.ask(f"{run}.description.lattice.cell_size") == 2.5
    told = (
        "window.barchan.app.notices.log.some((e) => e.text.includes('-9999 taken as cells without a height'))"
    )
    assert studio.ask(told)


@pytest.mark.extended
def test_a_dropped_file_that_cannot_be_used_is_reported(studio):
    studio.drop_file("tune.mp3", "audio/mpeg", b"0")
    studio.until_logged("tune.mp3 is of an unknown kind")


def test_a_wind_record_dropped_onto_the_scene_blows(studio):
    scenario = load_scenario("recorded-wind", list(SMALL.items())).data()
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    wind = "window.barchan.app.runs[0].description.scenario.wind"
    studio.until(f"{wind}.kind === 'record'")
    studio.drop_file("broken.csv", "text/csv", b"seconds,speed\n0,1\n")
    studio.until_logged("no column for the time")
    rows = "\n".join(f"2020-01-{1 + day:02}T00:00,{8 + day % 5},90" for day in range(28))
    studio.drop_file("east.csv", "text/csv", f"time,speed (m/s),direction\n{rows}\n".encode())
    studio.until(f"{wind}.path?.endsWith('east.csv')")


@pytest.mark.extended
def test_a_preset_from_the_gallery(studio):
    studio.page.keyboard.press("g")
    studio.page.get_by_label("Search the presets").fill("three rocks")
    studio.page.locator("[data-preset='three-rocks']").click()
    studio.until("window.barchan.app.runs[0].description.scenario.ground.kind === 'three_rocks'")


@pytest.mark.extended
def test_every_control_has_a_name(studio):
    studio.step_beyond(0)
    for tab in ("Scenario", "Wind", "Paint", "View"):
        studio.page.get_by_role("tab", name=tab, exact=True).click()
        nameless = studio.ask(
            """[...document.querySelectorAll('button, select, input')].filter((one) => one.offsetParent &&
            !one.textContent.trim() && !one.getAttribute('aria-label') && !one.labels?.length)
            .map((one) => one.outerHTML)"""
        )
        assert nameless == []
