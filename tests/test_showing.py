"""Objects show themselves in few words, with units."""

import numpy as np

import barchan
from barchan.analysis.declared_measures import MEASURES
from barchan.analysis.time_series import measured_frames
from barchan.measures.migration import Migration
from barchan.measures.orientation import Orientation
from barchan.measures.slopes import Slopes
from tests.tiny import tiny


def test_a_scenario_shows_model_lattice_and_length():
    text = repr(tiny(title="Small dunes", run__seed=None))
    assert text == str(tiny(title="Small dunes", run__seed=None))
    assert text.startswith("<Scenario 'Small dunes': werner, 24 × 16 cells of 1 m, slabs of 0.333 m, ")
    assert "steps" in text
    assert text.endswith("no seed yet>")
    assert len(text) < 160


def test_a_scenario_with_a_clock_shows_the_duration_of_its_steps():
    assert " steps of " in repr(tiny(clock={"grain_diameter": 0.00025, "reference_speed": 8.0}))


def test_every_preset_shows_itself_in_a_line():
    for name in barchan.preset_names():
        text = repr(barchan.load(name))
        assert "\n" not in text
        assert len(text) < 300


def test_a_notebook_shows_a_scenario_as_a_table_without_running_its_text_as_html():
    html = tiny(title="<b>Dunes</b>")._repr_html_()
    assert html.startswith("<table>")
    assert "&lt;b&gt;Dunes" in html
    assert "from 270° with hops of 5 cells" in html


def test_a_simulation_shows_how_far_it_is_and_its_bed_in_units():
    simulation = barchan.Simulation(tiny(title="Small"))
    simulation.advance(3)
    assert repr(simulation).startswith("<Simulation of 'Small': werner, step 3 of ")
    assert f"{simulation.bed.units} slabs of sand, elevation " in repr(simulation)
    assert repr(simulation).endswith(" m>")
    assert "step 3 of" in simulation._repr_html_()
    assert "24 × 16 cells" in simulation._repr_html_()


def test_a_frame_shows_its_fields():
    frame = barchan.Simulation(tiny()).frame()
    assert repr(frame) == "<Frame at step 0: ground, sand on 16 × 24 cells, wind from 270°>"


def test_an_outcome_shows_where_the_run_lies_and_why_it_ended(tmp_path):
    outcome = barchan.run(barchan.Simulation(tiny(run__steps=4)), tmp_path / "run")
    assert repr(outcome).startswith(f"<Outcome in {tmp_path / 'run'}: step 4, all steps done")


def test_measures_show_their_units():
    assert repr(MEASURES[3]) == "<Measure spacing: dominant spacing (m)>"
    assert repr(MEASURES[2]) == "<Measure bare_fraction: bare ground (fraction)>"
    assert repr(Orientation(12.34, 0.5)) == "<Orientation 12.3° from north, coherence 0.50>"
    assert repr(Slopes(9.96, np.nan)) == "<Slopes windward 10.0°, lee nan°>"
    assert repr(Migration(0.1, -0.02, 0.9)) == (
        "<Migration 0.1 east, -0.02 north (cells per step), correlation 0.90>"
    )


def test_a_measured_frame_does_not_print_its_arrays():
    scenario = tiny(run__steps=5)
    frame = next(measured_frames(barchan.simulate(scenario), scenario))
    assert repr(frame) == "<MeasuredFrame of 16 × 24 cells, 0 steps after the one before>"
