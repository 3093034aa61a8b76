"""Brushes of fresh snow and of ice: exact to the quantum, undone without a trace."""

import numpy as np
import pytest

from barchan.analysis.balance import balance_now
from barchan.errors import ScenarioError
from barchan.kernels.snow.state import ONE_QUANTUM, density_of, quanta_of
from barchan.simulation import IceStroke, Simulation, SnowfallStroke
from barchan.studio.worker.painting import Painting
from tests.snow.scenes import snow
from tests.tiny import tiny

PATCH = {"x": 2.4, "y": 1.6, "radius": 0.5, "falloff": "none"}


def painted(simulation, *strokes):
    painting = Painting()
    painting.begin(simulation)
    for stroke in strokes:
        painting.stroke(simulation, stroke)
    painting.end(simulation)
    return painting


def test_a_brush_of_snowfall_lays_whole_quanta_of_its_density_on_top():
    """Disc of 0.5 m on cells of 0.1 m: cells whose centre lies within it, counted by hand; 4 quanta each."""
    simulation = snow(mean=10)
    before = simulation.bed.units
    simulation.apply(SnowfallStroke(**PATCH, amount=4, density=80.0))
    rows, columns = np.indices(simulation.lattice.shape)
    inside = np.hypot((columns + 0.5) * 0.1 - 2.4, (rows + 0.5) * 0.1 - 1.6) < 0.5
    assert simulation.bed.units - before == 4 * np.count_nonzero(inside)
    top = simulation.bed.arrays["snow_top"]
    covered = inside & (density_of(top) == 80.0)
    assert np.count_nonzero(covered) > 0.9 * np.count_nonzero(inside)
    assert (quanta_of(top[covered]) <= 4).all()
    # Ten quanta of drift and four of fresh snow, 1 kg/m² each, at 80 kg/m³: 12.5 mm a quantum.
    centre = simulation.bed.depth[16, 24] - simulation.bed.depth[0, 0]
    assert centre == pytest.approx(4 * 0.0125, abs=2e-4)


def test_fresh_snow_and_ice_are_undone_to_the_bit():
    simulation = snow(mean=6)
    simulation.advance(3)
    before = simulation.state()
    painting = painted(
        simulation, SnowfallStroke(**PATCH, amount=5, density=70.0), IceStroke(**PATCH, amount=0.15)
    )
    assert simulation.bed.ground.max() == pytest.approx(0.15)
    undone = painting.undo(simulation)
    for name, array in before.arrays.items():
        np.testing.assert_array_equal(undone.state().arrays[name], array, err_msg=name)
    again = painting.redo(undone)
    np.testing.assert_array_equal(again.bed.arrays["snow_top"], simulation.bed.arrays["snow_top"])


def test_fresh_snow_is_taken_back_after_steps_and_the_balance_closes():
    simulation = snow(mean=6)
    painting = painted(simulation, SnowfallStroke(**PATCH, amount=5, density=70.0))
    laid = balance_now(simulation).entered
    assert laid > 0
    simulation.advance(3)
    painting.stepped()
    after = balance_now(painting.undo(simulation))
    assert after.entered == laid
    assert 0 < after.left <= laid
    assert after.missing == 0


def test_scenario_and_strokes_give_the_same_bits_again():
    strokes = [SnowfallStroke(**PATCH, amount=3, density=120.0), IceStroke(**PATCH, amount=0.1)]
    fields = []
    for _ in range(2):
        simulation = snow(mean=6)
        for stroke in strokes:
            simulation.apply(stroke)
            simulation.advance(5)
        fields.append(simulation.bed.frame())
    for name in fields[0]:
        np.testing.assert_array_equal(fields[0][name], fields[1][name], err_msg=name)


def test_sand_takes_no_fresh_snow():
    with pytest.raises(ScenarioError, match="is snowfall; allowed with werner: stroke"):
        Simulation(tiny()).apply(SnowfallStroke(x=5.0, y=5.0, radius=3.0, amount=2, density=100.0))


def test_a_density_that_no_snow_has_is_refused():
    with pytest.raises(ScenarioError, match=r"density.*12.*30"):
        SnowfallStroke(**PATCH, amount=2, density=12.0)


def test_fallen_snow_is_told_from_what_enters_and_is_brushed():
    """0.01 kg/m²/s for 50 steps of 4.3 s: 2.1 kg/m² or quanta on each cell, to one on the whole field."""
    simulation = snow(mean=6, wind={"snowfall": 0.01, "temperature": -10.0})
    simulation.advance(50)
    balance = balance_now(simulation)
    expected = 0.01 * 50 * simulation.scenario.step_seconds * simulation.lattice.cells
    assert balance.fallen == pytest.approx(expected, abs=1)
    assert (balance.entered, balance.left, balance.missing) == (0, 0, 0)
    assert balance.held == balance.start + balance.fallen
    simulation.apply(SnowfallStroke(**PATCH, amount=4, density=80.0))
    assert balance_now(simulation).fallen == balance.fallen
    assert balance_now(simulation).entered > 0
    assert (simulation.bed.arrays["snow_top"] >= ONE_QUANTUM).any()
