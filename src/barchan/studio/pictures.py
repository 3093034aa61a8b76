"""The small pictures of presets in the gallery: ``python -m barchan.studio.pictures [NAME …]`` draws them.

Each preset runs to its end, or for some seconds at most, and is opened in a studio, whose own picture it is.
It takes the built client, a Chromium and Playwright (extra ``dev``).
"""

import argparse
import base64
import io
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from PIL import Image

from barchan.archive import run
from barchan.scenario import load_scenario, preset_names
from barchan.simulation import Simulation
from barchan.studio.server.gallery import showpiece

if TYPE_CHECKING:
    from playwright.sync_api import Page

FOLDER = Path(__file__).parents[1] / "presets" / "pictures"
WIDTH, HEIGHT = 320, 200
FINER = 2
"""Times as many pixels are drawn as are kept, so that edges are smooth."""
LARGEST = 15_000
"""Bytes of a picture at most: it is saved with less quality where it would be larger."""
SEED = 1
PATIENCE = 20.0
"""Seconds that a preset may run, at most."""

FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
RUN = "window.barchan.app.runs[0]"
RENDER = """async ([width, height]) => {
    const bytes = new Uint8Array(await (await window.barchan.stage.render({ width, height })).arrayBuffer());
    let text = "";
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return btoa(text);
}"""

TITLE = {"width": 3840, "height": 2160}


@contextmanager
def studio_page(folder: Path) -> Iterator["Page"]:
    """The page of a studio of its own, which opens the runs in a folder, as soon as it shows one."""
    with opened(folder) as (page, _):
        wait_for(page, f"window.barchan && {RUN}?.ready", 60.0)
        page.evaluate("window.barchan.app.view.set({ turning: false, theme: 'light' })")
        yield page


@contextmanager
def opened(folder: Path, size: tuple[int, int] = (320, 240)) -> Iterator[tuple["Page", float]]:
    """The page of a studio of its own, which shows nothing yet, and the moment when it was opened."""
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as data, _server(folder, data) as address, sync_playwright() as engine:
        path = shutil.which("chromium") or shutil.which("google-chrome")
        browser = engine.chromium.launch(executable_path=path, args=FLAGS)
        page = browser.new_page(viewport={"width": size[0], "height": size[1]})
        began = time.perf_counter()
        page.goto(address)
        yield page, began
        browser.close()


@contextmanager
def _server(folder: Path, data: str) -> Iterator[str]:
    """A server of the studio that keeps what it keeps by itself in a folder of its own; its address."""
    start = [sys.executable, "-c", "from barchan.cli import main; main()", "studio", showpiece()]
    server = subprocess.Popen(  # noqa: S603
        [*start, "--no-browser", "--port", "0", "--folder", str(folder)],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "XDG_DATA_HOME": data},
    )
    assert server.stdout is not None
    try:
        yield next(found[0] for line in server.stdout if (found := re.search(r"http://\S+", line)))
    finally:
        server.send_signal(signal.SIGINT)
        server.wait(20)


def wait_for(page: "Page", expression: str, seconds: float) -> None:
    """Wait until an expression holds, for so many seconds at most."""
    end = time.monotonic() + seconds
    while not page.evaluate(expression) and time.monotonic() < end:
        time.sleep(0.1)


def run_preset(page: "Page", folder: Path, name: str, patience: float) -> int:
    """Run a preset to its end, or for so many seconds, and look at it; returns the step where it stands."""
    simulation = Simulation(load_scenario(name, [("run.seed", str(SEED))]))
    end = math.inf

    def stop() -> bool:
        nonlocal end
        if end == math.inf and simulation.steps_done > 0:  # kernels are compiled
            end = time.monotonic() + patience
        return time.monotonic() > end

    run(simulation, folder / name, stop=stop)
    if not page.evaluate("(name) => window.barchan.app.ask({ command: 'open', name })", name):
        raise SystemExit(f"the studio does not open the run of {name}")
    title, step = json.dumps(simulation.scenario.title), simulation.steps_done
    own = f"{RUN}.description?.scenario.title === {title} && {RUN}.status?.step === {step}"
    wait_for(page, f"{RUN}.fits && {own}", 60.0)
    page.evaluate("window.barchan.stage.look('oblique')")
    return step


def rendered(page: "Page", width: int, height: int) -> Image.Image:
    """The scene as the studio draws it, in any size."""
    data = base64.b64decode(page.evaluate(RENDER, [width, height]))
    return Image.open(io.BytesIO(data)).convert("RGB")


def save(image: Image.Image, path: Path, largest: int) -> None:
    """Save as WebP, with as much quality as fits into a number of bytes."""
    for quality in range(88, 30, -6):
        image.save(path, quality=quality, method=6)
        if path.stat().st_size <= largest:
            return


def draw(names: list[str], patience: float) -> None:
    """Draw the pictures of these presets, or of all, that run for so many seconds at most."""
    FOLDER.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder, studio_page(Path(folder)) as page:
        for name in names or preset_names():
            step = run_preset(page, Path(folder), name, patience)
            image = rendered(page, FINER * WIDTH, FINER * HEIGHT)
            small = image.resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS)
            save(small, FOLDER / f"{name}.webp", LARGEST)
            sys.stdout.write(f"{name}: step {step}\n")
            sys.stdout.flush()


def draw_title(path: Path) -> None:
    """Draw the title picture, at most half a megabyte."""
    with tempfile.TemporaryDirectory() as folder, studio_page(Path(folder)) as page:
        run_preset(page, Path(folder), showpiece(), 300.0)
        save(rendered(page, TITLE["width"], TITLE["height"]), path, 500_000)


def main() -> None:
    """Draw what the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="preset; all where none is given")
    seconds = "seconds that each may run at most"
    parser.add_argument("--patience", type=float, default=PATIENCE, help=seconds)
    parser.add_argument("--title", type=Path, metavar="FILE", help="draw the README's title picture instead")
    asked = parser.parse_args()
    if asked.title:
        draw_title(asked.title)
    else:
        draw(asked.names, asked.patience)


if __name__ == "__main__":
    main()
