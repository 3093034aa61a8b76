"""Images as ground: what their sheet asks for, and comparing the surface with the same image."""

import io

import numpy as np
import pytest
from PIL import Image

RUN = "window.barchan.app.runs[0]"
SCENARIO = f"{RUN}.description.scenario"


def coloured(columns: int, rows: int) -> bytes:
    """A rise to the east in greys, stored in colours, as drawing programs do."""
    content = io.BytesIO()
    greys = np.tile(np.linspace(0, 255, columns).astype(np.uint8), (rows, 1))
    Image.fromarray(greys).convert("RGB").save(content, "PNG")
    return content.getvalue()


def test_an_image_keeps_its_proportions_and_gets_the_heights_that_are_asked_for(studio):
    """64 × 48 cells in the proportions 2 : 1: (64 · 48 / 2)^½ = 39.2 rows, and twice as many columns."""
    studio.drop_file("rise.png", "image/png", coloured(48, 24))
    sheet = studio.page.get_by_role("dialog", name="Ground from a file")
    sheet.get_by_text("gets 78 × 39").wait_for()
    sheet.get_by_text("upper edge of the image is north").wait_for()
    sheet.get_by_label("Shape of the field").select_option("stretch")
    sheet.get_by_text("a round hill becomes an oval").wait_for()
    assert studio.ask(f"{SCENARIO}.ground.kind") != "file"
    sheet.get_by_label("Shape of the field").select_option("keep")
    sheet.get_by_label("Height of black").fill("2")
    sheet.get_by_label("Height of white").fill("12")
    sheet.get_by_role("button", name="use it").click()
    sheet.wait_for(state="detached")
    studio.until(f"{RUN}.ground.length === 78 * 39 && {SCENARIO}.ground.kind === 'file'")
    assert studio.ask(f"[{SCENARIO}.ground.lowest, {SCENARIO}.ground.highest]") == [2, 12]
    ground = np.array(studio.ask(f"[...{RUN}.ground]")).reshape(39, 78)
    assert [ground[:, 0].mean(), ground[:, -1].mean()] == pytest.approx([2.0, 12.0], abs=0.3)


def test_an_image_that_fits_the_field_is_told_nothing_of_and_is_not_compared_with_other_heights(studio):
    """64 × 48 cells of 1 m: white is 0.08 · 64 = 5.1 m high at first."""
    image = {"name": "slope.png", "mimeType": "image/png", "buffer": coloured(32, 24)}
    studio.drop_file(image["name"], image["mimeType"], image["buffer"])
    sheet = studio.page.get_by_role("dialog", name="Ground from a file")
    assert sheet.get_by_label("Height of white").input_value() == "5.1"
    sheet.get_by_label("Height of white").fill("7")
    assert not sheet.get_by_text("32 × 24 pixels").is_visible()
    sheet.get_by_role("button", name="use it").click()
    studio.until(f"{SCENARIO}.ground.highest === 7")
    studio.step_beyond(0)
    studio.pause()
    studio.page.locator("summary", has_text="File").first.click()
    studio.page.get_by_role("menuitem", name="Compare with a terrain").click()
    sheet = studio.page.get_by_role("dialog")
    sheet.get_by_label("Terrain or photograph").set_input_files(image)
    sheet.get_by_label("Read as").select_option("terrain")
    assert sheet.get_by_label("Height of white").input_value() == "7"
    assert not sheet.get_by_role("checkbox").is_checked()
    sheet.get_by_role("button", name="drape it").click()
    sheet.wait_for(state="detached")
    scale = studio.page.locator(".colours:visible")
    scale.filter(has_text="draped: elevation of slope.png (m)").wait_for()
    low, _, high = (float(mark) for mark in scale.locator(".bar-ends span").all_inner_texts())
    assert (low, high) == pytest.approx((0, 7), abs=0.3)
    card, close = (studio.page.locator(one).bounding_box() for one in (".toast.way", ".toast.way .close"))
    scene = studio.page.locator(".scene").bounding_box()
    assert card["height"] < 40
    assert (
        scene["x"]
        < card["x"]
        < close["x"] + close["width"]
        < card["x"] + card["width"]
        < scene["x"] + scene["width"]
    )
    studio.page.screenshot(path=studio.folder / "draped.png")
    studio.ask("window.barchan.app.view.set({ field: 'above_overlay' })")
    scale.filter(has_text="elevation less that of the overlay").wait_for()
    studio.until(f"{RUN}.fields.get('above_overlay')")
    above, depth = (
        np.array(studio.ask(f"[...{RUN}.{of}]")) for of in ("fields.get('above_overlay')", "depth")
    )
    np.testing.assert_allclose(above, depth, atol=1e-3)
    bare = f"window.barchan.stage.terrain({RUN}).uniforms.bare.value"
    studio.until(f"{bare} === 0")
    studio.ask("window.barchan.app.view.set({ field: 'elevation' })")
    studio.until(f"{bare} === 1")
