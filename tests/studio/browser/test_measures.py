"""What comes out of the page as numbers: measures at fixed steps and sections, of one run or of both."""

import csv
import io

import pytest

SMALL_PAIR = "window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].ready"


def saved(studio, label: str) -> list[dict[str, str]]:
    with studio.page.expect_download() as download:
        studio.page.get_by_label(label).click()
    return list(csv.DictReader(io.StringIO(download.value.path().read_text("utf-8"))))


@pytest.mark.extended
def test_tables_are_named_by_the_title_of_the_run(studio):
    page = studio.page
    names = []
    studio.pause()
    for view, what in (("1", "section"), ("2", "measures")):
        page.keyboard.press(view)
        with page.expect_download() as download:
            page.get_by_role("button", name=f"save CSV: Save the {what} as CSV").click()
        names.append(download.value.suggested_filename)
    page.keyboard.press("2")
    assert names == [f"barchans-section-{studio.status()['step']}.csv", "barchans-measures.csv"]


@pytest.mark.extended
def test_the_measures_of_both_runs_are_saved_at_the_same_fixed_steps(studio):
    page = studio.page
    page.get_by_role("tab", name="Measures").click()
    assert "every 10 steps; from step 2" in page.locator(".series .readout").inner_text()
    studio.ask("window.barchan.app.ask({ command: 'compare', model: 'momiji' })")
    studio.until(f"{SMALL_PAIR} && window.barchan.app.runs[1].status?.step > 25")
    studio.ask("window.barchan.app.send({ command: 'pause' })")
    studio.until("!window.barchan.app.running")
    rows = saved(studio, "Save the measures as CSV")
    steps = {run: [int(row["step"]) for row in rows if row["run"] == run] for run in "AB"}
    assert steps["A"][:3] == [0, 10, 20]
    assert steps["A"] == steps["B"]
    assert {row["model"] for row in rows} == {"werner", "momiji"}
    now = studio.status()["step"]
    studio.until(f"window.barchan.app.runs.every((run) => run.measures.at(-1).step === {now})")
    page.get_by_role("tab", name="Section").click()
    page.wait_for_timeout(300)
    profile = saved(studio, "Save the section as CSV")
    assert {"elevation_a_m", "elevation_b_m", "slope_b_degrees"} <= set(profile[0])
    assert [row["elevation_a_m"] for row in profile] != [row["elevation_b_m"] for row in profile]
    page.screenshot(path=studio.folder / "section-of-both.png")
    studio.ask("window.barchan.app.send({ command: 'alone' })")


@pytest.mark.extended
def test_saving_shows_how_far_it_is_while_the_run_goes_on(studio):
    studio.ask("window.barchan.app.send({ command: 'limit', rate: 30 })")  # few states, and quickly written
    studio.ask("window.barchan.app.send({ command: 'restart' })")
    studio.until(
        "window.barchan.app.runs[0].history.length < 9 && window.barchan.app.runs[0].status?.step > 30"
    )
    studio.ask(
        """window.seen = [];
        window.barchan.app.connection.ask(
            { command: 'save', name: 'beside', run: 'a' },
            (done, of) => window.seen.push([done, of, window.barchan.app.runs[0].status.step]),
        ).then((answer) => (window.saved = answer))"""
    )
    studio.until("window.saved !== undefined")
    saved_at, seen = studio.ask("window.saved.step"), studio.ask("window.seen")
    assert studio.ask("window.saved.frames") == seen[-1][1]
    assert [row[0] for row in seen] == sorted(row[0] for row in seen)
    studio.step_beyond(saved_at)
    studio.ask("window.barchan.app.send({ command: 'limit', rate: null })")


@pytest.mark.extended
def test_a_measure_without_a_value_says_why_and_whether_it_will_have_one(studio):
    """A cycle of 34 steps fits none of the multiples of 10 that are compared; one of 200 outlasts its run."""
    page = studio.page
    page.get_by_role("tab", name="Measures").click()
    caption = page.locator(".series figcaption", has_text="migration downwind")
    begin = """(steps, turns) => {
        const { app } = window.barchan;
        const { scenario } = app.current.description;
        const regimes = [0, 90].map((direction) => ({ direction, steps: turns }));
        const wind = { kind: "regimes", regimes };
        return app.create({ ...scenario, wind, run: { ...scenario.run, steps } });
    }"""
    studio.ask(f"({begin})(100000, 17)")
    no_frame = "no value: no frame is whole cycles of the wind"
    caption.filter(has_text=f"{no_frame} (34 steps) after another").wait_for()
    assert "run › save every" in caption.inner_text()
    assert "m/step" not in caption.inner_text()
    studio.ask(f"({begin})(10, 100)")
    caption.filter(has_text=f"{no_frame} (200 steps) earlier").wait_for()
