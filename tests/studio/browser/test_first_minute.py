"""The first minute: the gallery by landform, where to start, the tour, the end of a preset, a class."""

import json
import re

import pytest

from barchan.scenario import load_scenario, preset_names
from barchan.studio.server.gallery import groups, presets, showpiece
from tests.studio.browser.conftest import SMALL

RUN = "window.barchan.app.runs[0]"

pytestmark = pytest.mark.extended


def test_every_preset_stands_in_one_group_and_asks_a_question():
    listed = [name for names in groups().values() for name in names]
    assert sorted(listed) == preset_names()
    assert showpiece() in listed
    assert list(groups()) == [
        "Dunes",
        "Plants",
        "Obstacles",
        "Ripples",
        "Snow",
        "From the literature",
        "Teaching",
    ]
    assert all(preset["question"].count("?") >= 1 for preset in presets())
    assert [preset["name"] for preset in presets() if preset["start"]] == [showpiece()]


def test_the_gallery_shows_groups_and_where_to_start(studio):
    page = studio.page
    page.keyboard.press("g")
    page.wait_for_selector(".lead")
    assert page.locator(".sections section h3").all_inner_texts() == ["Start here", *groups()]
    assert page.locator("[data-preset=snow-waves] .question").inner_text().endswith("?")
    page.get_by_label("Search the presets").fill("nebkha")
    assert page.locator(".sections section:visible h3").all_inner_texts() == ["Start here", "Plants"]
    page.keyboard.press("Escape")


def test_cards_and_the_panel_call_presets_by_their_titles(studio):
    page = studio.page
    page.keyboard.press("g")
    page.wait_for_selector(".lead")
    names = [name for name in preset_names() if "-" in name]
    cards = " ".join(page.locator("dialog.gallery .card, dialog.gallery .lead").all_text_contents())
    assert "Compare “Hop length 5, 2 slabs a cell” with “Hop length 1, 2 slabs a cell”" in cards
    assert [name for name in names if re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", cards)] == []
    page.keyboard.press("Escape")
    fresh = load_scenario("momiji-strip", list(SMALL.items())).data()
    studio.ask(f"window.barchan.app.create({json.dumps(fresh)}, false)")
    question = page.locator(".about .question", has_text="Set the speedup to zero")
    assert "as those of “A strip of Werner's ridges”?" in question.inner_text()


def test_a_preset_runs_at_a_watchable_speed_to_its_end_and_goes_on_when_asked(studio):
    studio.until(
        "document.querySelector('[aria-label=\"Speed limit\"]').selectedOptions[0].text === '40 steps/s'"
    )
    scenario = load_scenario("barchans", [*SMALL.items(), ("run.steps", "12")]).data()
    studio.ask(f"window.barchan.app.create({json.dumps(scenario)}, true)")
    studio.until(f"{RUN}.description.scenario.run.steps === 12 && {RUN}.status?.step === 12")
    studio.until("!window.barchan.app.running")
    page = studio.page
    assert "ends" in page.locator(".notice").inner_text()
    page.get_by_role("button", name="go on", exact=True).click()
    studio.step_beyond(12)


def test_the_tour_waits_for_dunes_turns_the_wind_and_ends(studio):
    page = studio.page
    studio.pause()
    studio.ask("window.barchan.tour.begin()")
    page.get_by_text("1 of 3").wait_for()
    page.get_by_role("button", name="go on", exact=True).last.click()
    page.get_by_text("2 of 3").wait_for()
    assert page.get_by_role("tab", name="Wind").get_attribute("aria-selected") == "true"
    page.get_by_role("button", name="turn it by 90°").click()
    studio.until(f"{RUN}.status.wind === 0")
    page.get_by_text("3 of 3").wait_for()
    page.get_by_role("button", name="done").click()
    assert not page.locator(".tour").is_visible()


def test_the_first_step_of_the_tour_waits_for_its_reader_although_dunes_stand(studio):
    page = studio.page
    fresh = {**load_scenario("barchans", list(SMALL.items())).data(), "title": "At its beginning"}
    studio.ask(f"window.barchan.app.create({json.dumps(fresh)}, false)")
    studio.until(f"{RUN}.description.scenario.title === 'At its beginning' && {RUN}.status.step === 0")
    studio.ask("window.barchan.tour.begin()")
    studio.ask("window.barchan.stage.renderer.setAnimationLoop(null)")  # frames come, none is drawn
    studio.ask(f"void Object.assign({RUN}.status, {{ step: 300 }})")
    studio.ask("window.barchan.app.framed.send(window.barchan.app.current)")
    assert page.get_by_text("Dunes stand now.").count() == 0
    studio.ask(f"void Object.assign({RUN}.status, {{ step: 0 }})")
    studio.ask("window.barchan.stage.renderer.setAnimationLoop(() => window.barchan.stage.tick())")
    page.get_by_text("Dunes stand now.").wait_for(timeout=60_000)
    studio.until("!window.barchan.app.running")
    page.get_by_text("1 of 3").wait_for()
    assert studio.status()["step"] == 250
    assert page.locator(".notice").is_hidden()
    page.get_by_role("button", name="End the tour").click()


def test_two_values_of_a_parameter_run_side_by_side_after_one_click(studio):
    page = studio.page
    hop = page.locator(".row", has=page.locator("[data-path='model.hop_length']"))
    hop.hover()
    hop.locator(".beside").click()
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs.every((run) => run.ready)")
    hops = studio.ask("window.barchan.app.runs.map((run) => run.description.scenario.model.hop_length)")
    assert hops == [5, 10]
    same = [load_scenario("barchans", list(SMALL.items())).model.p_s] * 2
    assert studio.ask("window.barchan.app.runs.map((run) => run.description.scenario.model.p_s)") == same
    studio.until("document.querySelector('.names').innerText.includes('hop length 10')")
    studio.until("window.barchan.app.runs.every((run) => run.status.step > 5)")
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


def test_full_screen_leaves_the_scene_with_large_type(studio):
    page = studio.page
    before = page.evaluate("parseFloat(getComputedStyle(document.querySelector('.wind-text')).fontSize)")
    page.keyboard.press("f")
    studio.until("document.documentElement.classList.contains('large')")
    assert not page.locator(".panel").is_visible()
    assert (
        page.evaluate("parseFloat(getComputedStyle(document.querySelector('.wind-text')).fontSize)")
        > 1.4 * before
    )
    page.keyboard.press("f")
    studio.until("!document.documentElement.classList.contains('large')")
    assert page.locator(".panel").is_visible()


CLIPPED = """(() => {
    const bar = document.querySelector(".status").getBoundingClientRect();
    const seen = [...document.querySelectorAll(".status > div")].filter((one) => {
        const { top, height } = one.getBoundingClientRect();
        return height > 0 && top < bar.bottom;
    });
    const parts = seen.flatMap((one) => [one, ...one.children]).map((one) => one.getBoundingClientRect());
    const whole = ({ top, bottom, left, right }) =>
        Math.min(top - bar.top, bar.bottom - bottom, left - bar.left, bar.right - right) >= -0.5;
    return { seen: seen.length, cut: parts.filter((part) => !whole(part)).length };
})()"""
"""Numbers in the bar that are seen, and how many of them and their names are seen in part."""


@pytest.mark.parametrize("size", [(1280, 720), (1600, 900)])
def test_full_screen_shows_the_numbers_of_the_bar_whole(studio, size):
    studio.page.set_viewport_size({"width": size[0], "height": size[1]})
    studio.ask("document.documentElement.classList.add('large')")
    studio.step_beyond(5)
    assert studio.ask(CLIPPED) == {"seen": 4, "cut": 0}
    studio.ask("window.barchan.app.send({ command: 'compare', model: 'momiji' })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].ready")
    studio.until("document.querySelector('[data-status=highest]').innerText.includes('|')")
    assert studio.ask(CLIPPED) == {"seen": 4, "cut": 0}
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


@pytest.mark.parametrize("transparent", [False, True])
def test_a_picture_of_any_size_is_drawn_beside_the_page(studio, transparent):
    studio.pause()
    options = json.dumps({"width": 640, "height": 200, "transparent": transparent})
    found = studio.ask(
        f"""(async () => {{
            const image = await createImageBitmap(await window.barchan.stage.render({options}));
            const canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext("2d");
            context.drawImage(image, 0, 0);
            const alpha = (x, y) => context.getImageData(x, y, 1, 1).data[3];
            return [image.width, image.height, alpha(2, 2), alpha(320, 100)];
        }})()"""
    )
    assert found == [640, 200, 0 if transparent else 255, 255]
    assert studio.picture().std() > 5
