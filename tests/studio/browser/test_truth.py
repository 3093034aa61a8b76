"""Nothing that the studio shows says more than the run: colours, exaggeration, crests, the section's line."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from barchan.scenario import load_scenario

RUN = "window.barchan.app.runs[0]"
PLANTS = [("lattice.rows", "32"), ("lattice.columns", "48"), ("run.seed", "3"), ("run.save_every", "10")]

pytestmark = pytest.mark.extended


LISTEN = """void (CanvasRenderingContext2D.prototype.fillText = new Proxy(
    CanvasRenderingContext2D.prototype.fillText,
    { apply: (draw, c, words) => { (window.words ??= []).push(words[0]); return draw.apply(c, words); } }
))"""
"""Note the words that are written on canvases."""


def set_view(studio, **look):
    studio.ask(f"window.barchan.app.view.set({json.dumps(look)})")


def middle(picture):
    """The picture without what stands at its borders."""
    rows, columns, _ = picture.shape
    return picture[rows // 4 : -rows // 4, columns // 4 : -columns // 4]


def test_a_field_that_colours_the_surface_is_not_covered_by_plants(studio):
    scenario = load_scenario("nebkhas", PLANTS).data()
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, true)")
    grown = f"{RUN}.fields.get('effectiveness')?.some((share) => share > 0.3)"
    studio.until(f"{RUN}.description.scenario.title.startsWith('Nebkhas') && {grown}")
    studio.pause()
    studio.ask("window.barchan.stage.look('top')")
    set_view(studio, field="elevation", map="grey", shaded=False, bare=False, overlays=["effectiveness"])
    colours = middle(studio.picture())
    # A grey scale has red = green = blue; only edges of layers are coloured.
    assert np.mean(np.ptp(colours, axis=2) < 12) > 0.6
    set_view(studio, overlays=[])
    assert np.mean(np.ptp(middle(studio.picture()), axis=2) < 12) == 1.0


def test_colours_without_shading_are_those_of_the_scale(studio):
    studio.step_beyond(100)
    studio.pause()
    studio.ask("window.barchan.stage.look('top')")
    set_view(studio, field="elevation", map="grey", shaded=False, bare=False)
    low, high = studio.ask(f"window.barchan.stage.terrain({RUN}).colouring.limits")
    surface = studio.ask(f"[Math.min(...{RUN}.surface), Math.max(...{RUN}.surface)]")
    assert [low, high] == pytest.approx(surface)
    ends = studio.ask("[0, 63].map((at) => window.barchan.app.colours.grey[at][0])")
    seen = middle(studio.picture())
    assert ends[0] - 2 <= seen.min()
    assert seen.max() <= ends[1] + 2
    assert np.unique(seen).size > 4
    set_view(studio, shaded=True)
    assert middle(studio.picture()).max() <= ends[1] + 2  # shading never goes beyond the scale


def test_the_exaggeration_stands_beside_the_scale_bar_and_below_the_section(studio):
    studio.pause()
    for times, text in ((1, "heights to scale"), (7, "heights × 7")):
        set_view(studio, exaggeration=times)
        studio.picture()
        assert studio.page.locator(".steeper").inner_text() == text
    set_view(studio, exaggeration=None)
    studio.ask(LISTEN)
    studio.page.keyboard.press("1")
    studio.picture()
    assert any(str(word).startswith("heights ×") for word in studio.ask("window.words"))


def test_the_panel_tells_the_exaggeration_at_which_the_scene_is_drawn(studio):
    """Of a paused run, whatever chose it: nobody, the slider, or a relief that has become another one."""
    page = studio.page
    studio.pause()
    page.get_by_role("tab", name="View").click()
    row = page.locator(".row", has_text="vertical exaggeration")

    def same_as_beside_the_scale_bar() -> str:
        studio.picture()
        beside = page.locator(".steeper").inner_text().removeprefix("heights × ")
        assert row.get_by_role("spinbutton").input_value() == beside.replace("heights to scale", "1")
        return beside

    first = same_as_beside_the_scale_bar()
    page.get_by_label("vertical exaggeration").evaluate(
        "(slider) => { slider.value = Math.log(20); slider.dispatchEvent(new Event('input')); }"
    )
    assert same_as_beside_the_scale_bar() == "20"
    page.get_by_label("automatic", exact=True).check()
    assert same_as_beside_the_scale_bar() == first
    studio.ask(
        f"""(() => {{
            const run = {RUN};
            run.surface = run.surface.map((_, i) => 4 * Math.sin((2 * Math.PI * (i % 64)) / 16));
            window.barchan.app.changed.send();
        }})()"""
    )
    assert (
        same_as_beside_the_scale_bar() == "heights to scale" != first
    )  # 8 m over 16 m are steep as they are


def test_exaggeration_sun_and_light_are_typed_or_chosen_in_the_panel(studio):
    page = studio.page
    studio.pause()
    page.get_by_role("tab", name="View").click()
    for label, value in (
        ("Times as steep", "7"),
        ("Direction of the sun", "120"),
        ("Height of the sun", "31"),
    ):
        page.get_by_label(label, exact=True).fill(value)
        page.get_by_label(label, exact=True).press("Enter")
    assert studio.ask("window.barchan.stage.sun()") == {"azimuth": 120, "height": 31}
    page.get_by_label("light", exact=True).select_option("day")
    day = studio.picture().mean()
    assert page.locator(".steeper").inner_text() == "heights × 7"
    page.get_by_label("light", exact=True).select_option("dusk")
    assert studio.picture().mean() < 0.7 * day
    page.get_by_role("button", name="reset the view").click()


def test_exaggeration_is_chosen_from_relief_over_wavelength(studio):
    """Of a sine of height H and length L: 0.11 / (H / L), within 1 and 4 for forms that can be seen so."""
    studio.pause()
    for height, length, expected in ((2.0, 18.0, 1), (1.0, 25.0, 3), (0.5, 16.0, 4)):
        chosen = studio.ask(
            f"""(() => {{
                const run = {RUN}, terrain = window.barchan.stage.terrain(run);
                const phase = (i) => 2 * Math.PI * (i % 64) / {length};
                run.depth = run.depth.map((_, i) => 3 + {height} / 2 * Math.sin(phase(i)));
                run.ground = run.ground.map(() => 0);
                run.surface = Float32Array.from(run.depth);
                terrain.usual = Infinity;
                window.barchan.app.view.set({{ smoothing: 0, exaggeration: null }});
                return new Promise((done) =>
                    window.barchan.stage.painted.watch(() => done(terrain.exaggeration)));
            }})()"""
        )
        assert chosen == pytest.approx(expected, abs=0.5)


def test_roses_and_what_is_told_of_a_wind_are_those_of_the_wind_that_is_named_or_none(studio):
    page = studio.page
    page.get_by_role("tab", name="Wind").click()
    page.locator(".roses").wait_for()
    assert "dunes to expect" in page.locator("#wind-words").inner_text()
    studio.ask(
        """(() => {
            const { connection } = window.barchan.app;
            const ask = connection.ask.bind(connection);
            connection.ask = (...one) => (one[0].command === "rose" ? new Promise(() => {}) : ask(...one));
        })()"""
    )
    studio.ask("window.barchan.app.ask({ command: 'wind', wind: { kind: 'steady', direction: 90 } })")
    page.locator("[data-rose]", has_text="are being prepared").wait_for()
    assert page.locator(".roses").count() == 0


def test_a_section_between_typed_ends_gives_the_places_of_its_points_in_field_and_map(studio):
    """The corner stands in for that of a terrain with coordinates, of which the run has none."""
    page = studio.page
    studio.pause()
    page.keyboard.press("1")
    studio.ask(
        """(() => {
            const { app } = window.barchan;
            app.current.description.place = { west: 400000, south: 5300000, crs: "EPSG:32633" };
            app.changed.send();
        })()"""
    )
    boxes = page.locator(".ends input").all()
    for box, text in zip(boxes, ("400002", "5300004", "400032", "5300044"), strict=True):
        box.fill(text)
        box.press("Tab")
    boxes[2].fill("400032.12")
    assert boxes[2].evaluate("(box) => box.scrollWidth <= box.clientWidth")  # nothing is cut off
    boxes[2].fill("400032")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save the section as CSV").click()
    rows = list(csv.DictReader(Path(download.value.path()).read_text().splitlines()))
    ends = [[float(row[key]) for key in ("distance_m", "x_m", "y_m")] for row in (rows[0], rows[-1])]
    assert ends == [[0, 2, 4], [50, 32, 44]]  # 30 m east and 40 m north
    place = [float(rows[-1]["easting_m"]), float(rows[-1]["northing_m"])]
    assert place == [400_032, 5_300_044]
    page.get_by_label("Coordinates of the section’s ends").select_option("field")
    assert [box.input_value() for box in boxes] == ["2", "4", "32", "44"]


@pytest.mark.extended
def test_the_ruler_shows_and_takes_eastings_and_northings_where_the_ground_has_them(studio):
    page = studio.page
    studio.pause()
    studio.ask(
        """(() => {
            const { app } = window.barchan;
            app.current.description.place = { west: 400000, south: 5300000, crs: "EPSG:32633" };
            app.changed.send();
        })()"""
    )
    page.locator(".scene canvas").first.focus()
    page.keyboard.press("m")
    ruler = page.get_by_label("Ruler", exact=True)
    boxes = ruler.locator("input").all()
    for box, text in zip(boxes, ("400002", "5300004", "400032", "5300044"), strict=True):
        box.fill(text)
        box.press("Tab")
    assert ruler.locator("td").first.inner_text() == "50 m"  # 30 m east and 40 m north
    assert [box.input_value() for box in boxes] == ["400002", "5300004", "400032", "5300044"]
    ruler.get_by_label("Coordinates of the ruler’s places").select_option("field")
    assert [box.input_value() for box in boxes] == ["2", "4", "32", "44"]
    page.keyboard.press("m")


def test_a_line_of_the_section_goes_with_the_run_over_which_it_was_drawn(studio):
    page = studio.page
    page.keyboard.press("1")
    ends = "[...document.querySelectorAll('.ends input')].map((one) => one.value)"
    studio.until(f"({ends}).every(Boolean)")
    along = studio.ask(ends)
    page.locator(".ends input").first.fill("3")
    page.keyboard.press("Enter")
    studio.ask("document.activeElement.blur()")
    studio.until(f"({ends})[0] === '3'")
    scenario = load_scenario(
        "barchans", [("title", '"Another"'), ("lattice.rows", "48"), ("lattice.columns", "64")]
    )
    studio.ask(f"window.barchan.app.create({json.dumps(scenario.data())}, false)")
    studio.until(f"{RUN}.description.scenario.title === 'Another'")
    studio.until(f"({ends})[0] !== '3'")
    assert len(studio.ask(ends)) == len(along)
    page.keyboard.press("1")


def test_the_section_is_a_line_in_the_scene_that_lies_on_the_surface(studio):
    studio.pause()
    studio.page.keyboard.press("1")
    studio.picture()
    shown = "window.barchan.stage.surfaces.shown[0]"
    knobs = f"{shown}.marks.section.group.children.slice(-2)"
    assert studio.ask(f"{shown}.marks.section.group.visible")
    ends = studio.ask(f"{knobs}.map((knob) => knob.position.toArray())")
    # The wind is from the west: the line goes from the western to the eastern edge of a block ten units long.
    assert [ends[0][0], ends[1][0]] == pytest.approx([-5, 5], abs=0.2)
    heights = studio.ask(f"[{ends[0]}, {ends[1]}] && {shown}.terrain.box().max.y")
    assert all(0 < y <= heights + 0.1 for _, y, _ in ends)
    studio.page.keyboard.press("1")
    studio.picture()
    assert not studio.ask(f"{shown}.marks.section.group.visible")


def test_crests_are_plotted_without_jumps(studio):
    """Crests across a wind from 270 degrees lie at 0: 178 and 2 are plotted four degrees apart, around 0."""
    studio.pause()
    studio.page.keyboard.press("2")
    crests = [178.0, 2.0, 179.0, 1.0]
    rows = [{"step": at, "values": {"crest_azimuth": one}, "doubts": {}} for at, one in enumerate(crests)]
    studio.ask(f"void ({RUN}.measures = {json.dumps(rows)})")
    studio.ask("window.barchan.app.changed.send()")
    plotted = studio.ask("window.barchan.series.data('crest_azimuth')[1]")
    assert plotted == [-2, 2, -1, 1]


def test_the_plot_of_crests_stays_where_it_is_while_the_wind_comes_from_several_sides(studio):
    """A crest at 91, beyond the upper end of the plot, is one at 89 below its middle."""
    studio.pause()
    studio.page.keyboard.press("2")
    studio.ask(LISTEN)
    marks = []
    for count, wind in enumerate((270, 0, 90, 180), start=2):  # from the second on the plot is a half turn
        crests = [2.0, 178.0, 91.0, 3.0, 1.0][:count]
        rows = [{"step": at, "values": {"crest_azimuth": one}, "doubts": {}} for at, one in enumerate(crests)]
        studio.ask(
            f"void (window.words = [], {RUN}.measures = {json.dumps(rows)}, {RUN}.status.wind = {wind})"
        )
        studio.ask("window.barchan.app.changed.send()")
        studio.until("window.words.filter((word) => String(word).endsWith('°')).length >= 3")
        marks.append([word for word in studio.ask("window.words") if str(word).endswith("°")])
    assert marks[0][:3] == ["150°", "0°", "30°"]
    assert {tuple(one[:5]) for one in marks[1:]} == {("90°", "135°", "0°", "45°", "90°")}
    assert studio.ask("window.barchan.series.data('crest_azimuth')[1]") == [2, -2, -89, 3, 1]


def test_a_line_of_measures_has_gaps_where_there_is_no_value(studio):
    """Of six values 3 and 5 are missing: a line from the first to the second, a dot, and a dot."""
    studio.pause()
    studio.until(f"{RUN}.measures.at(-1)?.step === {RUN}.status.step")
    studio.page.keyboard.press("2")
    values = [1.0, 2.0, None, 1.5, None, 1.0]
    rows = [
        {"step": 10 * at, "values": {"speed": one} if one else {}, "doubts": {}}
        for at, one in enumerate(values)
    ]
    studio.ask(f"void ({RUN}.measures = {json.dumps(rows)})")
    studio.ask("window.barchan.app.changed.send()")
    studio.page.wait_for_timeout(200)
    found = studio.ask(
        """(() => {
            const { chart } = window.barchan.series.charts.find(({ measure }) => measure.name === "speed");
            const c = document.createElement("canvas").getContext("2d");
            c.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--left").trim();
            c.fillRect(0, 0, 1, 1);
            const own = c.getImageData(0, 0, 1, 1).data;
            const inked = (step) => {
                const x = Math.round(chart.valToPos(step, "x", true));
                const strip = chart.ctx.getImageData(x - 1, chart.bbox.top, 3, chart.bbox.height).data;
                const far = (at) => [0, 1, 2].reduce((sum, c) => sum + Math.abs(strip[at + c] - own[c]), 0);
                const inOwnColour = (at) => strip[at + 3] > 90 && far(at) < 90;
                return Array.from({ length: strip.length / 4 }, (_, pixel) => 4 * pixel).some(inOwnColour);
            };
            const steps = [5, 15, 25, 30, 40, 50];
            return { dots: chart.series[1].points.filter(chart, 1), inked: steps.map(inked) };
        })()"""
    )
    assert found == {"dots": [3, 5], "inked": [True, False, False, True, False, True]}


def test_before_the_first_picture_nothing_is_said_that_is_not_known(chromium, server):
    _, address, _ = server
    page = chromium.new_page(viewport={"width": 1000, "height": 640})
    page.route_web_socket("**/*", lambda socket: None)  # a server that does not answer yet
    page.goto(address)
    page.wait_for_selector(".waiting .bar")
    assert not page.locator(".hud").is_visible()
    assert "Untitled" not in page.locator("body").inner_text()
    assert not page.get_by_text("go on from here").is_visible()
    page.close()


def test_a_run_that_is_being_prepared_is_named_as_such_and_the_one_that_is_shown_keeps_its_name(studio):
    """A description without a frame, as it comes while kernels are compiled."""
    page = studio.page
    studio.step_beyond(5)
    studio.pause()
    title = page.locator(".bar .title").inner_text()
    studio.ask(
        f"""(() => {{
            const {{ app }} = window.barchan;
            const described = {RUN}.description;
            const scenario = {{ ...described.scenario, title: "Stars" }};
            app.handlers.scenario({{ ...described, scenario, loaded: -1 }}, {RUN});
        }})()"""
    )
    page.locator(".notice", has_text="“Stars” is being prepared.").wait_for()
    assert page.locator(".bar .title").inner_text() == title
    other = load_scenario("star", PLANTS).data()
    studio.ask(f"window.barchan.app.create({json.dumps(other)}, true)")
    studio.until(f"{RUN}.description.scenario.title === {json.dumps(other['title'])}")
    assert (studio.ask(f"{RUN}.rows"), studio.ask(f"{RUN}.columns")) == (32, 48)
    page.locator(".notice", has_text="is being prepared").wait_for(state="hidden")


@pytest.mark.parametrize(
    "view",
    ["Section", *(pytest.param(one, marks=pytest.mark.extended) for one in ("Measures", "Space–time"))],
)
def test_views_that_rest_are_drawn_in_the_colours_of_a_theme_that_is_chosen(studio, view):
    plots = "JSON.stringify([...document.querySelectorAll('.dock canvas')].map((one) => one.toDataURL()))"
    studio.ask("window.barchan.app.view.set({ theme: 'light' })")
    studio.step_beyond(60)
    studio.pause()
    studio.page.get_by_role("tab", name=view).click()
    studio.page.wait_for_timeout(400)
    light = studio.ask(plots)
    studio.ask("window.barchan.app.view.set({ theme: 'dark' })")
    studio.page.wait_for_timeout(200)
    dark = studio.ask(plots)
    studio.ask("window.barchan.app.changed.send()")
    studio.page.wait_for_timeout(200)
    assert light != dark == studio.ask(plots)
    studio.page.get_by_role("tab", name=view).click()  # shut, and drawn anew
    studio.page.get_by_role("tab", name=view).click()
    studio.page.wait_for_timeout(200)
    assert dark == studio.ask(plots)
    studio.ask("window.barchan.app.view.set({ theme: 'system' })")
    studio.page.get_by_role("tab", name=view).click()
