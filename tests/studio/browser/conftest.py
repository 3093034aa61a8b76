"""The studio as its users meet it: a server of its own, a real browser, small fields."""

import base64
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from barchan.scenario import load_scenario
from barchan.studio.server.app import CLIENT

FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
PATIENCE = 60.0
NOTICE = ".notice"
SMALL = {
    "lattice.rows": "48",
    "lattice.columns": "64",
    "run.seed": "3",
    "run.save_every": "10",
    "run.steps": "100000",  # no run ends by itself while the tests are at it
}


@contextmanager
def launched() -> Iterator[Any]:
    """A browser, closed at the end; the test is skipped without one, or fails where one is required."""
    if os.environ.get("BARCHAN_BROWSER") == "off":
        pytest.skip("BARCHAN_BROWSER is off")
    if not (CLIENT / "index.html").is_file():
        pytest.skip("the client is not built")
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as engine:
        path = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
        try:
            browser = engine.chromium.launch(executable_path=path, args=FLAGS)
        except playwright.Error as error:
            if os.environ.get("BARCHAN_BROWSER") == "required":
                raise
            pytest.skip(f"no browser: {error.message.splitlines()[0]}")
        yield browser
        browser.close()


@pytest.fixture(scope="package")
def chromium():
    with launched() as browser:
        yield browser


class Studio:
    """A page, and the questions of tests to it."""

    def __init__(self, page, process, folder: Path) -> None:
        self.page, self.process, self.folder = page, process, folder
        self.errors = []
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on("console", lambda said: said.type == "error" and self.errors.append(said.text))

    def ask(self, expression: str):
        return self.page.evaluate(expression)

    def until(self, expression: str) -> None:
        end = time.monotonic() + PATIENCE
        while not self.ask(expression):
            assert time.monotonic() < end, f"never: {expression}; {self.log()}"
            time.sleep(0.05)

    def catch_up(self) -> None:
        """Wait until the worker has carried out everything that was sent, and a frame has shown it."""
        asked = "window.barchan.app.ask({ command: 'rose', run: 'a' })"
        self.ask(f"{asked}.then(() => new Promise((done) => window.barchan.app.framed.watch(() => done(1))))")

    def until_logged(self, words: str) -> None:
        said = f"entry.text.includes({json.dumps(words)})"
        self.until(f"window.barchan.app.notices.log.some((entry) => {said})")

    def log(self) -> str:
        return self.ask("JSON.stringify(window.barchan?.app.notices.log.map((entry) => entry.text))")

    def status(self, run: int = 0) -> dict:
        return self.ask(f"window.barchan.app.runs[{run}]?.status ?? {{}}")

    def step_beyond(self, step: int) -> None:
        self.until(f"window.barchan?.app.runs[0]?.status?.step > {step}")

    def pause(self) -> None:
        self.until("window.barchan.app.running")
        self.page.keyboard.press("Space")
        self.until("!window.barchan.app.running")

    def picture(self) -> np.ndarray:
        drawn = self.ask("window.barchan.stage.drawn")
        self.ask("window.barchan.stage.redraw()")
        self.until(f"window.barchan.stage.drawn > {drawn}")
        shot = self.page.locator(".scene canvas").first.screenshot()
        return np.asarray(Image.open(io.BytesIO(shot)).convert("RGB")).astype(float)

    def drag(self, *places: tuple[float, float]) -> None:
        """Drag over the scene, places as shares of it."""
        box = self.page.locator(".scene canvas").first.bounding_box()
        points = [(box["x"] + x * box["width"], box["y"] + y * box["height"]) for x, y in places]
        self.page.mouse.move(*points[0])
        self.page.mouse.down()
        for point in points[1:]:
            self.page.mouse.move(*point, steps=4)
            time.sleep(0.06)
        self.page.mouse.up()

    def drop_file(self, name: str, kind: str, content: bytes) -> None:
        """Drop a file onto the scene."""
        data = base64.b64encode(content).decode()
        self.ask(
            f"""(() => {{
                const bytes = Uint8Array.from(atob("{data}"), (sign) => sign.charCodeAt(0));
                const transfer = new DataTransfer();
                transfer.items.add(new File([bytes], "{name}", {{ type: "{kind}" }}));
                const event = {{ bubbles: true, cancelable: true, dataTransfer: transfer }};
                const scene = document.querySelector(".scene");
                scene.dispatchEvent(new DragEvent("dragover", event));
                scene.dispatchEvent(new DragEvent("drop", event));
            }})()"""
        )


@pytest.fixture(scope="package")
def server(tmp_path_factory):
    """The studio as the command line starts it; it must leave nothing behind."""
    folder = tmp_path_factory.mktemp("runs")
    command = [sys.executable, "-c", "from barchan.cli import main; main()", "studio", "barchans"]
    values = [text for key, value in SMALL.items() for text in (f"--{key}", value)]
    options = [*values, "--no-browser", "--folder", str(folder)]
    own = {**os.environ, "XDG_DATA_HOME": str(folder / "data")}
    process = subprocess.Popen([*command, *options], stdout=subprocess.PIPE, text=True, env=own)
    address = next(found[0] for line in process.stdout if (found := re.search(r"http://\S+", line)))
    yield process, address, folder
    children = children_of(process.pid)
    process.send_signal(signal.SIGINT)
    process.wait(20)
    process.stdout.close()
    end = time.monotonic() + 10
    while any(map(is_alive, children)):
        assert time.monotonic() < end
        time.sleep(0.1)


@pytest.fixture
def studio(chromium, server):
    """A fresh page that restarts the same small field."""
    process, address, folder = server
    page = chromium.new_page(viewport={"width": 1000, "height": 640})
    studio = Studio(page, process, folder)
    page.goto(address)
    studio.step_beyond(-1)
    fresh = {**load_scenario("barchans", list(SMALL.items())).data(), "citation": str(uuid.uuid4())}
    studio.ask(f"window.barchan.app.create({json.dumps(fresh)}, true)")
    studio.until(f"window.barchan.app.runs[0].description.scenario.citation === '{fresh['citation']}'")
    studio.ask("window.barchan.app.send({ command: 'limit', rate: 40 })")  # a test before may have changed it
    studio.ask("void (window.barchan.app.runs[0].status = null)")
    studio.until("window.barchan.app.running")
    yield studio
    page.close()
    assert studio.errors == []


@pytest.fixture
def visit(chromium):
    """Open an address in a page of its own."""
    pages = []

    def open_page(address: str):
        pages.append(chromium.new_page(viewport={"width": 900, "height": 600}))
        pages[-1].goto(address)
        return pages[-1]

    yield open_page
    for page in pages:
        page.close()


def says(page, words: str) -> None:
    page.locator(NOTICE, has_text=words).wait_for()


def running(page) -> None:
    page.locator("[data-status=step]").filter(has_text=re.compile(r"\d")).wait_for(timeout=60_000)
    page.locator(NOTICE).wait_for(state="hidden")


def until(page, expression: str) -> None:
    """Wait until an expression of a page is true; the page itself may run no text as a program."""
    end = time.monotonic() + PATIENCE
    while not page.evaluate(expression):
        assert time.monotonic() < end, f"never: {expression}"
        time.sleep(0.05)


def children_of(pid: int) -> list[int]:
    path = Path(f"/proc/{pid}/task/{pid}/children")
    return [int(child) for child in path.read_text().split()] if path.is_file() else []


def is_alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().split()[2] != "Z"
    except FileNotFoundError:
        return False
