"""After a studio was killed the next one offers its run, in the gallery and over the scene."""

import os
import re
import signal
import subprocess
import sys
from contextlib import contextmanager

import pytest

from barchan.measures import highest_stack
from barchan.scenario import load_scenario
from barchan.simulation import Simulation
from tests.studio.browser.conftest import SMALL, until
from tests.studio.server.test_autosave import step_on_disk
from tests.studio.server.test_autosave import until as wait_for

RUN = "window.barchan.app.runs[0]"

pytestmark = [
    pytest.mark.extended,
    pytest.mark.skipif(sys.platform != "linux", reason="the user's data are elsewhere"),
]


@contextmanager
def studio(tmp_path, name=None, steps="100000", more=None):
    """The studio as the command line starts it, with user data of its own: the process and its address."""
    values = [
        text
        for key, value in {**SMALL, "run.steps": steps, **(more or {})}.items()
        for text in (f"--{key}", value)
    ]
    names = [name, *values] if name else []
    command = [sys.executable, "-c", "from barchan.cli import main; main()", "studio", *names]
    options = ["--no-browser", "--port", "0", "--folder", str(tmp_path)]
    own = {**os.environ, "XDG_DATA_HOME": str(tmp_path)}
    process = subprocess.Popen([*command, *options], env=own, stdout=subprocess.PIPE, text=True)
    try:
        yield process, next(m[0] for line in process.stdout if (m := re.search(r"http://\S+", line)))
    finally:
        process.kill()
        process.wait(20)
        process.stdout.close()


def test_a_run_whose_studio_was_killed_is_offered_and_goes_on_where_it_stopped(tmp_path, visit):
    home = tmp_path / "barchan" / "studio-autosave"
    with studio(tmp_path, "barchans") as (process, address):
        page = visit(address)
        until(page, f"{RUN}?.status?.step > 20")
        page.keyboard.press("Space")
        until(page, "!window.barchan.app.running")
        step = page.evaluate(f"{RUN}.status.step")
        wait_for(lambda: step_on_disk(home) == step)
        os.kill(process.pid, signal.SIGKILL)
        page.close()
    with studio(tmp_path) as (_, address):
        page = visit(address)
        offer = page.locator("dialog .unfinished li")
        offer.wait_for()
        assert "Your run of “Barchans" in offer.inner_text()
        assert f"stopped at step {step} of 100\u202f000 on " in offer.inner_text()
        offer.get_by_role("button", name="open it").click()
        until(page, f"{RUN}.status?.step === {step} && !window.barchan.app.running")
        until(page, "!document.querySelector('dialog')")
        assert page.locator(".messages .unfinished li").count() == 0
        uninterrupted = Simulation(load_scenario("barchans", list(SMALL.items())))
        uninterrupted.advance(step)
        assert page.evaluate(f"{RUN}.status.highest") == highest_stack(uninterrupted.bed.stack)
        assert page.evaluate(f"{RUN}.status.volume") == uninterrupted.bed.volume


def test_an_offer_is_put_off_and_names_model_and_values_in_words(tmp_path, visit):
    home = tmp_path / "barchan" / "studio-autosave"
    with studio(tmp_path, "barchans", "20", {"model.name": "nield_baas"}) as (process, _):
        wait_for(lambda: step_on_disk(home) == 20)
        os.kill(process.pid, signal.SIGKILL)
    with studio(tmp_path, "barchans") as (_, address):
        page = visit(address)
        offer = page.locator(".messages .unfinished li")
        until(page, f"{RUN}?.status?.step >= 0")
        assert "model Nield" in offer.inner_text()
        assert "_" not in offer.inner_text()
        page.screenshot(path=tmp_path / "unfinished.png")
        offer.get_by_role("button", name="later").click()
        offer.wait_for(state="detached")
        page.keyboard.press("g")
        in_gallery = page.locator("dialog .unfinished li")
        in_gallery.wait_for()
        in_gallery.get_by_role("button", name="later").click()
        in_gallery.wait_for(state="detached")
        page.reload()
        offer.wait_for()


def test_a_run_that_is_discarded_is_not_offered_again(tmp_path, visit):
    home = tmp_path / "barchan" / "studio-autosave"
    with studio(tmp_path, "barchans", "20") as (process, _):
        wait_for(lambda: step_on_disk(home) == 20)
        os.kill(process.pid, signal.SIGKILL)
    with studio(tmp_path, "barchans") as (_, address):
        page = visit(address)
        offer = page.locator(".messages .unfinished li")
        offer.get_by_role("button", name="discard it").click()
        offer.get_by_role("button", name="discard it for good").click()
        until(page, "!document.querySelector('.unfinished li')")
        assert (
            page.evaluate("window.barchan.app.connection.fetch('unfinished').then((one) => one.unfinished)")
            == []
        )


def test_of_several_runs_the_last_is_offered_and_a_row_tells_of_the_others(tmp_path, visit):
    left = [
        {
            "name": f"left-{n}",
            "saved": f"2026-03-0{n}T12:00:00",
            "aside": n == 2,
            "here": False,
            "runs": [{"title": f"Dunes {n}", "model": "werner", "step": n, "steps": 9}],
        }
        for n in (4, 3, 2)
    ]
    with studio(tmp_path, "barchans") as (_, address):
        page = visit(address)
        page.route(
            re.compile("/unfinished"), lambda route: route.fulfill(json={"unfinished": left, "broken": []})
        )
        page.reload()
        rows = page.locator(".messages .unfinished li")
        rows.nth(1).wait_for()
        assert rows.count() == 2
        assert "“Dunes 4” stopped at step 4 of 9" in rows.nth(0).inner_text()
        assert "2 earlier runs are kept as well." in rows.nth(1).inner_text()
        rows.nth(1).get_by_role("button", name="show them").click()
        rows.nth(2).wait_for()
        assert "“Dunes 2” was set aside at step 2 of 9 on" in rows.nth(2).inner_text()
        page.reload()
        rows.nth(1).wait_for()
        rows.nth(1).get_by_role("button", name="later").click()
        rows.nth(1).wait_for(state="detached")
        assert "“Dunes 4”" in rows.nth(0).inner_text()
        rows.nth(0).get_by_role("button", name="later").click()
        rows.nth(0).wait_for(state="detached")


def test_a_run_whose_place_aside_another_one_takes_is_offered_by_the_presets(tmp_path, visit):
    with studio(tmp_path, "barchans") as (_, address):
        page = visit(address)
        for number, title in enumerate(("First", "Second", "Third")):
            until(page, f"{RUN}?.status?.step > 20")
            if number == 2:
                break
            scenario = f"{{ ...{RUN}.description.scenario, title: 'Dunes {title}' }}"
            page.evaluate(f"void window.barchan.app.create({scenario}, false)")
            until(page, f"{RUN}.description.scenario.title === 'Dunes {title}' && {RUN}.status.step === 0")
            page.evaluate("window.barchan.app.send({ command: 'run' })")
        log = "window.barchan.app.notices.log.map((entry) => entry.text).join()"
        until(
            page, f"{log}.includes('rows 48”, which was set aside before, is kept too: Presets offers it.')"
        )
        assert page.locator(".messages .unfinished li").count() == 0
        page.reload()
        until(page, f"{RUN}?.status?.step >= 0")
        page.wait_for_timeout(300)
        assert page.locator(".messages .unfinished li").count() == 0
        page.keyboard.press("g")
        offer = page.locator("dialog .unfinished li")
        offer.wait_for()
        assert "was set aside at step" in offer.inner_text()
        offer.get_by_role("button", name="open it").click()
        until(page, f"!{RUN}.description.scenario.title.startsWith('Dunes')")
        until(page, f"{log}.includes('“Dunes First”, which was set aside before, is kept too')")
