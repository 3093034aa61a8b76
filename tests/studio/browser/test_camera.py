"""The camera of the studio: the whole field is in view, whatever its shape, the window and the dock."""

import json
import time

import numpy as np
import pytest

from barchan.studio.pictures import rendered
from tests.studio.browser.conftest import SMALL

CORNERS = """(() => {
    const { stage, app } = window.barchan;
    stage.camera.updateMatrixWorld();
    const { min, max } = stage.terrain(app.runs[0]).box();
    const found = [];
    for (const x of [min.x, max.x]) for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) {
        const seen = min.clone().set(x, y, z).project(stage.camera);
        found.push([seen.x, seen.y]);
    }
    return found;
})()"""
"""Corners of the block as shares of half the view, from -1 to 1 where they are seen."""

pytestmark = pytest.mark.extended


def begin(studio, **lattice):
    studio.page.set_viewport_size({"width": 500, "height": 320})
    scenario = {
        "barchan": 5,
        "title": json.dumps(lattice),
        "lattice": lattice,
        "sand": {"kind": "flat", "mean": 4},
        "wind": {"kind": "steady", "direction": 270},
        "model": {"name": "werner"},
        "run": {"steps": 10000, "seed": int(SMALL["run.seed"])},
    }
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, false)")
    studio.until(f"window.barchan.app.runs[0].ready && window.barchan.app.runs[0].rows === {lattice['rows']}")
    studio.picture()


def assert_filled(studio):
    """No corner is out of view, and the block fills most of the view across or up."""
    corners = studio.ask(CORNERS)
    across = [x for x, _ in corners]
    up = [y for _, y in corners]
    assert max(map(abs, across + up)) <= 1
    assert max(max(across) - min(across), 1.25 * (max(up) - min(up))) > 1.5


@pytest.mark.parametrize(("rows", "columns"), [(48, 64), (12, 96), (96, 12)])
def test_a_field_of_any_shape_fills_the_view_from_everywhere(studio, rows, columns):
    begin(studio, rows=rows, columns=columns)
    for viewpoint in ("oblique", "top", "side"):
        studio.ask(f"window.barchan.stage.look('{viewpoint}')")
        assert_filled(studio)


def test_the_field_stays_in_view_when_the_window_and_the_dock_change_and_beside_another(studio):
    begin(studio, rows=48, columns=64)
    for width, height in ((640, 360), (380, 450)):
        studio.page.set_viewport_size({"width": width, "height": height})
        studio.picture()
        assert_filled(studio)
    studio.page.keyboard.press("1")
    studio.picture()
    assert_filled(studio)
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs.every((run) => run.ready)")
    studio.picture()
    assert_filled(studio)
    studio.ask("window.barchan.app.send({ command: 'alone' })")


def test_views_from_above_and_from_the_side_are_without_perspective(studio):
    studio.pause()
    for viewpoint, ahead in (("top", [0, -1, 0]), ("side", [0, 0, -1])):
        studio.ask(f"window.barchan.stage.look('{viewpoint}')")
        studio.picture()
        assert studio.ask("window.barchan.stage.camera.isOrthographicCamera")
        matrix = studio.ask("window.barchan.stage.camera.matrixWorld.elements")
        assert [-part for part in matrix[8:11]] == pytest.approx(ahead, abs=0.01)


def test_a_view_that_somebody_has_chosen_is_kept(studio):
    studio.pause()
    studio.page.keyboard.press("ArrowLeft")
    position = studio.ask("window.barchan.stage.camera.position.toArray()")
    studio.page.set_viewport_size({"width": 900, "height": 600})
    studio.picture()
    assert studio.ask("window.barchan.stage.camera.position.toArray()") == pytest.approx(position)


def test_another_scenario_begins_with_its_whole_field_in_view_and_a_changed_value_does_not(studio):
    begin(studio, rows=48, columns=64)
    studio.ask("window.barchan.stage.turn(0.7, 0.2, 0.3)")
    position = studio.ask("window.barchan.stage.camera.position.toArray()")
    scenario = "window.barchan.app.runs[0].description.scenario"
    changed = f"{{ ...{scenario}, lattice: {{ rows: 40, columns: 64 }} }}"
    studio.ask(f"window.barchan.app.create({changed}, false, true)")
    studio.until("window.barchan.app.runs[0].ready && window.barchan.app.runs[0].rows === 40")
    studio.picture()
    assert studio.ask("window.barchan.stage.camera.position.toArray()") == pytest.approx(position)
    begin(studio, rows=12, columns=96)
    assert studio.ask("window.barchan.stage.fits")
    assert_filled(studio)
    studio.ask("window.barchan.stage.look('top')")
    studio.ask("window.barchan.stage.turn(0, 0, 0.2)")
    begin(studio, rows=96, columns=12)
    assert studio.ask("window.barchan.stage.camera.isOrthographicCamera")  # still from above
    assert_filled(studio)


def test_a_run_that_is_opened_or_gone_back_to_begins_with_its_whole_field_in_view(studio):
    studio.pause()
    studio.ask("window.barchan.app.ask({ command: 'save', name: 'whole' })")
    begin(studio, rows=12, columns=96)
    for way in ("open({ command: 'open', name: 'whole' })", "notices.standing.at(-1).way.act()"):
        studio.ask("window.barchan.stage.turn(0.7, 0.2, 0.3)")
        studio.ask(f"window.barchan.app.{way}")
        studio.until("window.barchan.app.runs[0].ready && window.barchan.app.runs[0].rows === 48")
        studio.picture()
        assert studio.ask("window.barchan.stage.fits")
        assert_filled(studio)
        begin(studio, rows=12, columns=96)


def assert_comes_to_rest(studio):
    for _ in range(40):
        heading = studio.ask("window.barchan.stage.heading()")
        studio.picture()
        if studio.ask("window.barchan.stage.heading()") == heading:
            return
    raise AssertionError("the view goes on turning")


def test_the_view_turns_slowly_while_it_is_left_alone_unless_it_shall_not(studio):
    studio.pause()
    studio.page.set_viewport_size({"width": 480, "height": 320})
    studio.ask("window.barchan.app.view.set({ quality: 'full' })")
    studio.ask("void (window.barchan.stage.view.lastTouch = -1e6)")
    heading = studio.ask("window.barchan.stage.heading()")
    studio.until(f"Math.abs(window.barchan.stage.heading() - {heading}) > 0.002")
    studio.ask("window.barchan.app.view.set({ turning: false })")
    assert_comes_to_rest(studio)
    studio.ask("window.barchan.app.view.set({ turning: true })")
    studio.page.emulate_media(reduced_motion="reduce")
    assert not studio.ask("window.barchan.stage.view.mayTurn()")


def test_a_drag_beside_the_field_turns_the_view_but_not_while_a_brush_is_lit(studio):
    studio.pause()
    studio.ask("window.barchan.app.view.set({ turning: false })")
    before = studio.ask("window.barchan.stage.standpoint()")
    studio.page.keyboard.press("b")
    studio.drag((0.02, 0.95), (0.3, 0.9))
    studio.drag((0.02, 0.95), (0.5, 0.5))
    time.sleep(0.5)
    studio.picture()
    assert studio.ask("window.barchan.stage.standpoint()") == before
    assert studio.status()["undo"] == 0
    studio.page.keyboard.press("b")
    studio.drag((0.02, 0.95), (0.3, 0.9))
    studio.until(f"window.barchan.stage.standpoint().position[0] !== {before['position'][0]}")


def test_the_glide_after_a_drag_ends_after_a_time_however_few_pictures_are_drawn(studio):
    studio.pause()
    studio.ask("window.barchan.app.view.set({ turning: false })")
    studio.ask(
        "window.barchan.stage.renderer.setAnimationLoop(null)"
    )  # no pictures but those that are asked for
    heading = studio.ask("window.barchan.stage.heading()")
    studio.drag((0.3, 0.5), (0.7, 0.5))
    time.sleep(0.5)
    after = []
    for _ in range(4):
        studio.ask("window.barchan.stage.tick()")
        after.append(studio.ask("window.barchan.stage.heading()"))
    assert after[0] != heading
    assert after == pytest.approx([after[0]] * 4, abs=1e-9)


@pytest.mark.parametrize("angle", [10, 60])
def test_the_field_fills_the_view_through_any_lens(studio, angle):
    begin(studio, rows=48, columns=64)
    studio.ask(f"window.barchan.app.view.set({{ fieldOfView: {angle} }})")
    assert_filled(studio)
    studio.ask("window.barchan.stage.turn(0.5, 0.1, 1.3)")
    metres = studio.ask("window.barchan.stage.metresPerPixel()")
    studio.ask("window.barchan.app.view.set({ fieldOfView: 21 })")
    assert studio.ask("window.barchan.stage.metresPerPixel()") == pytest.approx(metres, rel=1e-6)


def test_sands_differ_as_their_names_say(studio):
    begin(studio, rows=48, columns=64)
    studio.ask("window.barchan.stage.look('top')")
    seen = {}
    for sand in ("golden", "white", "red", "dark"):
        studio.ask(f"window.barchan.app.view.set({{ sand: '{sand}' }})")
        picture = np.asarray(rendered(studio.page, 60, 40)).astype(float)
        seen[sand] = picture[15:25, 25:35].mean(axis=(0, 1))
    studio.ask("window.barchan.app.view.set({ sand: 'golden' })")
    red, _, blue = seen["red"]
    golden, white = seen["golden"], seen["white"]
    assert white.mean() > golden.mean() > seen["dark"].mean()
    assert red / blue > 1.2 * golden[0] / golden[2] > 1.2 * white[0] / white[2]


@pytest.mark.parametrize("viewpoint", ["oblique", "top"])
def test_the_whole_field_stays_in_a_film_while_the_camera_turns(studio, viewpoint):
    begin(studio, rows=48, columns=96)
    studio.ask(f"window.barchan.stage.look('{viewpoint}')")
    studio.ask("window.barchan.stage.keepWhole(Math.PI, 400, 320)")
    shape = "((camera, aspect) => void (camera.isPerspectiveCamera ? camera.aspect = aspect : "
    shape += "(camera.right = aspect * camera.top, camera.left = -camera.right)))"
    for _ in range(13):
        studio.ask(f"{shape}(window.barchan.stage.camera, 400 / 320)")
        studio.ask("window.barchan.stage.camera.updateProjectionMatrix()")
        assert max(abs(share) for corner in studio.ask(CORNERS) for share in corner) <= 1
        studio.ask("window.barchan.stage.turn(Math.PI / 12, 0)")


def test_a_detail_that_is_looked_at_stays_as_near_in_a_film(studio):
    begin(studio, rows=48, columns=96)
    studio.ask("window.barchan.stage.turn(0, 0, 0.4)")
    before = studio.ask("window.barchan.stage.standpoint()")
    studio.ask("window.barchan.stage.keepWhole(Math.PI, 1280, 720)")
    assert studio.ask("window.barchan.stage.standpoint()") == before


def opened_picture_sheet(studio):
    studio.page.locator("summary", has_text="File").click()
    studio.page.get_by_role("menuitem", name="Picture with title").click()
    previewed = "(({ width, height }) => width + height !== 450)(document.querySelector('.preview'))"
    studio.until(previewed)  # a canvas is of 300 x 150 pixels before something is drawn on it
    return studio.page.get_by_role("dialog")


def test_camera_and_exaggeration_stand_still_while_the_sheet_of_a_picture_is_open(studio):
    begin(studio, rows=48, columns=64)
    studio.ask("window.barchan.app.view.set({ quality: 'full', turning: true })")
    opened_picture_sheet(studio)
    studio.ask("void (window.barchan.stage.view.lastTouch = -1e6)")
    steep = "window.barchan.stage.terrain(window.barchan.app.runs[0]).exaggeration"
    before = [studio.ask("window.barchan.stage.standpoint()"), studio.ask(steep)]
    studio.ask("window.barchan.app.send({ command: 'run', until: 60 })")
    studio.until("window.barchan.app.runs[0].status.step === 60")
    studio.picture()
    assert [studio.ask("window.barchan.stage.standpoint()"), studio.ask(steep)] == before
    studio.page.keyboard.press("Escape")
    studio.until(f"{steep} < {before[1]}")
    assert not studio.ask("window.barchan.stage.steady")


def test_a_finer_picture_leaves_the_exaggeration_of_what_is_painted_on(studio):
    begin(studio, rows=48, columns=64)
    studio.ask("window.barchan.app.view.set({ quality: 'plain', turning: false })")
    steep = "window.barchan.stage.terrain(window.barchan.app.runs[0]).exaggeration"
    before = studio.ask(steep)
    studio.page.keyboard.press("b")
    studio.ask("window.barchan.app.runs[0].painted = true")
    for x in (20, 40):
        stroke = {"kind": "material", "radius": 6, "amount": 60, "falloff": "smooth"}
        found = studio.ask("window.barchan.app.runs[0].description.brushes[0].stroke")
        stroke = {**stroke, **found}
        places = [[x, y] for y in range(4, 44, 3)]
        command = {"command": "stroke", "begin": True, "places": places, "stroke": stroke}
        studio.ask(f"window.barchan.app.send({json.dumps(command)})")
        studio.ask("window.barchan.app.send({ command: 'stroke', end: true })")
        studio.catch_up()
    assert studio.ask(steep) == before > 1
    opened_picture_sheet(studio)
    assert studio.ask(steep) == before
    studio.page.keyboard.press("Escape")
    studio.picture()
    assert studio.ask(steep) == before


def test_lines_over_the_surface_are_left_out_of_pictures_unless_asked_for(studio):
    begin(studio, rows=48, columns=64)
    asked = """(lines) => window.barchan.stage.shoot({ width: 120, height: 80, lines })
        .then(({ canvas }) => canvas.toDataURL())"""
    plain = studio.page.evaluate(asked, False)
    studio.ask("window.barchan.stage.showLine('section', [0.1, 0.1, 0.9, 0.9])")
    assert studio.page.evaluate(asked, False) == plain
    assert studio.page.evaluate(asked, True) != plain
