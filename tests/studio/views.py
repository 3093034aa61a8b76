"""Pictures of every view of the studio, to look at: ``python -m tests.studio.views FOLDER [VIEW …]``.

Each view is drawn in three sizes of window, light and dark, on one sheet: ``FOLDER/VIEW.png``. It takes the
built client, a Chromium and Playwright (extra ``dev``).
"""

import io
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from PIL import Image

from barchan.studio.pictures import RUN, studio_page, wait_for
from tests.studio.browser.test_access import SHEETS
from tests.studio.browser.test_connection import NO_WEBGL

SIZES = ((1280, 720), (1600, 1000), (1024, 700))
THEMES = ("light", "dark")
APP = "window.barchan.app"
FIELD = """{ barchan: 5, title: 'Barchans in an oblique wind', lattice: { rows: 96, columns: 96 },
    sand: { kind: 'flat', mean: 3 }, wind: { kind: 'steady', direction: 285 },
    model: { name: 'momiji' }, run: { steps: 300, seed: 1 } }"""
SNOW, SNOW_STEPS = "snow-growth", 4000
CHAINS = ("pair", "snow")
"""Beginnings of the names of views each of which needs the one before it."""
PATIENCE = 90.0
SETTLE = 400
"""Milliseconds in which a page takes its new size or theme."""


class Walk:
    """A page, and how each view is reached from the scene of a paused run with nothing open."""

    def __init__(self, page) -> None:
        self.page = self.shown = page
        """The page that commands, and the one of which pictures are drawn."""

    def begin(self) -> None:
        self.page.evaluate(f"void {APP}.create({FIELD}, true, false)")
        wait_for(self.page, f"{RUN}.status?.step >= 300 && !{APP}.running", PATIENCE)
        self.press("Backspace")
        self.page.evaluate(f"{APP}.view.set({{ turning: false }})")

    def press(self, key: str) -> None:
        self.page.keyboard.press(key)

    def tab(self, name: str) -> None:
        self.page.get_by_role("tab", name=name, exact=True).click()

    def sheet(self, name: str) -> None:
        self.page.evaluate("document.querySelector('.menu').open = true")
        self.page.get_by_role("menuitem", name=name).evaluate("(item) => item.click()")
        self.page.locator("dialog[open]").wait_for()

    def pair(self) -> None:
        self.page.evaluate(f"{APP}.send({{ command: 'compare', model: 'werner' }})")
        wait_for(self.page, f"{APP}.runs.length === 2 && {APP}.runs[1].status?.step >= 0", PATIENCE)
        self.page.evaluate(f"{APP}.send({{ command: 'run', steps: 60 }})")
        wait_for(self.page, f"{APP}.runs[1].status?.step >= 60 && !{APP}.running", PATIENCE)

    def alone(self) -> None:
        self.page.evaluate(f"{APP}.send({{ command: 'alone' }})")
        wait_for(self.page, f"{APP}.runs.length === 1", PATIENCE)

    def snow(self) -> None:
        self.page.evaluate(
            f"""{APP}.ask({{ command: 'preset', name: '{SNOW}' }}).then(({{ scenario }}) =>
            {APP}.create({{ ...scenario, run: {{ ...scenario.run, steps: {SNOW_STEPS} }} }}, true, false))"""
        )
        wait_for(self.page, f"{RUN}.description?.scenario.model.name === 'snow'", PATIENCE)
        self.page.evaluate(f"{APP}.send({{ command: 'limit', rate: null }})")
        wait_for(self.page, f"{RUN}.status?.step >= {SNOW_STEPS} && !{APP}.running", PATIENCE)

    def lose(self, lost: bool) -> None:
        """Let the page believe that the process of its run has ended, or that it is there again."""
        self.page.evaluate(f"{RUN}.lost = {str(lost).lower()}; {APP}.kept = 300; {APP}.changed.send()")

    def window(self, key: str, token: str, script: str = "") -> None:
        """Open a window of its own with a token, and show that one."""
        self.shown = self.page.context.browser.new_page()
        self.shown.add_init_script(script)
        self.shown.goto(f"{self.page.url.partition('?')[0].partition('#')[0]}?{key}={token}")
        wait_for(self.shown, f"window.barchan && {RUN}?.ready", PATIENCE)

    def watching(self) -> None:
        self.sheet("Let others watch")
        link = self.page.get_by_label("Link to watch", exact=True).input_value()
        self.close()
        self.window("watch", link.partition("watch=")[2])

    def without_webgl(self) -> None:
        """It takes the run over, so no view of the first page follows."""
        self.window("token", self.page.evaluate("sessionStorage['barchan-token']"), NO_WEBGL)

    def back(self) -> None:
        self.shown.close()
        self.shown = self.page

    def close(self) -> None:
        """Close what is open over the page."""
        self.page.evaluate("document.querySelectorAll('dialog[open]').forEach((one) => one.close())")
        self.page.evaluate("document.querySelectorAll('.menu').forEach((one) => (one.open = false))")

    def views(self) -> dict[str, tuple[Callable[[], None], Callable[[], None]]]:
        """Name of each view: how to reach it, and how to leave it."""
        page = self.page
        found = {
            "gallery": (
                lambda: (self.press("g"), page.locator(".card").first.wait_for()),
                lambda: self.press("Escape"),
            ),
            "scene": (lambda: None, lambda: None),
            "keys": (lambda: self.press("?"), self.close),
            "menu": (lambda: page.evaluate("document.querySelector('.menu').open = true"), self.close),
            "ruler": (lambda: self.press("m"), lambda: page.locator(".ruler input").first.press("Escape")),
            "refusal": (
                lambda: page.evaluate(
                    f"{APP}.notices.note('error', 'model › p_s: is 5; allowed: 0 to 1', 'model.p_s')"
                ),
                lambda: self.press("Backspace"),
            ),
            "full-screen": (lambda: self.press("f"), lambda: self.press("f")),
        }
        for tab in ("Wind", "Paint", "View", "Moments", "Scenario"):
            found[f"panel-{tab.lower()}"] = (lambda tab=tab: self.tab(tab), lambda: self.tab("Scenario"))
        for key, view in enumerate(("section", "measures", "space-time", "log"), 1):
            found[f"dock-{view}"] = (
                lambda key=key: self.press(str(key)),
                lambda key=key: self.press(str(key)),
            )
        for step in (1, 2, 3):
            found[f"tour-{step}"] = (
                lambda step=step: page.evaluate(
                    f"window.barchan.tour.begin(); window.barchan.tour.choose({step - 1})"
                ),
                lambda: page.evaluate("window.barchan.tour.end()"),
            )
        for name in SHEETS:
            found[f"sheet-{name}"] = (lambda name=name: self.sheet(name), self.close)
        for name, ask in (("ground", "askForGround"), ("record", "askForWind")):
            found[f"sheet-{name}"] = (
                lambda ask=ask: (
                    page.evaluate(f"void window.barchan.files.{ask}()"),
                    page.locator("dialog[open]").wait_for(),
                ),
                self.close,
            )
        found["lost"] = (lambda: self.lose(True), lambda: self.lose(False))
        found["watching"] = (self.watching, self.back)
        found["pair"] = (self.pair, lambda: None)
        for key, view in enumerate(("section", "measures", "space-time"), 1):
            found[f"pair-{view}"] = (
                lambda key=key: self.press(str(key)),
                lambda key=key: self.press(str(key)),
            )
        found["pair-report"] = (lambda: self.sheet("Comparison report"), lambda: (self.close(), self.alone()))
        found["snow"] = (self.snow, lambda: None)
        found["snow-section"] = (lambda: self.press("1"), lambda: self.press("1"))
        found["no-webgl"] = (self.without_webgl, self.back)
        return found


def sheet_of(page) -> Image.Image:
    """The view that is open, in every size and theme: light ones above, dark ones below."""
    widest = sum(width for width, _ in SIZES) + 10 * len(SIZES)
    tallest = max(height for _, height in SIZES) + 10
    sheet = Image.new("RGB", (widest, tallest * len(THEMES)), "#888")
    left = 0
    for width, height in SIZES:
        page.set_viewport_size({"width": width, "height": height})
        for row, theme in enumerate(THEMES):
            page.evaluate(f"{APP}.view.set({{ theme: '{theme}' }})")
            page.wait_for_timeout(SETTLE)
            shot = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
            sheet.paste(shot, (left, row * tallest))
        left += width + 10
    return sheet


def main() -> None:
    """Draw the views that are named, or all."""
    folder, *wanted = sys.argv[1:]
    Path(folder).mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as runs, studio_page(Path(runs)) as page:
        page.set_viewport_size({"width": SIZES[0][0], "height": SIZES[0][1]})
        walk = Walk(page)
        walk.begin()
        for name, (reach, leave) in walk.views().items():
            chain = next((one for one in CHAINS if name.startswith(one)), name)
            if wanted and not any(one.startswith(chain) for one in wanted):
                continue
            reach()
            page.wait_for_timeout(SETTLE)
            sheet_of(walk.shown).save(Path(folder) / f"{name}.png")
            sys.stdout.write(f"{name}\n")
            sys.stdout.flush()
            leave()


if __name__ == "__main__":
    main()
