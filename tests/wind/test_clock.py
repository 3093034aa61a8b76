"""How long a step lasts, and how many polls a wind is worth."""

import numpy as np
import pytest

import barchan
from barchan.errors import ScenarioError
from barchan.measures.amounts import flux
from barchan.models import models
from barchan.scenario import validate
from barchan.simulation import Simulation
from barchan.slabs.model import SlabModel
from barchan.wind import Clock
from barchan.wind.clock import YEAR, spoken
from tests.tiny import tiny

DEEP = {"kind": "flat", "mean": 50}
METRES = {"kind": "steady", "speed": 10.0, "unit": "m/s"}


def by_the_clock(model):
    return issubclass(model, SlabModel) and model(model.Parameters(), tiny().lattice).step_seconds is None


SLAB_MODELS = [name for name, model in models().items() if by_the_clock(model)]


@pytest.mark.parametrize("name", SLAB_MODELS)
def test_the_first_step_moves_the_volume_that_the_clock_counts_on(name):
    """Measured from the travel of slabs in one step over a flat bed, whose surface hardly changes in it."""
    data = tiny(sand=DEEP, lattice={"rows": 64, "columns": 128}, model={"name": name}, wind=METRES, clock={})
    simulation = Simulation(data)
    volume = simulation.model.step_volume()
    quarter = validate({**data.data(), "wind": {**METRES, "speed": 7.0}}, "test")
    thin = Simulation(quarter)
    tally = thin.advance(1)
    polls = tally.polls / thin.lattice.cells
    moved = flux(tally.travel_x, thin.lattice.cells, 1, thin.lattice.thickness, thin.lattice.cell_size)
    assert moved == pytest.approx(volume * polls, rel=0.15)


def test_the_flux_of_a_long_run_on_a_flat_bed_is_the_laws():
    """Slabs that hop far over a bed kept flat by a low angle of repose come near the wind's own flux."""
    clock = {"grain_diameter": 0.3e-3, "law": "lettau"}
    scenario = tiny(
        sand=DEEP, lattice={"rows": 64, "columns": 128}, wind={**METRES, "speed": 8.0}, clock=clock
    )
    tally = Simulation(scenario).advance(2)
    lattice = scenario.lattice
    moved = (
        flux(tally.travel_x, lattice.cells, 2, lattice.thickness, lattice.cell_size) / scenario.step_seconds
    )
    assert moved == pytest.approx(float(scenario.clock.volume_flux(8.0)), rel=0.15)


def test_the_reference_wind_polls_as_many_cells_as_the_field_has():
    scenario = tiny(clock={"reference_speed": 9.0}, wind={**METRES, "speed": 9.0})
    (together,) = scenario.forcing().segments(0, 1)
    assert together[0].polls == scenario.lattice.cells


def test_a_wind_below_the_threshold_moves_nothing_and_time_passes():
    simulation = Simulation(tiny(clock={}, wind={**METRES, "speed": 5.0}))
    assert simulation.advance(6).polls == 0
    assert simulation.steps_done == 6


def test_a_stated_duration_scales_the_polls():
    polls = [
        Simulation(tiny(clock={"step_seconds": s}, wind=METRES)).advance(1).polls
        for s in (40_000.0, 80_000.0)
    ]
    assert polls[1] == pytest.approx(2 * polls[0], abs=2)


def test_hops_stated_in_cells_take_a_step_of_the_reference_wind():
    slow, fast = (
        tiny(clock={}, wind={"kind": "steady", "speed": speed}).forcing().wind_of(0) for speed in (2.0, 8.0)
    )
    assert slow.step_seconds == fast.step_seconds
    assert slow.polls == fast.polls


def test_frames_and_measures_speak_of_years_where_there_is_a_clock():
    dataset = barchan.simulate(tiny(clock={"step_seconds": 86400.0}))
    np.testing.assert_allclose(dataset["time"], dataset["step"] * 86400.0)
    assert dataset["time"].attrs["units"] == "s"
    assert "time" not in barchan.simulate(tiny()).coords


def test_a_year_has_365_and_a_quarter_days():
    assert spoken(YEAR) == "1 years"
    assert spoken(YEAR / 365.25) == "1 days"


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"wind": METRES}, r"wind\.unit: is m/s, which needs a clock"),
        (
            {"clock": {"reference_speed": 3.0}},
            r"clock\.reference_speed: is 3 m/s, which moves no sand; allowed",
        ),
        ({"clock": {}, "model": {"name": "werner", "p_s": 0.0}}, "clock: is given, but p_s 0 keeps"),
        (
            {"clock": {}, "model": {"name": "nield_baas", "steps_per_year": 5}},
            r"model\.steps_per_year: is 5, but a calendar year has \d+ steps of .* by the clock; leave one",
        ),
        (
            {"clock": {"step_seconds": 4e7}, "model": {"name": "nield_baas"}},
            r"model\.name: a step lasts 1\.27 years by the clock, and plants grow once a year",
        ),
    ],
)
def test_a_clock_that_does_not_fit_is_refused(data, said):
    with pytest.raises(ScenarioError, match=said):
        validate({"barchan": 5, **data})


def test_a_clock_that_agrees_with_the_steps_of_a_year_is_accepted():
    clock = {"step_seconds": YEAR / 80}
    scenario = validate({"barchan": 5, "clock": clock, "model": {"name": "nield_baas", "steps_per_year": 80}})
    assert scenario.step_seconds == YEAR / 80


def test_a_higher_threshold_makes_the_same_wind_weaker():
    speeds = np.array([9.0])
    assert Clock(threshold=8.0).strength(speeds, 1.0) < Clock(threshold=6.0).strength(speeds, 1.0)
