"""Exports from the page."""

from pathlib import Path

import pytest

RUN = "window.barchan.app.runs[0]"


def test_every_format_is_offered_and_the_file_is_downloaded(studio):
    studio.step_beyond(15)
    studio.pause()
    page = studio.page
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Export for other programs").click()
    sheet = page.get_by_role("dialog")
    sheet.get_by_label("Format").wait_for()
    assert sheet.get_by_label("Format").locator("option").count() >= 15
    sheet.get_by_label("Format").select_option("asc")
    sheet.locator("summary", has_text="fields").click()
    sheet.locator("input[type=checkbox][value=depth]").check()
    with page.expect_download() as download:
        sheet.get_by_role("button", name="export", exact=True).click()
    lines = Path(download.value.path()).read_text().splitlines()
    assert lines[0].split() == ["ncols", "64"]
    assert len(lines) == 6 + 48
    assert sheet.count() == 0
    assert download.value.suggested_filename == "barchans.asc"


@pytest.mark.parametrize(
    ("title", "name"),
    [
        ("Dünen am Océan: 1/2", "dunen-am-ocean-1-2"),
        pytest.param("Star dunes, changed: wind.speed 9", "star-dunes", marks=pytest.mark.extended),
        pytest.param("砂丘", "run", marks=pytest.mark.extended),
        pytest.param("a" * 30 + " " + "b" * 30, "a" * 30, marks=pytest.mark.extended),
    ],
)
def test_files_are_named_by_the_title_of_the_run_as_every_system_takes_it(studio, title, name):
    page = studio.page
    studio.pause()
    page.evaluate(f"(title) => void ({RUN}.description.scenario.title = title)", title)
    page.locator("summary", has_text="File").click()
    page.get_by_role("menuitem", name="Film of what was just seen").click()
    assert page.get_by_role("dialog").get_by_label("Name of the file").input_value() == name
