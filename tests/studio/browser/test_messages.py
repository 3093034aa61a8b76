"""What the page says where something is refused, and that nothing refused stands in the way."""

import io
import json

import numpy as np
import pytest
from PIL import Image

RUN = "window.barchan.app.runs[0]"
SCENARIO = f"{RUN}.description.scenario"


def fill(studio, path: str, value: str) -> None:
    box = studio.page.locator(f"[data-path='{path}']")
    box.fill(value)
    box.press("Enter")


def toasts(studio):
    return studio.page.locator(".toast.error")


def test_a_moment_and_a_saved_run_are_confirmed_over_the_scene(studio):
    page = studio.page
    said = page.locator(".toast.info")
    studio.pause()
    step = studio.status()["step"]
    page.keyboard.press("f")
    page.keyboard.press("k")
    said.filter(has_text=f"Marked as “moment 1” at step {step}").wait_for()
    page.keyboard.press("f")
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Save the run").click()
    page.get_by_label("Name of the run").fill("confirmed")
    page.get_by_role("button", name="save", exact=True).click()
    said.filter(has_text="in the folder “confirmed”").wait_for()


@pytest.mark.extended
def test_messages_stand_below_the_names_of_two_runs(studio):
    page = studio.page
    page.set_viewport_size({"width": 1280, "height": 720})
    studio.ask("window.barchan.app.ask({ command: 'compare', key: 'model.hop_length', value: 10 })")
    studio.until("window.barchan.app.runs.length === 2 && window.barchan.app.runs.every((run) => run.ready)")
    page.locator(".names span").first.wait_for()
    studio.ask(f"window.barchan.app.note('error', '{'a long refusal ' * 12}')")
    names, message = (page.locator(one).first.bounding_box() for one in (".names", ".toast.error"))
    assert names["y"] + names["height"] <= message["y"]
    studio.ask("window.barchan.app.notices.dismissAll()")
    studio.ask("window.barchan.app.send({ command: 'alone' })")
    studio.until("window.barchan.app.runs.length === 1")


def test_a_refused_value_goes_back_and_hinders_no_later_change(studio):
    page = studio.page
    page.locator("summary", has_text="Lattice").click()
    accepted = studio.ask(f"{SCENARIO}.lattice.rows")
    fill(studio, "lattice.rows", "0")  # a lattice has at least one
    toasts(studio).wait_for()
    assert "lattice › rows" in toasts(studio).inner_text()
    row = page.locator("[data-trouble='lattice.rows']")
    assert "allowed" in row.inner_text()
    assert page.locator("[data-path='lattice.rows']").input_value() == str(accepted)
    page.locator("summary", has_text="Sand at the start").click()
    fill(studio, "sand.mean", "4")
    studio.until(f"{SCENARIO}.sand.mean === 4")
    assert studio.ask(f"{SCENARIO}.lattice.rows") == accepted
    assert toasts(studio).count() == 1
    toasts(studio).get_by_role("button", name="Dismiss").click()
    assert toasts(studio).count() == 0
    assert row.inner_text() == ""


@pytest.mark.extended
def test_a_refusal_leads_to_its_row_and_goes_when_another_value_is_taken(studio):
    page = studio.page
    fill(studio, "model.p_s", "5")  # a probability
    toasts(studio).wait_for()
    page.get_by_role("tab", name="Wind").click()
    toasts(studio).get_by_role("button", name="show").click()
    box = page.locator("[data-path='model.p_s']")
    assert box.is_visible()
    assert box.evaluate("(box) => box === document.activeElement")
    fill(studio, "model.p_s", "0.5")
    studio.until(f"{SCENARIO}.model.p_s === 0.5")
    studio.until("document.querySelectorAll('.toast.error').length === 0")


@pytest.mark.extended
def test_a_file_that_waits_for_the_compiling_of_a_model_says_so(studio):
    studio.ask(
        """(() => {
            const { app } = window.barchan;
            app.connection.ask = () => new Promise(() => {}); // as a run that is being compiled
            app.together.take = () => {}; // nor does a frame come
            app.handlers.compiling({ functions: 3 });
        })()"""
    )
    studio.drop_file("wind.csv", "text/csv", b"time,speed (m/s),direction\n2024-01-01T00:00,5,270\n")
    studio.page.get_by_role("dialog").get_by_text("waits until the model is compiled").wait_for()


def test_translating_a_model_is_said_in_the_same_words_over_the_scene_and_in_the_log(studio):
    studio.ask(
        """(() => {
            const { app } = window.barchan;
            app.together.take = () => {}; // no frame ends it
            app.handlers.compiling({ functions: 0 });
        })()"""
    )
    words = "Translating the model into machine code, once, for it is kept"
    assert studio.page.locator(".notice").inner_text() == f"{words} …"
    assert studio.ask("window.barchan.app.notices.log.at(-1).text") == f"{words}."
    assert studio.page.locator("[role=status].unseen").inner_text() == f"{words}."


def test_refusals_of_one_field_do_not_pile_up_and_go_with_a_value_that_is_taken(studio):
    """The last one is refused for a reason that names no key."""
    fill(studio, "model.p_s", "5")
    toasts(studio).wait_for()
    fill(studio, "model.p_s", "7")
    toasts(studio).filter(has_text="7").wait_for()
    assert toasts(studio).count() == 1
    studio.ask("window.barchan.app.refused(new Error('a reason'), ['model.p_s'])")
    toasts(studio).filter(has_text="a reason").wait_for()
    assert toasts(studio).count() == 1
    fill(studio, "model.p_s", "0.5")
    studio.until("document.querySelectorAll('.toast.error').length === 0")
    assert studio.page.locator("[data-trouble='model.p_s']").inner_text() == ""


@pytest.mark.extended
def test_a_refusal_stays_marked_at_the_log_until_the_log_is_opened(studio):
    page = studio.page
    fill(studio, "model.p_s", "5")
    toasts(studio).wait_for()
    studio.ask("window.barchan.app.note('info', 'Something else.')")
    log = page.get_by_role("tab", name="Log")
    assert "marked" in log.get_attribute("class")
    log.click()
    assert "marked" not in log.get_attribute("class")
    assert "p_s" in page.locator(".log .error").last.inner_text()


def test_saving_under_a_name_in_use_leaves_the_sheet_open_and_says_why(studio):
    page = studio.page
    (studio.folder / "taken").mkdir()
    (studio.folder / "taken" / "notes.txt").write_text("not a run")
    studio.pause()
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Save the run").click()
    name = page.get_by_label("Name of the run")
    name.fill("taken")
    name.press("Enter")
    refusal = page.get_by_role("dialog").get_by_role("alert")
    refusal.filter(has_text="taken").wait_for()
    assert page.get_by_role("dialog").is_visible()
    name.fill("free")
    name.press("Enter")
    page.get_by_role("dialog").wait_for(state="detached")
    assert (studio.folder / "free" / "scenario.json").is_file()


def grey(size: tuple[int, int], kind: str) -> bytes:
    content = io.BytesIO()
    heights = np.tile(np.linspace(0, 255, size[0]).astype(np.uint8), (size[1], 1))
    Image.fromarray(heights).save(content, kind)
    return content.getvalue()


def test_photographs_and_names_with_spaces_and_accents_are_grounds(studio):
    for name, kind, kept in (
        ("my naïve dunes (1).JPG", "JPEG", "my-naive-dunes-1.jpg"),
        ("plan ö.png", "PNG", "plan-o.png"),
    ):
        studio.drop_file(name, f"image/{kind.lower()}", grey((64, 48), kind))
        studio.page.get_by_role("dialog").get_by_role("button", name="use it").click()
        studio.until(f"{SCENARIO}.ground.path?.endsWith('{kept}')")
        studio.until_logged(f"{name} is the ground")


@pytest.mark.extended
def test_a_broken_image_is_refused_without_having_been_called_the_ground(studio):
    studio.drop_file("broken.png", "image/png", b"\x89PNG and nothing more")
    sheet = studio.page.get_by_role("dialog")
    sheet.get_by_role("button", name="use it").click()
    sheet.get_by_text("'broken.png': cannot be read as an image").wait_for()
    uploads = studio.folder / "studio-uploads"
    assert not (uploads / "broken.png").exists()
    assert "is the ground" not in studio.log()
    studio.step_beyond(studio.status()["step"])  # the run goes on as it was


def changes(studio) -> list[str]:
    """The list of changes, opened."""
    studio.ask("void (document.getElementById('group-changes').open = true)")
    return studio.page.locator("#group-changes li > span").all_inner_texts()


@pytest.mark.extended
def test_a_value_that_was_put_back_is_no_change_in_list_or_title(studio):
    page = studio.page
    page.locator("summary", has_text="Sand at the start").click()
    before = studio.ask(f"{SCENARIO}.sand.mean")
    title = studio.ask("document.querySelector('.title').textContent")
    fill(studio, "sand.mean", "4")
    studio.until(f"{SCENARIO}.sand.mean === 4 && document.getElementById('group-changes').innerText !== ''")
    assert changes(studio) == [f"from the start: sand › mean {before:g} → 4 slabs"]
    assert "mean 4" in page.locator(".title").inner_text()
    assert "sand.mean" not in page.locator(".title").inner_text()
    fill(studio, "sand.mean", f"{before:g}")
    studio.until(f"{SCENARIO}.sand.mean === {before}")
    studio.until("!document.getElementById('group-changes').querySelector('li')")
    assert page.locator(".title").inner_text() == title


@pytest.mark.extended
def test_a_value_put_back_in_mid_run_is_told_as_such(studio):
    before = studio.ask(f"{SCENARIO}.model.p_s")
    studio.pause()
    for value in (0.5, before):
        fill(studio, "model.p_s", f"{value:g}")
        studio.until(f"{SCENARIO}.model.p_s === {value}")
    assert changes(studio)[0].endswith(f"p_s 0.5 → {before:g}, as it was at first")


@pytest.mark.extended
def test_bounds_and_switches_are_told_in_words(studio):
    rows = studio.page.locator(".panel .row").evaluate_all(
        "(rows) => rows.map((row) => row.title).filter(Boolean)"
    )
    assert any("Allowed: from 0 to 1." in text for text in rows)
    told = [text.partition("Allowed: ")[2].partition("\n")[0] for text in rows]
    assert [text for text in told if "–" in text or "null" in text] == []
    buttons = studio.page.locator(".panel .beside, .panel .reset").evaluate_all(
        "(all) => all.map((one) => one.title)"
    )
    assert [text for text in buttons if "null" in text or "true" in text or "false" in text] == []


@pytest.mark.extended
def test_a_refusal_groups_long_numbers_and_calls_no_value_none(studio):
    """Of a number of hops at least 1 are allowed, at most a thousand million."""
    fill(studio, "model.max_hops", "-5")
    toasts(studio).wait_for()
    told = toasts(studio).inner_text()
    assert "1\u202f000\u202f000\u202f000" in told
    problem = {"key": "run.save_every", "message": "is null; allowed: 1 or null", "place": "scenario"}
    studio.ask(f"window.barchan.app.handlers.refused({{ text: '', problems: [{json.dumps(problem)}] }})")
    toasts(studio).filter(has_text="run › save every: is none; allowed: 1 or none").wait_for()


@pytest.mark.extended
def test_a_run_that_another_scenario_takes_the_place_of_can_be_gone_back_to(studio):
    studio.step_beyond(10)
    title = studio.ask(f"{SCENARIO}.title")
    studio.ask(f"window.barchan.app.create({{ ...{SCENARIO}, title: 'The other one' }}, true)")
    studio.step_beyond(5)
    back = studio.page.locator(".toast.info", has_text=title.partition(",")[0])
    back.get_by_role("button", name="go back to it").click()
    studio.until(f"{SCENARIO}.title === {json.dumps(title)} && {RUN}.status.live > 10")
    studio.page.locator(".toast.info", has_text="The other one").wait_for()
