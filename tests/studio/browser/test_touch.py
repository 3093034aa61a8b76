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
    page.get_by_role("tab", name="Wind").tap()
    page.get_by_role("button", name="What gusts means").tap()  # of a group that may be left out
    assert len(page.locator(".explained:visible").inner_text()) > 10
    page.screenshot(path=tablet.folder / "explained-group.png")
    page.get_by_role("button", name="What gusts means").tap()
    page.get_by_role("button", name="What wind means").tap()  # of a choice: what each kind is
    assert "regimes: Winds one after the other." in page.locator(".explained:visible").inner_text()


def drag_fingers(page, *paths):
    """Put down a finger at the beginning of each path, the first one first, and drag all to their ends."""
    send = page.context.new_cdp_session(page).send

    def touch(kind, points):
        at = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(points)]
        send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": at})
        page.wait_for_timeout(60)

    starts, ends = zip(*paths, strict=True)
    for count in range(1, len(paths) + 1):
        touch("touchStart", starts[:count])
    for share in (0.25, 0.5, 0.75, 1):
        pairs = zip(starts, ends, strict=True)
        touch("touchMove", [[p + share * (q - p) for p, q in zip(*pair, strict=True)] for pair in pairs])
    touch("touchEnd", [])


def test_with_a_brush_one_finger_paints_and_two_turn_the_view(tablet):
    page = tablet.page
    tablet.ask("window.barchan.app.view.set({ turning: false })")
    page.get_by_role("tab", name="Paint").tap()
    page.get_by_text("paint (B)").tap()
    box = page.locator(".scene canvas").first.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] * 0.55
    stand = "window.barchan.stage.standpoint()"
    tablet.ask(f"window.barchan.stage.stand({stand})")  # from now on it follows no surface that grows
    stood = tablet.ask(stand)
    drag_fingers(page, [(x, y), (x + 40, y)])
    tablet.until("window.barchan.app.runs[0].status.undo")
    assert tablet.ask(stand) == stood
    page.get_by_role("button", name="undo").first.tap()
    tablet.until("!window.barchan.app.runs[0].status.undo")
    drag_fingers(page, [(x - 40, y), (x - 10, y)], [(x + 40, y), (x + 70, y)])
    turned = tablet.ask(stand)
    assert turned["position"] != stood["position"]
    assert turned["target"] == pytest.approx(stood["target"])
    tablet.ask("new Promise((done) => setTimeout(done, 500))")
    assert not tablet.ask("window.barchan.app.runs[0].status.undo")
