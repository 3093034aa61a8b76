"""The page for eyes and screen readers, in every state: contrast, names, order."""

import os
from functools import partial
from importlib.resources import files
from pathlib import Path

import pytest

from tests.studio.browser.conftest import running, says
from tests.studio.browser.test_connection import NO_WEBGL
from tests.studio.browser.test_sharing import watch_link

LOOK = os.environ.get("BARCHAN_LOOK")
STATES = (
    "no token",
    "wrong token",
    "replaced",
    "too much",
    "full",
    "other version",
    "no answer",
    "connecting",
)
RULES = """{
    runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'],
    rules: { 'label-content-name-mismatch': { enabled: true } },
    resultTypes: ['violations'],
}"""


def look(page, name: str) -> None:
    """Keep a picture of the page to look at, where a folder for that is stated."""
    if LOOK:
        page.screenshot(path=Path(LOOK) / f"{name}.png")


def faults_of(page, part: str = "html") -> list[str]:
    """What axe-core finds wrong with a page, or a part of it, as it is now."""
    pytest.importorskip("axe_playwright_python")
    if not page.evaluate("'axe' in window"):
        axe = files("axe_playwright_python").joinpath("axe.min.js").read_text("utf-8")
        page.evaluate(f"void (() => {{ {axe} }})()")
    results = page.evaluate(f"axe.run('{part}', {RULES})")
    nodes = [(one["id"], node["html"]) for one in results["violations"] for node in one["nodes"]]
    return [f"{rule}: {html[:150]}" for rule, html in nodes]


@pytest.fixture
def faults(studio):
    return partial(faults_of, studio.page)


@pytest.mark.extended
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


@pytest.mark.parametrize("theme", ["light", pytest.param("dark", marks=pytest.mark.extended)])
def test_notices_and_refusals_can_be_read_in_every_state(studio, faults, theme):
    studio.ask(f"window.barchan.app.view.set({{ theme: '{theme}' }})")
    studio.pause()
    lost = "(window.barchan.app.graphicsLost = {}, window.barchan.app.changed.send())"
    studio.ask(f"void {lost.format('true')}")
    says(studio.page, "taken the graphics card away")
    assert faults(".messages") == []
    studio.ask(f"void {lost.format('false')}")
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


@pytest.mark.extended
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_window_that_watches_can_be_read_and_is_named(studio, visit, server, theme):
    studio.pause()
    page = visit(watch_link(server[1]))
    running(page)
    page.evaluate(f"window.barchan.app.view.set({{ theme: '{theme}' }})")
    found = {"all": faults_of(page)}
    for tab in page.locator(".dock [role=tab]").all():
        tab.click()
        found[tab.inner_text()] = faults_of(page, ".dock")
    look(page, f"watching-{theme}")
    assert {name: list_ for name, list_ in found.items() if list_} == {}


@pytest.mark.extended
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_page_without_webgl_can_be_read_and_is_named(chromium, server, theme):
    page = chromium.new_page(viewport={"width": 1000, "height": 640})
    try:
        page.add_init_script(NO_WEBGL)
        page.goto(server[1])
        says(page, "WebGL is off or missing")
        page.evaluate(f"window.barchan.app.view.set({{ theme: '{theme}' }})")
        assert faults_of(page) == []
        look(page, f"no-webgl-{theme}")
    finally:
        page.close()


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


@pytest.mark.extended
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


@pytest.mark.extended
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
