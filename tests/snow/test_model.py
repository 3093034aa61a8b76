"""Snow moves by the rules, keeps its mass, and does the same however a run is cut."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import barchan
from barchan.errors import ScenarioError
from barchan.kernels.snow.state import ONE_QUANTUM, quanta_of
from barchan.simulation import Simulation
from barchan.snow.conditions import Conditions
from barchan.snow.fields import layers_of
from tests.snow.scenes import SWITCHED_OFF, snow

STORM = {"snowfall": 1e-2, "temperature": -12.0}


def counted(simulation):
    """Quanta in all layers of each cell."""
    return sum(quanta_of(words) for words in layers_of(simulation.bed))


@pytest.mark.parametrize("direction", [270.0, 0.0, pytest.param(250.0, marks=pytest.mark.extended)])
def test_snow_of_one_density_without_closures_moves_as_werners_sand(direction):
    closures = {**SWITCHED_OFF, "erosion_chance": 1.0, "start_density": 100.0, "drift": {"density": 100.0}}
    rules = {"repose": {"drift": 33.7, "fallen": 33.7}, "p_ns": 0.4, "shadow_angle": 15.0, "hop": 0.5}
    ours = snow(wind={"direction": direction}, **closures, **rules)
    sand = Simulation(
        barchan.load(
            {
                "barchan": 5,
                "lattice": {"rows": 32, "columns": 48, "cell_size": 0.1, "slab_height": 0.01},
                "sand": {"kind": "flat", "mean": 10},
                "wind": {"kind": "steady", "direction": direction},
                "model": {"name": "werner", "lee_erosion": False, "shadow_from": "centre"},
                "run": {"steps": 10_000, "seed": 3},
            }
        )
    )
    for simulation in (ours, sand):
        simulation.advance(40)
    np.testing.assert_array_equal(ours.bed.arrays["snow"], sand.bed.sand)
    np.testing.assert_allclose(ours.elevation, sand.elevation, atol=1e-12)


def test_layers_hold_what_the_ledger_counts_in_a_storm_over_open_edges():
    simulation = snow(wind=STORM, lattice={"boundary_x": "open", "boundary_y": "open"}, layers=2)
    simulation.advance(60)
    ledger = simulation.ledger
    assert ledger.entered > 0
    assert ledger.left > 0
    np.testing.assert_array_equal(counted(simulation), simulation.bed.arrays["snow"])
    assert simulation.bed.units == ledger.initial + ledger.entered - ledger.left


@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(cuts=st.lists(st.integers(1, 17), min_size=1, max_size=6), storm=st.booleans())
def test_a_run_is_the_same_however_it_is_cut(cuts, storm):
    weather = STORM if storm else {}
    whole, parts = snow(wind=weather), snow(wind=weather)
    whole.advance(sum(cuts))
    for number, steps in enumerate(cuts):
        parts.advance(steps)
        if number == 1:
            parts = Simulation.from_state(parts.state())
    for name, array in whole.bed.arrays.items():
        np.testing.assert_array_equal(array, parts.bed.arrays[name], err_msg=name)
    assert whole.tally == parts.tally


def test_a_run_of_two_winds_a_step_over_open_edges_is_the_same_however_it_is_cut():
    """Hours of an oblique wind and calms in turn, with influx, so that epochs and packing pass."""
    regimes = [
        {"direction": 270.0, "seconds": 7.0, "speed": 0.0, "unit": "m/s", "snowfall": 1e-3},
        {"direction": 250.0, "seconds": 9.0, "speed": 12.0, "unit": "m/s"},
    ]

    def drifting():
        return snow(
            wind={"kind": "regimes", "regimes": regimes, "direction": None, "speed": None, "unit": None},
            lattice={"boundary_x": "open"},
            influx={"kind": "saturation", "share": 0.5},
            quantum=5.0,
        )

    whole, parts = drifting(), drifting()
    whole.advance(220)
    for steps in (1, 3, 96, 7, 113):
        parts.advance(steps)
        parts = Simulation.from_state(parts.state())
    assert whole.model.clock.time > 3.6e9
    assert whole.model.drift.share > 0.1
    for name, array in whole.bed.arrays.items():
        np.testing.assert_array_equal(array, parts.bed.arrays[name], err_msg=name)


def test_a_quantum_thicker_than_the_steepest_step_stands_by_itself():
    simulation = snow(3, quantum=30.0)
    simulation.advance(2)
    np.testing.assert_array_equal(counted(simulation), simulation.bed.arrays["snow"])


def test_more_older_layers_than_a_cell_keeps_are_refused():
    with pytest.raises(ScenarioError, match="has 3 layers; allowed: up to 2"):
        snow(3, layers=2, beneath=[{}, {}, {}])


@pytest.mark.parametrize("speed", [8.0, 10.0, 12.0, 15.0])
@pytest.mark.parametrize("temperature", [-10.0, -20.0])
def test_flat_loose_snow_carries_the_saturated_flux(speed, temperature):
    closures = {**SWITCHED_OFF, "hop": 0.3, "quantum": 0.1}
    simulation = snow(400, {"speed": speed, "temperature": temperature}, **closures)
    simulation.advance(20)
    before = simulation.tally.travel_x
    steps = 150
    simulation.advance(steps)
    travelled = (simulation.tally.travel_x - before) * 0.1
    seconds = steps * simulation.scenario.step_seconds
    flux = travelled * simulation.model.parameters.quantum / (simulation.lattice.cells * seconds)
    saturated = Conditions(simulation.model.parameters, speed, temperature).flux
    assert flux == pytest.approx(saturated, rel=0.02)


def test_below_the_threshold_time_passes_and_nothing_moves():
    simulation = snow(wind={"speed": 6.4})
    tally = simulation.advance(500)
    assert (tally.polls, tally.moved, tally.steps) == (0, 0, 500)
    fresh = snow(wind={"speed": 6.4}).model.clock
    assert simulation.model.clock.time == 500 * round(simulation.scenario.step_seconds * 1e6)
    assert simulation.model.clock.bonding - fresh.bonding == simulation.model.clock.time


def test_bonded_snow_needs_a_stronger_wind():
    """A day at -10 °C lifts the threshold of drift from 7.6 to 13.2 m/s (0.27th power of 240)."""
    closures = {"start_age": 24.0, "relief": {"acts": False}, "start_density": 350.0}
    quiet, blown = snow(wind={"speed": 12.0}, **closures), snow(wind={"speed": 15.0}, **closures)
    assert quiet.advance(5).moved == 0
    assert blown.advance(5).moved > 0


def test_snowfall_lies_evenly_and_its_mass_is_exact():
    simulation = snow(0, {"speed": 0.0, "snowfall": 5e-3})
    simulation.advance(200)
    mass = 5e-3 * 200 * simulation.scenario.step_seconds
    snow_on_cells = simulation.bed.arrays["snow"]
    assert snow_on_cells.max() - snow_on_cells.min() <= 1
    assert snow_on_cells.mean() == pytest.approx(mass, abs=1.0 / snow_on_cells.size)


def test_fresh_snow_is_light():
    simulation = snow(0, {"speed": 0.0, "snowfall": 5e-2, "temperature": -10.0}, packing={"law": "none"})
    simulation.advance(20)
    words = simulation.bed.arrays["snow_top"]
    density = (words[words >= ONE_QUANTUM] & 0xFFFF) / 64
    np.testing.assert_allclose(density, 69.0, atol=0.1)


def test_older_layers_lie_beneath_the_snow_of_the_start():
    beneath = [{"mass": 4.0, "density": 250.0, "age": 24.0}, {"mass": 2.0, "density": 400.0, "age": 288.0}]
    simulation = snow(3, {"speed": 0.0}, beneath=beneath, start_density=100.0)
    np.testing.assert_array_equal(counted(simulation), 9)
    thickness = 4 * 0.004 + 2 * 0.0025 + 3 * 0.01
    np.testing.assert_allclose(simulation.elevation, thickness, atol=1e-9)


def test_snow_packs_under_its_own_weight_and_keeps_its_mass():
    simulation = snow(
        0,
        {"speed": 0.0, "temperature": -2.0},
        beneath=[{"mass": 300.0, "density": 150.0, "age": 1.0}],
        quantum=10.0,
    )
    before = simulation.elevation.mean()
    simulation.advance(int(3 * 86400 / simulation.scenario.step_seconds))
    assert simulation.elevation.mean() < 0.97 * before
    np.testing.assert_array_equal(counted(simulation), 30)


def test_snow_that_is_painted_becomes_a_layer():
    simulation = snow(5)
    change = np.zeros(simulation.lattice.shape, np.int64)
    change[10:14, 10:14] = 4
    change[20:24, 20:24] = -3
    simulation.bed.lay(change)
    simulation.model.relax(simulation.bed, change != 0)
    np.testing.assert_array_equal(counted(simulation), simulation.bed.arrays["snow"])
    assert simulation.elevation[20:24, 20:24].mean() < simulation.elevation.mean()
