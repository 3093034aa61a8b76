"""Every way in which the connection can fail has its own words and its own way out."""

import io
import re

import numpy as np
import pytest
from PIL import Image

from tests.studio.browser.conftest import NOTICE, running, says, until
from tests.studio.conftest import serving, small


@pytest.mark.extended
def test_an_address_without_a_token_asks_for_the_whole_one(visit, server):
    address = server[1]
    page = visit(re.sub(r"\?.*", "", address))
    says(page, "lacks the token")
    page.get_by_label("Address or token").fill(address)
    page.get_by_label("Address or token").press("Enter")
    running(page)


def test_a_wrong_token_is_named_as_such_and_a_token_alone_is_taken(visit, server):
    address = server[1]
    page = visit(re.sub("token=.*", "token=stale", address))
    says(page, "is not the present one")
    page.get_by_label("Address or token").fill(address.partition("token=")[2])
    page.get_by_role("button", name="open").click()
    running(page)
    assert page.evaluate("window.barchan.app.notices.log.filter((entry) => entry.level === 'error')") == []


@pytest.mark.extended
def test_a_window_that_lost_the_studio_to_another_takes_it_back(visit, server):
    first = visit(server[1])
    running(first)
    second = visit(server[1])
    running(second)
    says(first, "another window")
    first.get_by_role("button", name="use it here").click()
    running(first)
    says(second, "another window")


WAY_BACK = (
    "window.barchan.app.notices.note('info', 'Set aside', '', true, { name: 'go back to it', act: () => {} })"
)


@pytest.mark.extended
def test_a_server_that_ends_is_reported_and_one_that_comes_back_is_found(visit, tmp_path):
    with serving(tmp_path, small()) as served:
        page = visit(f"{served.address}/?token={served.guard.token}")
        running(page)
        port = served.port
        page.evaluate("window.barchan.app.send({ command: 'run' })")
        until(page, "window.barchan.app.running")
        page.evaluate(WAY_BACK)
        lead = page.get_by_role("button", name="go back to it")
        assert lead.is_enabled()
    says(page, "does not answer")
    says(page, "the studio offers them when it starts again")
    assert page.get_by_role("button", name="try now").is_visible()
    assert page.locator("[data-status=rate]").inner_text() == "no server"
    assert page.get_by_label("Run (space)", exact=True).is_disabled()
    assert lead.is_disabled()
    with serving(tmp_path, small(), port=port):  # with a token of its own
        page.locator(NOTICE, has_text="is not the present one").wait_for(timeout=10_000)


@pytest.mark.extended
def test_a_flood_of_messages_is_named_and_the_page_connects_again(visit, server):
    page = visit(server[1])
    running(page)
    page.evaluate("for (let i = 0; i < 3000; i++) window.barchan.app.send({ command: 'saved' })")
    says(page, "more messages")
    page.get_by_role("button", name="connect again").click()
    running(page)


@pytest.mark.extended
def test_a_page_of_another_version_offers_to_load_it_again(visit, server):
    page = visit(server[1])
    running(page)
    page.evaluate("window.barchan.app.connection.state.send('other version')")
    says(page, "another version")
    page.get_by_role("button", name="load the page again").click()
    page.wait_for_load_state()
    running(page)


NO_WEBGL = """const usual = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
  return kind.startsWith("webgl") ? null : usual.call(this, kind, ...rest);
};"""


def test_without_webgl_the_surface_is_shown_from_above_and_can_be_painted(chromium, server):
    page = chromium.new_page(viewport={"width": 1000, "height": 640})
    try:
        page.add_init_script(NO_WEBGL)
        page.goto(server[1])
        says(page, "WebGL is off or missing")
        page.get_by_role("button", name="go on with the map").click()
        page.locator(NOTICE).wait_for(state="hidden")
        canvas = page.locator(".scene canvas").first
        shot = np.asarray(Image.open(io.BytesIO(canvas.screenshot())).convert("RGB")).astype(float)
        assert len(np.unique(shot.reshape(-1, 3), axis=0)) > 200  # lit slopes, no single colour
        page.mouse.move(470, 280)
        page.locator(".under", has_text="elevation").wait_for()
        page.get_by_role("tab", name="Paint").click()
        page.get_by_text("paint (B)").click()
        page.mouse.move(300, 280)
        page.mouse.down()
        page.mouse.move(330, 290)
        page.mouse.up()
        page.get_by_role("button", name="Undo").and_(page.locator(":enabled")).wait_for()
        page.get_by_role("button", name="Undo").click()
    finally:
        page.close()
