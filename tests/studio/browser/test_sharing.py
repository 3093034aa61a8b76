"""A class: windows that watch, links that carry a scenario, bookmarks of moments, films of what was seen."""

import base64
import json
import re
import zlib

import httpx
import pytest

from barchan.scenario import load_scenario
from tests.studio.browser.conftest import NOTICE, SMALL, running, says, until
from tests.studio.conftest import serving, small

RUN = "window.barchan.app.runs[0]"
CONTROLS = "aside :is(input, select, textarea, button):not(.tabs *, .explain)"


def token_of(address: str) -> str:
    return address.partition("token=")[2]


def watch_link(address: str) -> str:
    base = re.sub(r"\?.*", "", address)
    headers = {"x-barchan-token": token_of(address)}
    return f"{base}?watch={httpx.get(f'{base}api/watching', headers=headers).json()['token']}"


@pytest.fixture
def others(chromium, studio, server):
    """A window that watches beside the one that commands."""
    page = chromium.new_page(viewport={"width": 1000, "height": 640})
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(watch_link(server[1]))
    running(page)
    yield page
    page.close()
    assert errors == []


@pytest.mark.extended
def test_the_bar_keeps_to_one_row_with_a_count_of_watchers(studio):
    studio.pause()
    studio.ask("(({ app }) => { app.sharing.watchers = 1; app.changed.send(); })(window.barchan)")
    for width in (1280, 1200, 1100):
        studio.page.set_viewport_size({"width": width, "height": 700})
        assert studio.page.locator(".bar").bounding_box()["height"] < 60
        assert studio.page.locator(".extras").evaluate("(one) => one.getBoundingClientRect().right") < width
        step, play = (studio.page.locator(one).bounding_box() for one in ("[data-status=step]", ".primary"))
        assert abs(step["y"] - play["y"]) < 30


@pytest.mark.extended
def test_a_window_that_watches_shows_the_run_and_has_no_control_that_works(studio, others):
    studio.pause()
    step = studio.status()["step"]
    until(others, f"{RUN}.status.step === {step} && !{RUN}.status.running")
    assert "You watch" in others.locator(".watching-note").inner_text()
    assert "watch=" not in others.url
    assert not others.get_by_role("button", name="Run (space)").is_visible()
    assert not others.locator(".menu").is_visible()
    enabled = others.locator(CONTROLS).evaluate_all("all => all.filter((one) => !one.disabled).length")
    assert enabled == 0
    for key in ("Space", ".", "r", "b", "g"):
        others.keyboard.press(key)
    others.evaluate("window.barchan.app.send({ command: 'run' })")  # the page itself sends nothing
    studio.page.wait_for_timeout(300)
    assert studio.status()["step"] == step
    studio.page.get_by_role("button", name="1 window watches").wait_for()
    assert others.locator(".toast.error").count() == 0


@pytest.mark.extended
def test_a_window_that_watches_follows_the_colours_and_keeps_its_own_camera(studio, others):
    studio.ask("window.barchan.app.view.set({ field: 'slope' })")
    until(others, "window.barchan.app.view.look.field === 'slope'")
    before = studio.ask("window.barchan.stage.standpoint().position")
    others.keyboard.press("t")
    assert others.evaluate("window.barchan.stage.standpoint().viewpoint") == "top"
    assert studio.ask("window.barchan.stage.standpoint().position") == before
    assert others.evaluate("localStorage.getItem('barchan-look')") is None
    others.reload()
    running(others)
    until(others, "window.barchan.app.view.look.field === 'slope'")


@pytest.mark.extended
def test_the_sheet_gives_the_link_and_says_that_only_this_computer_is_served(studio, server):
    page = studio.page
    page.locator(".menu summary").click()
    page.get_by_role("menuitem", name="Let others watch").click()
    assert page.get_by_label("Link to watch", exact=True).input_value() == watch_link(server[1])
    assert "--host 0.0.0.0" in page.locator("dialog").inner_text()
    page.keyboard.press("Escape")


@pytest.mark.extended
def test_a_stale_link_to_watch_asks_for_the_new_one_and_the_wrong_kind_is_noticed(visit, server):
    page = visit(re.sub(r"\?.*", "?watch=stale", server[1]))
    says(page, "The link by which you watch")
    page.get_by_label("Address or token").fill(watch_link(server[1]))
    page.get_by_role("button", name="open").click()
    running(page)
    assert page.evaluate("window.barchan.app.watching")
    page.goto("about:blank")
    page = visit(watch_link(server[1]).replace("watch=", "token="))
    page.locator(".watching-note").wait_for(timeout=60_000)
    running(page)


def scenario_in(link: str) -> dict:
    """The scenario of a link, by Python's own libraries."""
    packed = link.partition("#scenario=")[2]
    return json.loads(zlib.decompress(base64.urlsafe_b64decode(packed + "=" * (-len(packed) % 4))))


def link_with(text: bytes, base: str = "") -> str:
    return f"{base}#scenario={base64.urlsafe_b64encode(zlib.compress(text)).decode().rstrip('=')}"


@pytest.mark.extended
def test_the_link_of_a_scenario_holds_it_whole(studio):
    page = studio.page
    page.locator(".menu summary").click()
    page.get_by_role("menuitem", name="Copy a link of this scenario").click()
    link = page.get_by_label("Link of the scenario", exact=True).input_value()
    assert scenario_in(link) == studio.ask(f"{RUN}.description.scenario")
    assert "token" not in link
    page.keyboard.press("Escape")


@pytest.mark.extended
def test_the_link_of_two_runs_starts_both_side_by_side(studio):
    page = studio.page
    studio.ask("window.barchan.app.ask({ command: 'compare', key: 'model.hop_length', value: 9 })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 5")
    page.locator(".menu summary").click()
    page.get_by_role("menuitem", name="Copy a link of this scenario").click()
    link = page.get_by_label("Link of both scenarios", exact=True).input_value()
    alone = page.get_by_label("Link of the scenario", exact=True).input_value()
    both = scenario_in(link)
    assert scenario_in(alone) == both[0]
    assert [one["model"]["hop_length"] for one in both] == [5, 9]
    page.screenshot(path=studio.folder / "link-of-two.png")
    page.keyboard.press("Escape")
    studio.ask("window.barchan.app.ask({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")
    studio.ask(f"void (location.hash = {json.dumps('#' + link.partition('#')[2])})")
    page.get_by_role("dialog", name="Two scenarios from a link").wait_for()
    page.screenshot(path=studio.folder / "two-from-a-link.png")
    page.get_by_role("button", name="start both").click()
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs[1].status?.step > 2")
    assert studio.ask("window.barchan.app.runs.map((run) => run.description.scenario)") == both
    assert studio.ask("window.barchan.app.running")
    page.locator(".toast.way", has_text="Set aside with its moments").wait_for()
    studio.ask("window.barchan.app.ask({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


def test_a_link_put_into_the_address_offers_its_scenario_and_starts_it_only_when_asked(studio):
    page = studio.page
    scenario = load_scenario("barchans", [*SMALL.items(), ("title", "Dunes from a friend")]).data()
    studio.ask(f"void (location.hash = {json.dumps(link_with(json.dumps(scenario).encode()))})")
    sheet = page.locator("dialog", has_text="Dunes from a friend")
    sheet.wait_for()
    assert "64 × 48 cells" in sheet.inner_text()
    assert studio.ask("location.hash") == ""
    assert studio.ask(f"{RUN}.description.scenario.title") != "Dunes from a friend"
    sheet.get_by_role("button", name="start it").click()
    studio.until(f"{RUN}.description.scenario.title === 'Dunes from a friend'")


@pytest.mark.extended
@pytest.mark.parametrize(
    ("link", "words"),
    [
        ("#scenario=abc", "is damaged"),
        ("#scenario=%%%", "is damaged"),
        (link_with(b'{"barchan": 5, "lattice": {"rows": 300}}')[:-6], "is damaged"),
        (link_with(b'{"barchan": 5')[:], "is damaged"),
        (link_with(b"[" + b" " * (3 << 20) + b"]"), "unfolds to more than"),
        ("#scenario=" + "A" * 16_001, "allowed: 16000"),
    ],
)
def test_damaged_and_overlong_links_are_refused_in_words(studio, link, words):
    studio.ask(f"void (location.hash = {json.dumps(link)})")
    studio.page.locator(".toast", has_text=words).wait_for()
    studio.page.keyboard.press("Backspace")


@pytest.mark.extended
def test_a_link_with_bad_values_lists_them_and_loads_the_rest_only_when_asked(studio):
    data = {"barchan": 5, "lattice": {"rows": 48, "columns": 64}, "model": {"name": "werner", "p_s": 7}}
    studio.ask(f"void (location.hash = {json.dumps(link_with(json.dumps(data).encode()))})")
    sheet = studio.page.locator("dialog", has_text="the link: 1 problem")
    sheet.wait_for()
    assert "p_s" in sheet.inner_text()
    sheet.get_by_role("button", name="leave it").click()


@pytest.mark.extended
def test_a_page_without_a_token_hands_its_link_to_the_window_that_is_open(chromium, tmp_path):
    context = chromium.new_context()
    with serving(tmp_path, small()) as served:
        page = context.new_page()
        page.goto(f"{served.address}/?token={served.guard.token}")
        running(page)
        other = context.new_page()
        data = {**small().data(), "title": "Handed on"}
        other.goto(link_with(json.dumps(data).encode(), f"{served.address}/"))
        other.locator(NOTICE, has_text="this one can be closed").wait_for()
        page.locator("dialog", has_text="Handed on").wait_for()
        context.close()


@pytest.mark.extended
def test_a_scenario_that_needs_a_file_is_not_put_into_a_link(studio):
    page = studio.page
    studio.pause()
    studio.ask(f"void ({RUN}.description.scenario.ground = {{ kind: 'file', path: '/somewhere/dem.tif' }})")
    page.locator(".menu summary").click()
    page.get_by_role("menuitem", name="Copy a link of this scenario").click()
    page.locator(".toast", has_text="dem.tif, which a link cannot carry").wait_for()
    page.keyboard.press("Backspace")


@pytest.mark.extended
def test_a_moment_is_found_again_after_a_reload_and_a_restart_of_the_server(chromium, tmp_path):
    """Marked at a step that is not kept by itself, in the view from above, coloured by slope."""
    context = chromium.new_context()
    page = context.new_page()
    with serving(tmp_path, small()) as served:
        page.goto(f"{served.address}/?token={served.guard.token}")
        running(page)
        page.evaluate("window.barchan.app.send({ command: 'pause' })")
        until(page, "!window.barchan.app.running")
        page.evaluate("window.barchan.app.ask({ command: 'restart', running: false })")
        until(page, f"{RUN}.status.step === 0 && {RUN}.status.live === 0")
        page.evaluate("window.barchan.app.send({ command: 'run', steps: 13 })")
        until(page, f"{RUN}.status.step === 13 && !{RUN}.status.running")
        page.keyboard.press("t")
        page.evaluate("window.barchan.app.view.set({ field: 'slope' })")
        page.keyboard.press("k")
        until(page, f"{RUN}.description.bookmarks.length === 1")
        depth = page.evaluate(f"Array.from({RUN}.depth)")
        page.evaluate("window.barchan.app.send({ command: 'run', steps: 30 })")
        until(page, f"{RUN}.status.step === 43")
        page.keyboard.press("o")
        page.evaluate("window.barchan.app.view.set({ field: 'natural' })")
        page.reload()
        running(page)
        page.get_by_role("tab", name="Moments").click()
        page.locator(".moment").click()
        until(page, f"{RUN}.status.step === 13 && {RUN}.status.looking")
        assert page.evaluate(f"Array.from({RUN}.depth)") == depth
        assert page.evaluate("window.barchan.stage.standpoint().viewpoint") == "top"
        assert page.evaluate("window.barchan.app.view.look.field") == "slope"
        port = served.port
    with serving(tmp_path, small(), port=port) as again:
        page.goto(f"{again.address}/?token={again.guard.token}")
        running(page)
        page.evaluate("window.barchan.app.send({ command: 'pause' })")
        page.evaluate("window.barchan.app.ask({ command: 'restart', running: false })")
        until(page, f"{RUN}.status.live === 0")
        until(page, f"{RUN}.description.bookmarks.length === 1")
        page.get_by_role("tab", name="Moments").click()
        page.locator(".moment").click()
        until(page, f"{RUN}.status.step === 13 && !{RUN}.status.running")
        assert page.evaluate(f"Array.from({RUN}.depth)") == depth
    context.close()


@pytest.mark.extended
def test_a_moment_is_named_otherwise_and_removed_for_good(studio):
    page = studio.page
    studio.pause()
    page.keyboard.press("k")
    page.get_by_role("tab", name="Moments").click()
    page.get_by_role("button", name=re.compile("Name moment 1 otherwise")).click()
    page.get_by_label("Name of the moment", exact=True).last.fill("the horns")
    page.get_by_role("button", name="name it").click()
    page.locator(".moment", has_text="the horns").wait_for()
    page.get_by_role("button", name="Remove the horns").click()
    page.locator(".moment").wait_for(state="detached")
    assert (
        studio.ask(f"JSON.parse(localStorage.getItem('barchan-bookmarks'))[{RUN}.description.identity]")
        is None
    )


@pytest.mark.extended
def test_a_film_of_the_last_states_is_written_with_a_bar_and_downloaded(studio):
    page = studio.page
    studio.step_beyond(60)
    studio.pause()
    page.locator(".menu summary").click()
    page.get_by_role("menuitem", name="Film of what was just seen").click()
    sheet = page.locator("dialog", has_text="Film of what was just seen")
    sheet.get_by_label("States of the film, the last ones").fill("3")
    assert sheet.get_by_role("status").first.inner_text().startswith("From step ")
    with page.expect_download(timeout=60_000) as download:
        sheet.get_by_role("button", name="write the film").click()
    path = download.value.path()
    assert download.value.suggested_filename in ("barchans.mp4", "barchans.webp")
    assert path.read_bytes()[4:12] in (b"ftypisom", b"ftypmp42") or path.read_bytes()[8:12] == b"WEBP"
