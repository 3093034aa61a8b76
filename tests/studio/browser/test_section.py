"""The section tells of a surface what it draws of it, to the slope between two points."""

import csv
import math
from itertools import pairwise
from pathlib import Path

import pytest

RUN = "window.barchan.app.runs[0]"

pytestmark = pytest.mark.extended

STEP = f"""(() => {{
    const {{ app }} = window.barchan, run = {RUN};
    run.description.lattice.cell_size = 0.1;
    const heights = run.surface.map((_, i) => (i % 64 < 30 ? 0.0333 : 0.0783));
    for (const [name, values] of [["surface", heights], ["ground", heights.map(() => 0)]])
        Object.defineProperty(run, name, {{ get: () => values.slice(), set: () => {{}} }});
    run.description.strata = [{{ name: "age", title: "age", unit: "h", states: [] }}];
    const ask = app.ask.bind(app);
    app.ask = (one) => one.command !== "strata" ? ask(one) : Promise.resolve({{
        step: run.status.step,
        place: Array.from({{ length: 65 }}, (_, i) => i / 10),
        ground: Array(64).fill(0),
        thickness: [Array.from({{ length: 64 }}, (_, i) => (i < 30 ? 0.0333 : 0.0783))],
        values: [Array(64).fill(5)],
    }});
    app.described.send(run);
    app.changed.send();
}})()"""
"""A step of 45 mm between two cells of 0.1 m, 33.3 and 78.3 mm high, of snow of one layer."""


def saved(page) -> list[dict[str, str]]:
    with page.expect_download() as download:
        page.get_by_role("button", name="Save the section as CSV").click()
    return list(csv.DictReader(Path(download.value.path()).read_text().splitlines()))


def test_a_section_of_layers_reads_whole_cells_as_it_draws_them(studio):
    """The line is that along a wind from the west: through the cells of row 24 of 48, at their centres."""
    page = studio.page
    studio.pause()
    page.keyboard.press("1")
    studio.until(f"{RUN}.fields.has('shadow')")
    studio.ask(STEP)
    rows = saved(page)
    assert {row["y_m"] for row in rows} == {"2.450"}
    assert [float(row["x_m"]) for row in rows] == pytest.approx([0.05 + 0.1 * i for i in range(64)], abs=1e-3)
    assert [row["elevation_m"] for row in rows[28:32]] == ["0.0333", "0.0333", "0.0783", "0.0783"]
    slopes = [float(row["slope_degrees"]) for row in rows]
    assert slopes[29] == pytest.approx(math.degrees(math.atan2(0.045, 0.1)), abs=0.01)  # 24.2 degrees
    assert slopes[28] == slopes[30] == slopes[-1] == 0
    plot = page.locator(".plot:visible")
    box = plot.bounding_box()
    across = 54 + (29.9 / 64) * (box["width"] - 54 - 14)  # within the last low cell, beside the step
    plot.hover(position={"x": across, "y": box["height"] / 2})
    readout = page.locator(".readout:visible")
    studio.until(
        "document.querySelector('.view:not([hidden]) .readout').textContent.includes('from the top')"
    )
    assert "elevation 33.3 mm" in readout.inner_text()
    assert "slope 24.2°" in readout.inner_text()
    assert "from the top: 33.3 mm" in readout.inner_text()
    assert f"slope {slopes[29]:.1f}°" in readout.inner_text()


def test_slopes_follow_from_the_elevations_beside_them(studio):
    studio.step_beyond(100)
    studio.pause()
    studio.page.keyboard.press("1")
    rows = [
        [float(row[key]) for key in ("distance_m", "elevation_m", "slope_degrees")]
        for row in saved(studio.page)
    ]
    for (d, z, slope), (further, next_z, _) in pairwise(rows):
        assert slope == pytest.approx(math.degrees(math.atan2(next_z - z, further - d)), abs=0.03)
    assert max(abs(slope) for _, _, slope in rows) > 5


def test_the_usual_exaggeration_depends_on_the_smoothing_and_not_on_that_before(studio):
    studio.step_beyond(100)
    studio.pause()
    chosen = []
    for smoothing in (0, 1, 0, 1):
        studio.ask(f"window.barchan.app.view.set({{ smoothing: {smoothing}, exaggeration: null }})")
        studio.picture()
        chosen.append(studio.ask(f"window.barchan.stage.terrain({RUN}).exaggeration"))
    assert chosen[:2] == chosen[2:]
    assert chosen[0] < chosen[1]
