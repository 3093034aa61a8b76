"""Two runs side by side: every picture, every pause and every look back shows both at the same step."""

import json

import numpy as np
import pytest
from PIL import Image

from barchan.scenario import load_scenario
from tests.studio.browser.conftest import SMALL
from tests.studio.browser.test_measures import saved
from tests.studio.browser.test_sharing import link_with
from tests.studio.browser.test_truth import LISTEN

WATCH = """(() => {
    const { app, stage } = window.barchan;
    window.pictures = [];
    stage.painted.watch(() => window.pictures.push(app.runs.map((run) => run.status?.step)));
})()"""
SAME = "window.barchan.app.runs[0].status.step === window.barchan.app.runs[1].status.step"


@pytest.fixture
def pair(studio):
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 20")
    yield studio
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


@pytest.mark.extended
def test_every_picture_of_two_runs_shows_the_same_step(pair):
    pair.ask(WATCH)
    pair.until("window.pictures.length > 20")
    pair.pause()
    assert pair.ask(SAME)
    pictures = pair.ask("window.pictures")
    apart = [steps for steps in pictures if steps[0] != steps[1]]
    assert apart == []
    assert pictures[-1][0] > pictures[0][0]


@pytest.mark.extended
def test_looking_back_in_mid_run_pauses_both_at_one_step_from_which_both_go_on(pair):
    pair.page.keyboard.press("PageUp")
    pair.until("window.barchan.app.runs.every((run) => run.status.looking) && !window.barchan.app.running")
    assert pair.ask(SAME)
    pair.page.keyboard.press("End")
    pair.until("window.barchan.app.runs.every((run) => !run.status.looking)")
    assert pair.ask(SAME)
    stood = pair.status()["step"]
    pair.page.keyboard.press("Space")
    pair.step_beyond(stood + 5)
    pair.pause()
    assert pair.ask(SAME)


@pytest.mark.extended
def test_a_wind_changed_in_mid_run_is_an_event_of_the_same_step_in_both(pair):
    wind = "{ kind: 'steady', direction: 240, speed: 5, unit: 'cells' }"
    pair.ask(f"window.barchan.app.ask({{ command: 'wind', wind: {wind} }})")
    pair.until("window.barchan.app.runs.every((run) => run.description.changes.length === 1)")
    first, second = pair.ask("window.barchan.app.runs.map((run) => run.description.changes[0].step)")
    assert first == second > 20


@pytest.mark.extended
def test_two_runs_whose_steps_last_differently_have_times_of_their_own_until_both_get_one_duration(studio):
    """A step moves the hop length times a slab of every cell, so it lasts 7/5 times as long with 7 cells."""
    page = studio.page
    studio.ask(
        """(() => {
            const { app } = window.barchan;
            const { scenario } = app.current.description;
            const wind = { kind: "record" };
            return app.create({ ...scenario, wind, clock: {}, run: { ...scenario.run, steps: 100000 } });
        })()"""
    )
    studio.until("window.barchan.app.runs[0].description?.step_seconds > 0")
    studio.ask("window.barchan.app.ask({ command: 'compare', key: 'model.hop_length', value: 7 })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 20")
    studio.pause()
    left, right = studio.ask("window.barchan.app.runs.map((run) => run.status.time)")
    assert right / left == pytest.approx(7 / 5)
    names = page.locator(".names span").all_inner_texts()
    assert all(" d " in name or " h" in name for name in names), names
    assert " | " in page.locator("[data-status=clock]").inner_text()
    said = page.locator(".toast", has_text="not at equal times")
    page.set_viewport_size({"width": 1280, "height": 720})
    studio.ask("document.querySelector('.wind-text').textContent = 'wind from 156° | 154°'")  # the widest
    box = "document.querySelector('{}').getBoundingClientRect()"
    studio.until(f"{box.format('.toast')}.right < {box.format('.wind-text')}.left")
    assert said.bounding_box()["x"] >= 0
    said.get_by_role("button", name="give both the same duration").click()
    lasting = "window.barchan.app.runs[0].description.step_seconds"
    at_one_time = f"run.status.step > 0 && Math.abs(run.status.time / run.status.step / {lasting} - 1) < 1e-9"
    studio.until(f"window.barchan.app.runs.every((run) => {at_one_time})")
    said.wait_for(state="detached")
    studio.pause()
    left, right = studio.ask("window.barchan.app.runs.map((run) => [run.status.time, run.status.wind])")
    assert left == right
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


LIMITS = "window.barchan.app.runs.map((run) => window.barchan.stage.terrain(run).colouring.limits)"


def colour_by(studio, name):
    studio.ask(f"window.barchan.app.view.set({{ field: '{name}' }})")
    studio.until(
        "window.barchan.app.runs.every((run) =>"
        f" window.barchan.stage.terrain(run).colouring?.title === '{name}')"
    )


@pytest.mark.extended
def test_both_surfaces_have_one_scale_of_colours_from_the_lowest_to_the_highest_of_both(pair):
    """Elevations are what the page holds of both runs, whose extremes the limits must be."""
    pair.pause()
    colour_by(pair, "elevation")
    first, second = pair.ask(LIMITS)
    surfaces = pair.ask(
        "window.barchan.app.runs.map((run) => [Math.min(...run.surface), Math.max(...run.surface)])"
    )
    assert first == second == [min(low for low, _ in surfaces), max(high for _, high in surfaces)]
    assert "both runs" in pair.page.locator(".colours:visible").inner_text()
    steep = pair.ask("window.barchan.app.runs.map((run) => window.barchan.stage.terrain(run).exaggeration)")
    assert steep[0] == steep[1]
    pair.ask("window.barchan.app.view.set({ field: 'natural' })")


@pytest.mark.extended
def test_a_surface_coloured_by_another_quantity_than_the_one_beside_it_has_a_scale_of_its_own(pair):
    pair.pause()
    colour_by(pair, "elevation")
    pair.ask(
        """(() => {
            const { stage, app } = window.barchan;
            const right = stage.terrain(app.runs[1]);
            right.colouring = { ...right.colouring, title: "soil", unit: "cm" };
            stage.painted.send();
        })()"""
    )
    shown = pair.page.locator(".colours:visible").all_inner_texts()
    assert [text.splitlines()[0] for text in shown] == ["elevation (m)", "soil (cm)"]
    pair.ask("window.barchan.app.view.set({ field: 'natural' })")


@pytest.mark.extended
def test_measures_and_section_name_both_runs_and_give_the_values_of_both(pair):
    page = pair.page
    page.set_viewport_size({"width": 1280, "height": 720})
    pair.until("window.barchan.app.runs.every((run) => run.measures.length >= 2)")
    pair.pause()
    page.keyboard.press("2")
    names = pair.ask("window.barchan.app.runs.map((run) => run.description.model.title)")
    assert page.locator(".run-names > span").all_inner_texts() == names
    pair.until(
        """(() => {
            const last = window.barchan.app.runs.map((run) => run.measures.at(-1).values.highest_stack);
            const captions = [...document.querySelectorAll("figcaption")];
            const said = captions.find((one) => one.textContent.includes("highest stack"));
            const shown = [...said.querySelectorAll("b")].map((one) => parseFloat(one.textContent));
            return JSON.stringify(shown) === JSON.stringify(last);
        })()"""
    )
    assert f"balance of {names[0]}" in page.locator(".balance").inner_text()
    page.keyboard.press("1")
    page.locator(".plot:visible").hover()
    readout = page.locator(".readout:visible").inner_text()
    assert all(f"{name}: elevation" in readout for name in names)
    page.keyboard.press("1")


DRAWING = """(() => {
    const canvas = CanvasRenderingContext2D.prototype;
    const listen = (name, note) => {
        canvas[name] = new Proxy(canvas[name], {
            apply: (act, c, given) => { note(c, given); return act.apply(c, given); },
        });
    };
    let points = 0;
    const clear = () => { [window.hatched, window.lines] = [[], []]; };
    clear();
    listen("beginPath", () => { points = 0; });
    listen("lineTo", () => { points += 1; });
    listen("moveTo", () => { points += 1; });
    listen("clearRect", (c) => c.canvas.matches(".plot") && clear());
    listen("fillRect", (c, given) => c.fillStyle instanceof CanvasPattern && window.hatched.push(given));
    listen("stroke", (c) => window.lines.push([c.strokeStyle, c.getLineDash().join(), points]));
})()"""
"""Note the hatched areas and the lines (colour, dashes, places) of the last drawing of the section."""


STRIP = 7
"""Pixels of the strip that tells the shadow zones of a run; their sign in the legend is one higher."""


@pytest.mark.extended
def test_the_section_marks_shadow_zones_and_steep_slopes_of_both_runs(pair):
    """Of the right run the hatched length is that of its shadow field in the row through the middle.

    Angles of repose are made so low that slopes of a young field are near them.
    """
    page = pair.page
    page.set_viewport_size({"width": 1280, "height": 720})
    pair.step_beyond(150)
    pair.pause()
    page.keyboard.press("1")
    pair.until("window.barchan.app.runs.every((run) => run.fields.has('shadow'))")
    pair.ask(LISTEN)
    pair.ask(DRAWING)
    rows = saved(pair, "Save the section as CSV")
    reposes = {"a": 5, "b": 4}
    for at, repose in enumerate(reposes.values()):
        pair.ask(f"void (window.barchan.app.runs[{at}].description.repose = {repose})")
    pair.ask("window.barchan.app.changed.send()")
    names = pair.ask("window.barchan.app.runs.map((run) => run.description.model.title)")
    words = pair.ask("window.words")
    assert {f"{name}, shadow zone" for name in names} <= set(words)
    assert "near the effective repose, 5.0° and 4.0°" in words
    shadow = np.array(pair.ask("[...window.barchan.app.runs[1].fields.get('shadow')]")).reshape(48, 64)
    dark = np.interp(np.linspace(0, 64, 1281) - 0.5, np.arange(64), shadow[24]) > 0.5
    plot = page.locator(".plot:visible").bounding_box()
    zones = [width for _, _, width, height in pair.ask("window.hatched") if height == STRIP]
    page.screenshot(path=pair.folder / "section-of-both.png")
    assert dark.mean() > 0.05
    assert sum(zones) / (plot["width"] - 54 - 14) == pytest.approx(dark.mean(), abs=0.02)
    steep = pair.ask("getComputedStyle(document.documentElement).getPropertyValue('--steep').trim()")
    for run, dashes in (("a", ""), ("b", "6,3")):
        steep_on = [abs(float(row[f"slope_{run}_degrees"])) >= 0.85 * reposes[run] for row in rows[:-1]]
        near = sum(one or other for one, other in zip([False, *steep_on], [*steep_on, False], strict=True))
        assert near > 0
        assert [steep, dashes, near] in pair.ask("window.lines")
    page.keyboard.press("1")


@pytest.mark.extended
def test_the_space_time_diagram_shows_and_saves_both_runs_or_either_on_one_scale(pair):
    page = pair.page
    page.set_viewport_size({"width": 1280, "height": 720})
    pair.step_beyond(60)
    pair.pause()
    pair.ask(LISTEN)
    page.keyboard.press("3")
    view = page.locator(".view:visible")
    names = pair.ask("window.barchan.app.runs.map((run) => run.description.model.title)")
    choice = view.get_by_label("Runs that are shown and saved")
    assert choice.locator("option").all_inner_texts() == ["both side by side", *names]
    pair.until(f"{names}.every((name) => window.words?.includes(name))")
    page.screenshot(path=pair.folder / "space-time-of-both.png")
    pictures = saved_files(page, "save picture", 2)
    step = pair.status()["step"]
    assert [name for name, _ in pictures] == [
        f"barchans-space-time-{step}-left-Werner-1995.png",
        f"barchans-space-time-{step}-right-Momiji-et-al.-2000.png",
    ]
    bars = [np.asarray(Image.open(path).convert("RGB"))[90:, -200:] for _, path in pictures]
    assert np.array_equal(*bars)  # the same numbers beside the same colours
    scale = view.locator(".readout").inner_text()
    assert scale.startswith("one scale: ")
    choice.select_option(names[1])
    assert view.locator(".readout").inner_text() == scale
    ((name, path),) = saved_files(page, "save CSV", 1)
    assert name == f"barchans-space-time-{step}-right-Momiji-et-al.-2000.csv"
    table = np.genfromtxt(path, delimiter=",")
    surface = np.array(pair.ask("[...window.barchan.app.runs[1].surface]")).reshape(48, 64)
    middle = np.interp(table[0, 1:] - 0.5, np.arange(64), surface[24])  # the row of the middle cell
    assert table[-1, 0] == step
    assert np.allclose(table[-1, 1:], middle, atol=1e-3)
    page.keyboard.press("3")


def saved_files(page, label: str, count: int) -> list[tuple[str, str]]:
    """Names and paths of the files that a button saves."""
    files = []

    def note(file) -> None:
        files.append(file)

    page.on("download", note)
    page.locator(".view:visible").get_by_text(label).click()
    while len(files) < count:
        page.wait_for_timeout(100)
    page.remove_listener("download", note)
    return [(file.suggested_filename, file.path()) for file in files]


@pytest.mark.extended
def test_two_values_side_by_side_are_told_apart_wherever_runs_are_named(studio):
    page = studio.page
    page.set_viewport_size({"width": 1280, "height": 720})
    title = page.locator(".bar .title").inner_text()
    assert "changed: " in title  # which both have in common
    studio.ask("window.barchan.app.ask({ command: 'compare', key: 'model.hop_length', value: 10 })")
    studio.until(
        "window.barchan.app.runs.length === 2"
        " && window.barchan.app.runs.every((run) => run.ready && run.measures.length >= 2)"
    )
    studio.ask("window.barchan.app.send({ command: 'pause' })")
    studio.until("!window.barchan.app.running")
    studio.picture()
    names = ["hop length 5", "hop length 10"]
    assert page.locator(".bar .model").text_content() == "  ·  ".join(names)
    assert page.locator(".bar .title").inner_text() == title
    assert [text.split(" · ")[0] for text in page.locator(".names span").all_inner_texts()] == names
    assert page.locator(".whose button").all_inner_texts() == [f"left: {names[0]}", f"right: {names[1]}"]
    page.keyboard.press("2")
    assert page.locator(".run-names > span").all_inner_texts() == names
    assert {row["run"]: row["name"] for row in saved(studio, "Save the measures as CSV")} == dict(
        zip("AB", names, strict=True)
    )
    page.keyboard.press("1")
    page.locator(".plot:visible").hover()
    readout = page.locator(".readout:visible").inner_text()
    assert all(f"{name}: elevation" in readout for name in names)
    row = saved(studio, "Save the section as CSV")[0]
    assert [row["name_a"], row["name_b"]] == names
    page.keyboard.press("1")
    page.screenshot(path=studio.folder / "two-values.png")
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


@pytest.mark.extended
def test_runs_of_equal_models_are_told_apart_by_whatever_else_differs(studio):
    """Runs as an opened pair may have them; of those that are alike nothing but the side is left."""
    told = """(other) => {
        const { app } = window.barchan;
        const run = Object.create(app.runs[0], { name: { value: "b" } });
        run.description = structuredClone(app.runs[0].description);
        other(run.description.scenario);
        app.runs.push(run);
        app.changed.send();
        const text = document.querySelector(".bar .model").textContent;
        app.runs.pop();
        return text;
    }"""
    studio.pause()
    for change, text in (
        ("(one) => (one.wind.direction = 225)", "direction 270  ·  direction 225"),
        ("(one) => (one.run.seed = 7)", "seed 3  ·  seed 7"),
        ("() => {}", "Werner 1995, left  ·  Werner 1995, right"),
    ):
        assert studio.ask(f"({told})({change})") == text


@pytest.mark.extended
def test_fields_that_were_looked_at_from_elsewhere_stay_whole_beside_one_another(studio):
    """A camera that was turned is moved back as the views become half as wide."""
    studio.pause()
    assert studio.ask("window.barchan.stage.fits")
    studio.drag((0.5, 0.5), (0.5, 0.5))
    assert studio.ask("window.barchan.stage.fits")  # a click moves nothing
    studio.drag((0.5, 0.5), (0.52, 0.5))
    assert not studio.ask("window.barchan.stage.fits")
    before = distance(studio)
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].ready")
    studio.picture()
    assert distance(studio) == pytest.approx(2 * before, rel=0.01)
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")
    studio.picture()
    assert distance(studio) == pytest.approx(before, rel=0.01)


def distance(studio) -> float:
    return studio.ask("window.barchan.stage.camera.position.distanceTo(window.barchan.stage.controls.target)")


SEEN = """(() => {
    const { stage, app } = window.barchan;
    const { min, max } = stage.terrain(app.runs[0]).box();
    const corners = [min.x, max.x].flatMap((x) => [min.z, max.z].map((z) => new min.constructor(x, 0, z)));
    const heights = corners.map((corner) => corner.project(stage.camera).y);
    return [Math.min(...heights), Math.max(...heights)];
})()"""
"""From where to where the field reaches in a view, of -1 at its lower edge and 1 at its upper one."""


@pytest.mark.extended
def test_the_field_fills_a_narrow_view_as_well(studio):
    """In half a window it filled a quarter of the height, in its lower half."""
    page = studio.page
    page.set_viewport_size({"width": 1280, "height": 720})
    studio.ask("window.barchan.app.ask({ command: 'compare', key: 'model.hop_length', value: 10 })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs.every((run) => run.ready)")
    studio.pause()
    page.keyboard.press("f")
    studio.picture()
    low, high = studio.ask(SEEN)
    page.keyboard.press("f")
    assert high - low > 0.9
    assert abs(high + low) < 0.4
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


@pytest.mark.extended
def test_a_preset_and_a_link_opened_from_two_values_run_alone_as_they_say(studio):
    page = studio.page
    linked = load_scenario("barchans", list({**SMALL, "title": '"As a link has it"'}.items())).data()
    link = link_with(json.dumps(linked).encode())

    def open_preset():
        page.get_by_role("button", name="Presets").first.click()
        page.locator("[data-preset=dome]").click()

    def open_link():
        studio.ask(f"void (location.hash = {json.dumps(link)})")
        page.get_by_role("button", name="start it").click()

    for begin, title in ((open_preset, "A dome dune"), (open_link, "As a link has it")):
        studio.ask("window.barchan.app.ask({ command: 'compare', key: 'model.hop_length', value: 10 })")
        studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 5")
        begin()
        page.get_by_role("button", name="let it end").click()
        studio.until(f"window.barchan.app.runs[0].description.scenario.title === '{title}'")
        studio.until("window.barchan.app.runs.length === 1 && window.barchan.app.running")
        assert studio.ask("window.barchan.app.runs[0].description.changes") == []
        hop = studio.ask("window.barchan.app.runs[0].description.scenario.model.hop_length")
        assert hop == 5


@pytest.mark.extended
def test_the_section_of_two_runs_is_drawn_the_same_whichever_panel_is_open_below_its_legend(pair):
    """A line of the legend takes 17 pixels and its foot 7: the plot begins below the lowest line."""
    page = pair.page
    page.set_viewport_size({"width": 1200, "height": 760})
    pair.step_beyond(60)
    pair.pause()
    page.keyboard.press("1")
    pair.until("window.barchan.app.runs.every((run) => run.fields.has('shadow'))")
    pair.ask(DRAWING)
    pair.ask(
        """void (CanvasRenderingContext2D.prototype.fillText = new Proxy(
            CanvasRenderingContext2D.prototype.fillText,
            { apply(draw, c, given) { (window.placed ??= []).push(given); return draw.apply(c, given); } }
        ))"""
    )
    drawn = []
    for panel in "ab":
        pair.ask(f"void (window.barchan.app.selected = '{panel}', window.barchan.app.changed.send())")
        drawn.append(page.locator(".plot:visible").evaluate("(canvas) => canvas.toDataURL()"))
    assert drawn[0] == drawn[1]
    legend = [y for text, _, y, *_ in pair.ask("window.placed") if text.endswith("shadow zone")]
    zones = [top for _, top, _, height in pair.ask("window.hatched") if height > 40]
    assert legend
    assert min(zones) > max(legend)
    page.screenshot(path=pair.folder / "section-below-legend.png")
    page.set_viewport_size({"width": 1024, "height": 700})
    pair.ask("void (window.placed = [], window.barchan.app.changed.send())")
    words = [one for one in pair.ask("window.placed") if "shadow zone" in one[0] or "repose" in one[0]]
    assert len({y for _, _, y, *_ in words}) in (1, 2)  # lines
    page.keyboard.press("2")
    pair.until("document.querySelectorAll('.run-names span').length === 2")
    ink, blue = (
        pair.ask(f"getComputedStyle(document.documentElement).getPropertyValue('--{name}').trim()")
        for name in ("ink", "second")
    )
    lines = {tuple(line[:2]) for line in pair.ask("window.lines") if line[2] > 100}
    assert {(ink, ""), (blue, "6,3")} <= lines
    colours = [
        pair.ask(f"getComputedStyle(document.querySelectorAll('.run-names > span')[{at}]).color")
        for at in (0, 1)
    ]
    assert colours == [f"rgb{tuple(int(one[at : at + 2], 16) for at in (1, 3, 5))}" for one in (ink, blue)]
    page.keyboard.press("2")
