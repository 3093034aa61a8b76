"""A view of a simulation as an object, without Jupyter: traits for the page, commands, errors."""

import threading
import time

import numpy as np
import pytest

import barchan
from barchan import BarchanError, Simulation
from barchan.studio.server.app import CLIENT
from tests.studio.frames import read_frame
from tests.tiny import tiny

pytest.importorskip("anywidget")
pytestmark = pytest.mark.skipif(not (CLIENT / "notebook.js").is_file(), reason="the client is not built")

PATIENCE = 20.0


@pytest.fixture
def view():
    """Makes views, and closes them."""
    from barchan.notebook import view as make

    made = []

    def made_of(shown, **options):
        made.append(make(shown, **options))
        return made[-1]

    yield made_of
    for one in made:
        one.close()


def until(holds):
    end = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.01)


def clicked(shown, **command):
    """A command as a button of the page sends it."""
    shown._handle_custom_msg(command, [])


def frame_of(shown):
    """The newest header and the fields that the page has: the ground is that of the last frame with one."""
    until(lambda: shown.ground_frame)
    header, fields = read_frame(shown.ground_frame)
    if shown.frame:
        header, newer = read_frame(shown.frame)
        fields |= newer
    return header, fields


def test_the_page_gets_the_first_surface_with_its_description_and_colours(view):
    shown = view(tiny())
    header, fields = frame_of(shown)
    first = Simulation(tiny())
    assert (header["rows"], header["columns"], header["status"]["step"]) == (16, 24, 0)
    assert fields["ground"] + fields["depth"] == pytest.approx(first.elevation.ravel(), abs=1e-6)
    assert shown.description["lattice"]["cell_size"] == 1.0
    assert len(shown.colours["perceptual"]) == 64


def test_steps_give_the_bits_of_a_simulation_alone(view):
    shown = view(tiny())
    shown.run(12)
    shown.wait(PATIENCE)
    alone = Simulation(tiny())
    alone.advance(12)
    assert shown.step == 12
    assert np.array_equal(shown.simulation().bed.sand, alone.bed.sand)


def test_a_frame_follows_each_confirmation(view):
    shown = view(tiny())
    shown.run(3)
    shown.wait(PATIENCE)
    for _ in range(3):
        clicked(shown, command="confirm")
    until(lambda: frame_of(shown)[0]["status"]["step"] == 3)


def test_a_second_page_gets_the_ground_again(view):
    shown = view(tiny(ground={"kind": "bump", "height": 3.0, "radius": 6.0}))
    frame_of(shown)
    shown.run(2)
    shown.wait(PATIENCE)
    clicked(shown, command="attach")
    until(lambda: read_frame(shown.ground_frame)[0]["status"]["step"] == 2)
    assert read_frame(shown.ground_frame)[1]["ground"].max() > 2.0
    assert shown.frame == b""


def test_the_simulation_that_is_shown_stays_as_it_is(view):
    simulation = Simulation(tiny())
    simulation.advance(4)
    shown = view(simulation)
    shown.run(until=6)
    shown.wait(PATIENCE)
    assert (simulation.steps_done, shown.step) == (4, 6)


def test_frames_of_a_run_are_looked_at_one_by_one(view):
    run = barchan.simulate(tiny())
    shown = view(run)
    assert (shown.steps, shown.step) == ([0, 5, 10, 15, 20], 20)
    clicked(shown, command="confirm")
    clicked(shown, command="look", step=10)
    until(lambda: frame_of(shown)[0]["status"]["step"] == 10)
    _, fields = frame_of(shown)
    assert fields["ground"] + fields["depth"] == pytest.approx(
        run.elevation.sel(step=10).values.ravel(), abs=1e-6
    )


def test_frames_of_a_run_cannot_go_on(view):
    shown = view(barchan.simulate(tiny()))
    assert not shown.continues
    with pytest.raises(BarchanError, match="to go on takes its scenario or its folder"):
        shown.run(1)
    with pytest.raises(BarchanError, match="to go on takes its scenario or its folder"):
        shown.simulation()


def test_the_run_in_a_folder_goes_on_with_the_same_bits_and_the_folder_stays(view, tmp_path):
    barchan.run(Simulation(tiny()), tmp_path / "run")
    shown = view(tmp_path / "run")
    assert shown.steps == [0, 5, 10, 15, 20]
    shown.run(until=25)
    shown.wait(PATIENCE)
    alone = Simulation(tiny())
    alone.advance(25)
    assert np.array_equal(shown.simulation().bed.sand, alone.bed.sand)
    assert list(barchan.open_run(tmp_path / "run").step.values) == [0, 5, 10, 15, 20]


def test_a_preset_is_shown_with_its_overrides(view):
    shown = view("barchans", rows=16, columns=24, sand={"kind": "flat", "mean": 2})
    assert shown.description["lattice"]["rows"] == 16


@pytest.mark.parametrize("field", ["slope", "shadow", "change"])
def test_fields_of_the_page_and_of_the_model_colour_the_surface(view, field):
    assert view(tiny(), field=field).field == field


def test_a_field_that_does_not_exist_is_refused_with_those_that_do(view):
    with pytest.raises(BarchanError, match="no field 'heigt' to colour by; there are natural, elevation"):
        view(tiny(), field="heigt")


def test_whatever_is_no_run_is_refused(view):
    with pytest.raises(BarchanError, match="no view of a ndarray; allowed are"):
        view(np.zeros((4, 4)))
    with pytest.raises(BarchanError, match="steps: a simulation cannot be changed; a scenario can"):
        view(Simulation(tiny()), steps=4)


def test_a_refusal_is_an_error_in_python_and_a_text_on_the_page(view):
    shown = view(tiny())
    sent = []
    shown.send = sent.append
    with pytest.raises(BarchanError, match="could not convert string to float"):
        shown.limit("fast")
    assert not sent
    clicked(shown, command="limit", rate="fast")
    until(lambda: shown.error)
    assert "could not convert" in shown.error
    assert sent[-1]["type"] == "refused"


@pytest.mark.parametrize("content", [{"command": "resume"}, {"command": "fly"}, {}, "run", None])
def test_what_is_no_command_of_a_view_is_refused_and_ends_nothing(view, content):
    shown = view(tiny())
    shown._handle_custom_msg(content, [])
    assert shown.error
    shown.run(1)
    shown.wait(PATIENCE)


def test_closing_ends_the_thread_and_lets_the_run_go(view):
    shown = view(tiny())
    shown.run()
    shown.close()
    assert not [one for one in threading.enumerate() if one.name == "barchan view"]
    with pytest.raises(BarchanError, match="the view is closed"):
        shown.run(1)
    shown.close()


def test_a_missing_library_is_named_with_the_advice(monkeypatch):
    import sys

    from barchan.notebook import view as make

    monkeypatch.setitem(sys.modules, "anywidget", None)
    monkeypatch.delitem(sys.modules, "barchan.notebook.widget", raising=False)
    with pytest.raises(
        BarchanError, match="needs anywidget; install it with: python -m pip install anywidget"
    ):
        make(tiny())
