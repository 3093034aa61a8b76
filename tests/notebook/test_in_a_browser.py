"""The view in a real browser: the shipped module, with a model that stands for Jupyter's."""

import base64
import io
import json
import time

import numpy as np
import pytest
from PIL import Image

from barchan.studio.server.app import CLIENT
from tests.studio.browser.conftest import launched
from tests.tiny import tiny

pytest.importorskip("anywidget")

PATIENCE = 30.0
PLACE = "http://notebook.test"
SYNCED = ("description", "colours", "continues", "field", "height")
ROOT = "document.querySelector('.barchan-view').shadowRoot"
FRAMES = ("ground_frame", "frame")
PAGE = """<!doctype html><body><div id="cell" style="width: 460px"></div><script type="module">
import widget from "./notebook.js";
const listeners = {};
const values = {};
const call = (name, ...given) => (listeners[name] ?? []).forEach((listener) => listener(...given));
const bytes = (text) => new DataView(Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0)).buffer);
window.sent = [];
window.take = (name, value, binary) => {
    values[name] = binary ? bytes(value) : value;
    call(`change:${name}`);
};
window.tell = (message) => call("msg:custom", message, []);
const model = {
    get: (name) => values[name],
    set: (name, value) => { values[name] = value; call(`change:${name}`); },
    save_changes: () => {},
    on: (name, listener) => (listeners[name] ??= []).push(listener),
    off: (name, listener) => (listeners[name] = listeners[name].filter((one) => one !== listener)),
    send: (content) => window.sent.push(content),
};
window.values = values;
window.listening = () => Object.values(listeners).flat().length;
window.show = () => (window.end = widget.render({ model, el: document.getElementById("cell") }));
window.loaded = true;
</script></body>"""


class Notebook:
    """A page with one cell, and the widget that it belongs to."""

    def __init__(self, page, view):
        self.page, self.view, self.known = page, view, {}
        self.carry()
        page.evaluate("void window.show()")

    def carry(self):
        """Carry what has changed both ways, as Jupyter would."""
        for name in (*SYNCED, *FRAMES):
            value = getattr(self.view, name)
            if self.known.get(name) is not value:
                self.known[name] = value
                text = base64.b64encode(value).decode() if name in FRAMES else value
                self.page.evaluate("(given) => window.take(...given)", [name, text, name in FRAMES])
        for content in self.page.evaluate("window.sent.splice(0)"):
            self.view._handle_custom_msg(content, [])

    def until(self, expression):
        end = time.monotonic() + PATIENCE
        asked = f"(() => {{ const root = {ROOT}; return {expression}; }})()"
        while not self.page.evaluate(asked):
            assert time.monotonic() < end, expression
            self.carry()
            time.sleep(0.02)

    def colours(self):
        """How many colours the scene has."""
        shot = Image.open(io.BytesIO(self.page.locator(".barchan-view canvas").first.screenshot()))
        return len(np.unique(np.asarray(shot.convert("RGB")).reshape(-1, 3), axis=0))


@pytest.fixture(scope="module")
def chromium():
    with launched() as browser:
        yield browser


@pytest.fixture
def notebook(chromium):
    """Shows a view on a page that has no server behind it."""
    from barchan.notebook import view as make

    page = chromium.new_page(viewport={"width": 500, "height": 400})
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    module = (CLIENT / "notebook.js").read_text("utf-8")
    page.route(f"{PLACE}/", lambda route: route.fulfill(body=PAGE, content_type="text/html"))
    page.route(
        f"{PLACE}/notebook.js", lambda route: route.fulfill(body=module, content_type="text/javascript")
    )
    page.goto(f"{PLACE}/")
    page.wait_for_function("window.loaded")
    made = []

    def shown(what, **options):
        made.append(make(what, **options))
        return Notebook(page, made[-1])

    yield shown
    for one in made:
        one.close()
    page.close()
    assert errors == []


@pytest.mark.extended
def test_a_simulation_runs_pauses_and_steps_in_its_cell(notebook):
    cell = notebook(tiny(run__steps=100_000), height=200)
    cell.until("root.querySelector('.step').textContent.startsWith('step 0')")
    cell.page.get_by_role("button", name="One step").click()
    cell.until("root.querySelector('.step').textContent.startsWith('step 1')")
    cell.page.get_by_role("button", name="Run", exact=True).click()
    cell.until("parseInt(root.querySelector('.step').textContent.slice(5)) > 10")
    cell.page.get_by_role("button", name="Pause").click()
    cell.until("root.querySelector('[title=Run]')")
    assert cell.colours() > 100
    listening = cell.page.evaluate("window.listening()")
    cell.page.evaluate("window.end()")
    assert listening > 0
    assert cell.page.evaluate("window.listening()") == 0
    assert cell.page.evaluate("document.querySelector('.barchan-view')") is None


def test_frames_of_a_run_are_looked_at_with_the_slider_and_coloured_by_a_field(notebook):
    import barchan

    cell = notebook(barchan.simulate(tiny()), height=200)
    cell.until("root.querySelector('.step').textContent === 'step 20'")
    assert not cell.page.get_by_role("button", name="Run", exact=True).is_visible()
    slider = cell.page.get_by_role("slider", name="Look back through the run")
    slider.focus()
    slider.press("Home")
    cell.until("root.querySelector('.step').textContent === 'step 0'")
    cell.page.get_by_role("combobox", name="Field that colours the surface").select_option("slope")
    cell.until("root.querySelector('.bar-title').textContent.includes('slope')")
    assert json.loads(cell.page.evaluate("JSON.stringify(window.values.field)")) == "slope"
