"""The page in windows of every size, and by keys: nothing is cut off, nothing covers what is looked at."""

import pytest

from tests.studio.browser.test_access import SHEETS

pytestmark = pytest.mark.extended


CUT = """[...document.querySelectorAll('button, select, input, summary')].filter((one) => {
    const box = one.getBoundingClientRect();
    const style = getComputedStyle(one);
    if (!box.width || style.visibility === 'hidden') return false;
    if (one.closest('.page, .unseen, .plots, .sections')) return false;
    if (box.left < 0 || box.right > innerWidth + 0.5) return true;
    if (box.top < 0 || box.bottom > innerHeight + 0.5) return true;
    if (one.matches('button, summary')) return one.scrollWidth > one.clientWidth + 1;
    if (one.tagName !== 'SELECT') return false;
    if (style.fieldSizing === 'content' && box.width < parseFloat(style.maxWidth) - 1) return false;
    const pen = document.createElement('canvas').getContext('2d');
    pen.font = style.font;
    return pen.measureText(one.selectedOptions[0]?.text ?? '').width + 36 > one.clientWidth;
}).map((one) => one.outerHTML.slice(0, 90))"""
"""Controls that reach out of the window, or whose words do not fit; an arrow and its room take 36 pixels."""


@pytest.mark.parametrize("size", [(1280, 720), (1280, 800), (1024, 700), (1600, 1000)])
def test_no_control_is_cut_off_on_usual_screens(studio, size):
    page = studio.page
    page.set_viewport_size({"width": size[0], "height": size[1]})
    studio.step_beyond(25)
    studio.pause()
    found = {"page": studio.ask(CUT)}
    for number, view in enumerate(("Section", "Measures", "Space–time", "Log"), 1):
        page.keyboard.press(str(number))
        found[view] = studio.ask(CUT)
    page.keyboard.press("4")
    for name in SHEETS:
        studio.ask("document.querySelector('.menu').open = true")
        found[f"menu before {name}"] = studio.ask(CUT)
        page.get_by_role("menuitem", name=name).evaluate("(item) => item.click()")
        page.locator("dialog[open]").wait_for()
        found[name] = studio.ask(CUT)
        studio.ask("document.querySelector('dialog[open]').close()")
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].ready")
    found["pair"] = studio.ask(CUT)
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")
    assert {name: list_ for name, list_ in found.items() if list_} == {}


def test_the_bar_is_one_row_and_gives_its_free_room_to_the_title(studio):
    page = studio.page
    page.set_viewport_size({"width": 1024, "height": 700})
    assert box(studio, ".bar")["height"] < 60
    page.set_viewport_size({"width": 1600, "height": 1000})
    title = studio.ask("window.barchan.app.current.description.scenario.title")
    assert title.endswith("changed: lattice.columns 64, lattice.rows 48")
    cut = "(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth)(document.querySelector('.title'))"
    assert not studio.ask(cut)
    assert page.locator(".title").get_attribute("title") == page.locator(".title").inner_text()


def test_the_letters_of_the_dial_are_not_selected_while_it_is_turned(studio):
    page = studio.page
    page.get_by_role("tab", name="Wind").click()
    dial = box(studio, "svg.dial")
    across, down = dial["x"] + dial["width"] / 2, dial["y"] + dial["height"] / 2
    page.mouse.move(across, dial["y"] + 12)
    page.mouse.down()
    page.mouse.move(across + 45, down, steps=4)
    page.mouse.move(across, down + 60, steps=4)
    page.mouse.up()
    assert studio.ask("getSelection().toString()") == ""


def test_the_tour_covers_neither_scale_nor_values_nor_controls(studio):
    page = studio.page
    page.set_viewport_size({"width": 1024, "height": 700})
    studio.ask("window.barchan.app.view.set({ field: 'elevation' })")
    studio.ask("window.barchan.tour.begin()")
    tour = box(studio, ".tour")
    for part in (".scene", ".timeline", ".dock", ".bar"):
        other = box(studio, part)
        assert other["y"] + other["height"] <= tour["y"] + 1 or tour["y"] + tour["height"] <= other["y"] + 1
    studio.ask("window.barchan.tour.end()")
    studio.ask("window.barchan.app.view.set({ field: 'natural' })")


def focused(studio) -> str:
    return studio.ask("document.activeElement.textContent")


def test_arrow_keys_move_between_tabs_and_in_menus_and_escape_closes_them(studio):
    page = studio.page
    page.get_by_role("tab", name="Scenario").focus()
    page.keyboard.press("ArrowRight")
    assert focused(studio) == "Wind"
    assert page.locator("[data-path='wind.kind']").is_visible()
    page.keyboard.press("End")
    assert focused(studio) == "Moments"
    assert page.locator("[role=tab][tabindex='0']").count() == 2  # one of the panel, one of the drawer
    page.locator("summary", has_text="File").focus()
    page.keyboard.press("Enter")
    studio.until("document.activeElement.role === 'menuitem'")
    page.keyboard.press("ArrowUp")
    assert focused(studio).startswith("Let others watch")
    page.keyboard.press("Escape")
    assert page.locator(".menu[open]").count() == 0
    assert focused(studio) == "File"


def box(studio, selector: str) -> dict:
    return studio.page.locator(selector).first.bounding_box()


def test_rows_show_their_numbers_whole_beside_sliders_wide_enough_to_drag(studio):
    page = studio.page
    page.set_viewport_size({"width": 1280, "height": 720})
    for details in page.locator(".panel details").all():
        details.evaluate("(one) => (one.open = true)")
    cut = """[...document.querySelectorAll('.panel .control .number')]
        .filter((one) => one.clientWidth > 0 && one.scrollWidth > one.clientWidth)
        .map((one) => one.dataset.path)"""
    assert studio.ask(cut) == []
    edge = box(studio, ".panel")["x"] + box(studio, ".panel")["width"]
    beyond = f"""[...document.querySelectorAll('.panel .page:not([hidden]) .row *')]
        .filter((one) => one.getBoundingClientRect().right > {edge})
        .map((one) => one.outerHTML.slice(0, 100))"""
    assert studio.ask(beyond) == []
    sliders = "[...document.querySelectorAll('.panel input[type=range]')]"
    assert studio.ask(f"Math.min(...{sliders}.map((one) => one.clientWidth || 99))") >= 56


def test_the_panel_folds_widens_and_is_remembered(studio):
    page = studio.page
    page.set_viewport_size({"width": 1280, "height": 720})
    page.get_by_role("button", name="Panel (N)").click()
    studio.until("document.querySelector('.panel').clientWidth === 0")
    assert box(studio, ".scene")["width"] == 1280
    page.keyboard.press("n")
    edge = page.get_by_role("separator", name="Width of the panel")
    wide = box(studio, ".panel")["width"]
    edge.focus()
    page.keyboard.press("ArrowLeft")
    assert box(studio, ".panel")["width"] == wide + 20
    page.reload()
    studio.step_beyond(-1)
    assert box(studio, ".panel")["width"] == wide + 20


def test_the_scene_keeps_its_room_on_small_screens(studio):
    page = studio.page
    for width, height in ((1024, 700), (820, 1100), (390, 800)):
        page.set_viewport_size({"width": width, "height": height})
        scene = box(studio, ".scene")
        assert scene["width"] >= min(width, 640)
        assert scene["height"] >= height / 2
        assert studio.ask("document.documentElement.scrollWidth") == width
        if not page.locator(".panel").is_visible():
            page.get_by_role("button", name="Panel (N)").click()
            assert box(studio, ".scene") == scene  # the panel lies over it
        page.locator("[data-path='model.hop_length']").wait_for()
        if width < 1000:
            page.get_by_role("button", name="Panel (N)").click()
