"""The page for eyes, keys, fingers and screen readers: contrast, names, order, sizes of windows."""

import os
from importlib.resources import files
from pathlib import Path

import pytest

AXE = files("axe_playwright_python").joinpath("axe.min.js")
LOOK = os.environ.get("BARCHAN_LOOK")
STATES = ("no token", "wrong token", "replaced", "too much", "other version", "no answer", "connecting")
RULES = "{ runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'best-practice'], resultTypes: ['violations'] }"

pytestmark = pytest.mark.extended


def look(page, name: str) -> None:
    """Keep a picture of the page to look at, where a folder for that is stated."""
    if LOOK:
        page.screenshot(path=Path(LOOK) / f"{name}.png")


@pytest.fixture
def faults(studio):
    """What axe-core finds wrong with the page, or a part of it, as it is now."""
    pytest.importorskip("axe_playwright_python")

    def found(part: str = "html") -> list[str]:
        if not studio.ask("'axe' in window"):
            studio.ask(f"void (() => {{ {AXE.read_text('utf-8')} }})()")
        results = studio.ask(f"axe.run('{part}', {RULES})")
        nodes = [(one["id"], node["html"]) for one in results["violations"] for node in one["nodes"]]
        return [f"{rule}: {html[:150]}" for rule, html in nodes]

    return found


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_every_state_can_be_read_and_is_named(studio, faults, theme):
    page = studio.page
    studio.ask(f"window.barchan.app.view.set({{ theme: '{theme}' }})")
    studio.pause()
    assert faults() == []
    for tab in ("Wind", "Paint", "View"):
        page.get_by_role("tab", name=tab).click()
        assert faults(".panel") == []
    for view in ("Section", "Measures", "Space–time", "Log"):
        page.get_by_role("tab", name=view).click()
        assert faults(".dock") == []
    page.locator("summary", has_text="File").click()
    assert faults(".bar") == []
    page.keyboard.press("Escape")
    page.keyboard.press("?")
    assert faults("dialog") == []


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_notices_and_refusals_can_be_read_in_every_state(studio, faults, theme):
    studio.ask(f"window.barchan.app.view.set({{ theme: '{theme}' }})")
    studio.pause()
    studio.ask("window.barchan.app.notices.note('error', 'model › p_s: is 5', 'model.p_s')")
    # Frames on their way must not take the loss back.
    studio.ask(
        "void Object.defineProperty(window.barchan.app.runs[0], 'lost', { get: () => true, set: () => {} })"
    )
    studio.ask("window.barchan.app.changed.send()")
    studio.page.get_by_role("button", name="restart the run").wait_for()
    assert faults(".messages") == []
    for state in STATES:
        studio.ask(f"window.barchan.app.connection.state.send('{state}')")
        assert faults(".messages") == []
    studio.ask("window.barchan.app.connection.state.send('open')")
    studio.page.keyboard.press("g")
    studio.page.locator(".card").first.wait_for()
    assert faults(".gallery") == []


SHEETS = (
    "Export for other programs",
    "Film of what was just seen",
    "Record the scene",
    "Picture with title and scale",
    "Compare with a terrain or photograph",
    "Let others watch",
    "Copy a link of this scenario",
    "Open a link of a scenario",
    "Save the run",
    "Open a saved run",
)


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_every_sheet_can_be_read_and_is_named(studio, faults, theme):
    page = studio.page
    studio.ask(f"window.barchan.app.view.set({{ theme: '{theme}' }})")
    studio.step_beyond(25)
    studio.pause()
    found = {}
    for name in SHEETS:
        page.locator("summary", has_text="File").click()
        page.get_by_role("menuitem", name=name).click()
        page.locator("dialog").wait_for()
        studio.ask("document.querySelectorAll('dialog details').forEach((one) => (one.open = true))")
        found[name] = faults("dialog")
        look(page, f"sheet-{theme}-{name}")
        page.keyboard.press("Escape")
        page.locator("dialog").wait_for(state="detached")
    page.keyboard.press("m")
    found["ruler"] = faults(".ruler")
    page.locator(".ruler input").first.press("Escape")
    page.keyboard.press("k")
    page.get_by_role("tab", name="Moments").click()
    page.locator(".moment").first.wait_for()
    found["moments"] = faults(".panel")
    page.keyboard.press("v")
    page.get_by_role("button", name="begin", exact=True).click()
    page.get_by_text("recording 0:0").wait_for()
    found["recording"] = faults(".recording")
    look(page, f"recording-{theme}")
    page.get_by_role("button", name="discard").click()
    assert {name: list_ for name, list_ in found.items() if list_} == {}


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_two_runs_the_tour_and_every_drawer_can_be_read_and_are_named(studio, faults, theme):
    page = studio.page
    page.set_viewport_size({"width": 1280, "height": 720})
    studio.ask(f"window.barchan.app.view.set({{ theme: '{theme}', field: 'elevation' }})")
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 25")
    studio.pause()
    found = {}
    for view in ("Section", "Measures", "Space–time"):
        page.get_by_role("tab", name=view).click()
        found[view] = faults("html")
        look(page, f"pair-{theme}-{view}")
    page.get_by_role("tab", name="Space–time").click()
    studio.ask("window.barchan.tour.begin()")
    for step in ("1 of 3", "2 of 3", "3 of 3"):
        page.locator(".tour", has_text=step).wait_for()
        found[step] = faults(".tour")
        look(page, f"tour-{theme}-{step[0]}")
        if step != "3 of 3":
            studio.ask(f"window.barchan.tour.choose({step[0]})")
    studio.ask("window.barchan.tour.end()")
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Comparison report").click()
    found["report"] = faults("dialog")
    page.keyboard.press("Escape")
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")
    studio.ask("window.barchan.app.view.set({ theme: 'system', field: 'natural' })")
    assert {name: list_ for name, list_ in found.items() if list_} == {}


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
