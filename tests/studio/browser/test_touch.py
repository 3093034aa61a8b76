"""The page under fingers: a tap reaches what pointing tells of; fingers paint and turn the view."""

import pytest

from tests.studio.browser.conftest import Studio


@pytest.fixture
def tablet(chromium, studio, server):
    """The page on a screen that is touched, in place of the one of a mouse; the run rests."""
    studio.pause()
    studio.page.close()
    context = chromium.new_context(has_touch=True, viewport={"width": 1024, "height": 768})
    page = context.new_page()
    tablet = Studio(page, studio.process, studio.folder)
    page.goto(server[1])
    tablet.until("window.barchan?.app.runs[0]?.ready")
    yield tablet
    context.close()
    assert tablet.errors == []


def test_a_tap_beside_the_name_of_a_row_shows_what_it_means(tablet):
    page = tablet.page
    page.get_by_role("button", name="What hop length means").tap()
    field = page.locator("[data-path='model.hop_length']")
    said = page.locator(f"#{field.get_attribute('aria-describedby')}")
    assert said.is_visible()
    assert "Allowed: " in said.inner_text()
    row, text = page.locator(".row", has=field).bounding_box(), said.bounding_box()
    assert text["y"] + text["height"] <= row["y"] + row["height"]
    page.screenshot(path=tablet.folder / "explained.png")
    field.fill("7")
    field.press("Enter")
    tablet.until("window.barchan.app.runs[0].description.scenario.model.hop_length === 7")
    button = page.get_by_role("button", name="What hop length means")
    assert button.get_attribute("aria-expanded") == "true"  # also after the form was drawn anew
    button.tap()
    assert page.locator(".explained:visible").count() == 0
