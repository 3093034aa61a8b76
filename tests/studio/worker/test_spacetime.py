import base64

import numpy as np
import pytest

from barchan.errors import BarchanError
from barchan.figures.space_time import section_over_time, suited_times
from barchan.studio.worker.run import started, states_of
from barchan.studio.worker.spacetime import COLUMNS, space_time
from barchan.studio.worker.spacetime_files import Beside, write_space_time
from tests.studio.conftest import small
from tests.studio.worker.test_run import run_to
from tests.tiny import tiny


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


def diagram_file(run, line, target):
    return write_space_time(states_of(run), line, target, lambda _done, _of: None)


def test_the_table_has_a_row_for_each_kept_state_and_a_column_for_each_place(scenario, tmp_path):
    run = started(scenario)
    run_to(run, 25)
    name = diagram_file(run, [0.5, 16.5, 47.5, 16.5], tmp_path / "n" / "over-time.csv")
    table = np.genfromtxt(tmp_path / "n" / name, delimiter=",")
    assert table[1:, 0].tolist() == [0, 10, 20, 25]
    assert np.allclose(table[0, 1:], np.linspace(0.0, 47.0, COLUMNS), atol=1e-4)
    expected = np.interp(np.linspace(0.5, 47.5, COLUMNS), run.live.lattice.x, run.live.elevation[16])
    assert np.allclose(table[-1, 1:], expected, atol=1e-4)


def test_a_run_whose_steps_have_a_duration_has_moments_in_its_table(tmp_path):
    clocked = small(clock={}, wind={"kind": "steady", "speed": 10.0, "unit": "m/s"})
    run = started(clocked)
    run_to(run, 10)
    diagram_file(run, [1.0, 1.0, 40.0, 20.0], tmp_path / "over-time.csv")
    head, *rows = (tmp_path / "over-time.csv").read_text().splitlines()
    assert head.startswith("step,time_s,0.0000,")
    step, moment = rows[-1].split(",")[:2]
    assert float(moment) == pytest.approx(int(step) * clocked.step_seconds, rel=1e-5)


def test_the_picture_has_a_colour_bar_in_metres():
    figure = section_over_time(
        np.arange(4.0), suited_times(np.array([0, 20]), None), np.ones((2, 3)) * [[1], [2]], tiny(), "x"
    )
    diagram, bar = figure.axes
    assert bar.get_ylabel() == "elevation (m)"
    assert diagram.get_ylabel() == "step"
    assert diagram.get_xlabel() == "distance along the section (m)"
    assert diagram.collections[0].get_clim() == (1.0, 2.0)


def test_a_file_of_another_kind_is_refused(scenario, tmp_path):
    with pytest.raises(BarchanError, match=r"allowed: \.csv, \.png"):
        diagram_file(started(scenario), [0.0, 0.0, 9.0, 9.0], tmp_path / "over-time.doc")


@pytest.mark.extended
def test_the_picture_of_one_of_two_runs_has_the_scale_of_both_and_its_name(scenario, tmp_path, monkeypatch):
    drawn = []

    def note(*given, **options):
        drawn.append(section_over_time(*given, **options))
        return drawn[-1]

    monkeypatch.setattr("barchan.figures.space_time.section_over_time", note)
    target = tmp_path / "over-time.png"
    beside = Beside("hop length 5", (-1.0, 40.0))
    states = states_of(started(scenario))
    write_space_time(states, [0.5, 16.5, 47.5, 16.5], target, lambda _done, _of: None, beside)
    diagram = drawn[0].axes[0]
    assert diagram.collections[0].get_clim() == (-1.0, 40.0)
    assert diagram.get_title(loc="left").endswith("hop length 5, from x 0.5, y 16.5 m to x 47.5, y 16.5 m")
    assert target.is_file()


@pytest.mark.parametrize("limits", [(2.0, 1.0), (0.0, float("inf"))])
def test_a_scale_of_colours_from_a_higher_to_a_lower_elevation_or_without_end_is_refused(limits):
    with pytest.raises(BarchanError, match="lowest and a highest"):
        Beside("hop length 5", limits)
