import base64

import numpy as np
import pytest

from barchan.errors import BarchanError
from barchan.studio.worker.run import started
from barchan.studio.worker.spacetime import COLUMNS, space_time
from tests.studio.conftest import small
from tests.studio.worker.test_run import run_to


def heights_of(diagram):
    numbers = np.frombuffer(base64.b64decode(diagram["values"]), "<u2").reshape(-1, diagram["columns"])
    return diagram["low"] + diagram["scale"] * numbers


def test_the_section_of_every_remembered_state_and_of_now_is_diagram(scenario):
    run = started(scenario)
    run_to(run, 25)
    diagram = space_time(run, [0.5, 16.5, 47.5, 16.5])
    assert diagram["steps"] == [0, 10, 20, 25]
    places = np.linspace(0.5, 47.5, COLUMNS)
    centres = run.live.lattice.x
    expected = np.interp(places, centres, run.live.elevation[16])
    assert np.allclose(heights_of(diagram)[-1], expected, atol=2 * diagram["scale"])


def test_a_section_across_a_plane_is_straight_whatever_its_direction():
    run = started(small(ground={"kind": "ramp", "height": 4.0}, sand={"kind": "flat", "mean": 0}))
    elevation = run.live.elevation
    diagram = space_time(run, [10.0, 5.0, 40.0, 25.0])
    row = heights_of(diagram)[0]
    assert np.abs(np.diff(row, 2)).max() < 4 * diagram["scale"]
    assert elevation.min() <= row.min() < row.max() <= elevation.max()


@pytest.mark.parametrize("line", [[1.0, 2.0], [0.0, 0.0, float("nan"), 1.0]])
def test_what_is_no_line_is_refused(scenario, line):
    with pytest.raises(BarchanError, match="two places"):
        space_time(started(scenario), line)
