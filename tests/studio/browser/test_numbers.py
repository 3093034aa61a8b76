"""Numbers that are typed: a decimal comma is one, and what is no number is refused at its field."""

import pytest

RUN = "window.barchan.app.runs[0]"
SCENARIO = f"{RUN}.description.scenario"


def write(box, text: str) -> None:
    """Type a text key by key, which browsers may sieve, in place of the one that stands there."""
    box.click()
    box.press("Control+A")
    box.press_sequentially(text)
    box.press("Enter")


def test_a_decimal_comma_is_read_and_doubt_is_refused(studio):
    """1,234 is one and a bit for some and more than a thousand for others."""
    box = studio.page.locator("[data-path='model.p_s']")
    for text, value in (("0,5", 0.5), (" .25 ", 0.25), ("5e-1", 0.5)):
        write(box, text)
        studio.until(f"{SCENARIO}.model.p_s === {value}")
        assert studio.page.locator(".misread").count() == 0
    for text in ("0\u202f,7", "1,234", "0,1,2"):
        write(box, text)
        assert text in studio.page.locator(".misread").inner_text()
        assert box.get_attribute("aria-invalid") == "true"
        studio.catch_up()
        assert studio.ask(f"{SCENARIO}.model.p_s") == 0.5


@pytest.mark.extended
def test_digits_in_groups_are_one_number_and_a_fraction_no_whole_one(studio):
    page = studio.page
    hops = page.locator("[data-path='model.max_hops']")
    write(hops, "12 500")
    studio.until(f"{SCENARIO}.model.max_hops === 12500")
    write(hops, "2,5")
    assert "whole number" in page.locator(".misread").inner_text()
    write(hops, "9000")
    studio.until(f"{SCENARIO}.model.max_hops === 9000")
    assert page.locator(".misread").count() == 0


@pytest.mark.extended
def test_every_place_that_takes_a_number_reads_a_decimal_comma(studio):
    page = studio.page
    studio.pause()
    page.get_by_role("tab", name="Wind").click()
    write(page.locator(".dial-box input"), "292,5")
    studio.until(f"{SCENARIO}.wind.direction === 292.5")
    page.get_by_role("tab", name="Paint").click()
    write(page.get_by_label("radius"), "2,5")
    assert studio.page.get_by_label("radius").input_value() == "2.5"
    page.get_by_role("tab", name="View").click()
    page.get_by_label("fixed scale").check()
    write(page.get_by_label("Highest value of the colours"), "7,5")
    write(page.get_by_label("Lowest value of the colours"), "0,5")
    assert studio.ask("window.barchan.app.view.look.limits") == [0.5, 7.5]
    write(page.get_by_label("Lowest value of the colours"), "9")
    assert "below the highest" in page.locator(".misread").inner_text()
    assert studio.ask("window.barchan.app.view.look.limits") == [0.5, 7.5]
    page.get_by_label("fixed scale").uncheck()
    page.locator(".scene canvas").first.focus()
    page.keyboard.press("m")
    for box, text in zip(page.locator(".ruler input").all(), ("1,5", "2", "31,5", "42"), strict=True):
        write(box, text)
    rows = page.locator(".ruler table").inner_text()
    assert "50 m" in rows  # of a way of 30 m to the east and 40 m to the north


@pytest.mark.extended
def test_a_sheet_is_not_sent_while_a_number_is_wrong(studio):
    page = studio.page
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Picture with title").click()
    sheet = page.get_by_role("dialog")
    sheet.get_by_label("Size").select_option("free")
    write(sheet.get_by_label("Width (pixels)"), "12")
    assert "From 64 to 8192" in sheet.locator(".misread").inner_text()
    sheet.get_by_role("button", name="save PNG").click()
    assert sheet.is_visible()
    sheet.get_by_label("Width (pixels)").fill("640")
    assert sheet.locator(".misread").count() == 0


def refused(studio, path: str) -> tuple[str, str]:
    """The text at a field that was refused, and why it was."""
    row = studio.page.locator(f".row:has([data-path='{path}']), .dial-box:has([data-path='{path}'])")
    return row.locator(f"[data-path='{path}']").input_value(), row.locator(".misread").inner_text()


@pytest.mark.extended
def test_a_refused_text_stays_with_its_reason_until_it_is_taken_back(studio):
    page = studio.page
    before = studio.ask(f"{SCENARIO}.model.p_s")
    box = page.locator("[data-path='model.p_s']")
    write(box, "1,234")
    standing = refused(studio, "model.p_s")
    assert standing[0] == "1,234"
    assert "1.234" in standing[1]
    write(page.locator("[data-path='model.hop_length']"), "7")
    studio.until(f"{SCENARIO}.model.hop_length === 7")
    studio.catch_up()
    assert refused(studio, "model.p_s") == standing
    studio.ask("window.barchan.app.refused(new Error('Something else.'))")
    assert refused(studio, "model.p_s") == standing
    page.locator("[data-path='model.name']").select_option("momiji")
    studio.until(f"{SCENARIO}.model.name === 'momiji' && {RUN}.description.model.name === 'momiji'")
    page.locator("[data-path='model.speedup_linear']").wait_for()
    assert refused(studio, "model.p_s") == standing
    assert studio.ask(f"{SCENARIO}.model.p_s") == before
    box.press("Escape")
    assert box.input_value() == str(before)
    assert page.locator(".misread").count() == 0


@pytest.mark.extended
def test_a_refused_text_goes_where_another_value_or_another_scenario_takes_its_place(studio):
    page = studio.page
    box = page.locator("[data-path='model.p_s']")
    write(box, "0.5")
    studio.until(f"{SCENARIO}.model.p_s === 0.5")
    write(box, "a half")
    page.locator(".row", has=box).get_by_role("button", name="Put the default").click()
    studio.until("document.querySelector(\"[data-path='model.p_s']\").value === '0.6'")
    assert page.locator(".misread").count() == 0
    write(box, "a half")
    studio.ask(f"window.barchan.app.create({{ ...{SCENARIO}, title: 'Another one' }}, false)")
    studio.until(f"{SCENARIO}.title === 'Another one'")
    studio.until("document.querySelector(\"[data-path='model.p_s']\").value === '0.6'")
    assert page.locator(".misread").count() == 0


@pytest.mark.extended
def test_a_refused_text_of_a_regime_stays_while_others_are_changed_and_goes_with_the_regime(studio):
    page = studio.page
    page.get_by_role("tab", name="Wind").click()
    page.locator("[data-path='wind.kind']").select_option("regimes")
    page.get_by_role("button", name="add a regime").click()
    write(page.locator("[data-path='regimes.1.direction']"), "west")
    standing = refused(studio, "regimes.1.direction")
    assert standing[0] == "west"
    write(page.locator("[data-path='regimes.1.steps']"), "40")
    studio.until(f"{SCENARIO}.wind.regimes[1]?.steps === 40")
    studio.catch_up()
    assert refused(studio, "regimes.1.direction") == standing
    page.locator(".regimes .regime").first.click()
    assert page.locator(".misread").count() == 0
    page.locator(".regimes .regime").last.click()
    assert refused(studio, "regimes.1.direction") == standing
    page.get_by_role("button", name="Up: regime 2").click()
    assert page.locator(".misread").count() == 0
