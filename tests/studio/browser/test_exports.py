"""Exports from the page."""

from pathlib import Path


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
