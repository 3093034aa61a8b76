"""The ripple model: splash, the balance of grains in the air, and a wind that they slow."""

import numpy as np
import pytest

import barchan
from barchan.directions import downwind
from barchan.grains.wind_feedback import Feedback, WindFeedback
from barchan.models import model
from barchan.simulation import Simulation
from barchan.streams import Stream
from barchan.wind.segment import Segment

SMALL = {
    "barchan": 5,
    "lattice": {"rows": 16, "columns": 64, "cell_size": 0.005, "slab_height": 0.15e-3},
    "sand": {"kind": "flat", "mean": 50},
    "model": {"name": "ripples", "iterations_per_step": 20},
    "run": {"steps": 1000, "seed": 3},
}


def run(steps, **changes):
    simulation = Simulation(barchan.load(SMALL, **changes))
    simulation.advance(steps)
    return simulation


def test_grains_in_the_air_balance_what_they_take_from_the_wind():
    simulation = run(250, model__wind_speed=12.0, model__feedback__momentum_weight=5e-3)
    early = simulation.ledger.airborne
    simulation.advance(100)
    assert simulation.ledger.airborne == pytest.approx(early, rel=0.35)
    assert simulation.model.pool.flying < 3.9 * simulation.lattice.cells
    near = simulation.model.feedback.near_bed_ustar(
        simulation.model.parameters.friction_velocity(12.0)
    ).mean()
    assert near < 0.8 * simulation.model.parameters.friction_velocity(12.0)


def test_lighter_parcels_put_more_sand_into_the_air():
    heavy, light = (
        run(250, model__feedback__momentum_weight=0.02),
        run(250, model__feedback__momentum_weight=0.005),
    )
    assert light.ledger.airborne > 1.5 * heavy.ledger.airborne


def test_the_wind_does_not_depend_on_how_steps_are_cut():
    short, long = (
        run(
            2000 // iterations,
            model__iterations_per_step=iterations,
            model__feedback__momentum_weight=5e-3,
            model__wind_speed=14.0,
        )
        for iterations in (20, 1000)
    )
    assert short.model.pool.flying > 200
    assert long.model.feedback.stress.mean() == pytest.approx(short.model.feedback.stress.mean(), rel=0.2)
    assert long.model.pool.flying == pytest.approx(short.model.pool.flying, rel=0.2)


def test_a_step_counts_for_as_much_wind_as_the_bed_sees():
    assert run(1, model__feedback__momentum_weight=0.1).model.step_seconds == pytest.approx(20 * 5e-4 / 0.1)


def test_a_patch_leaves_a_smoother_bed_than_single_stacks():
    changes = {"model__feedback__momentum_weight": 0.02, "sand__mean": 400}
    whole = run(150, model__footprint="stack", **changes)
    patch = run(
        150, lattice__slab_height=0.15e-3 / 16, sand__mean=6400, model__feedback__momentum_weight=0.02
    )
    steps = [np.diff(one.bed.sand * one.lattice.thickness, axis=1).std() for one in (whole, patch)]
    assert steps[1] < 0.6 * steps[0]


def test_grains_slow_the_wind_where_they_land():
    ripples = model("ripples")
    lattice = barchan.load(SMALL).lattice
    wind = WindFeedback(Feedback(length=0.02), ripples.Parameters(), lattice)
    lost = np.zeros(lattice.shape)
    lost[8, 32] = 1e4
    wind.update(lost, 0.025, 270.0)
    near = wind.near_bed_ustar(0.4)
    assert near[8, 32] == near.min() < 0.399
    assert near[8, 0] == pytest.approx(0.4)
    uniform = WindFeedback(Feedback(length=None), ripples.Parameters(), lattice)
    uniform.update(lost, 0.025, 270.0)
    assert float(uniform.stress) == pytest.approx(wind.stress.mean())


@pytest.mark.parametrize("direction", [270.0, 0.0, 225.0])
def test_what_is_slowed_stays_near_the_way_of_the_wind(direction):
    ripples = model("ripples")
    lattice = barchan.load(SMALL, lattice__rows=64, lattice__columns=64).lattice
    wind = WindFeedback(Feedback(length=0.04, width=0.01), ripples.Parameters(), lattice)
    lost = np.zeros(lattice.shape)
    lost[32, 32] = 1.0
    wind.update(lost, 0.025, direction)
    y, x = (np.indices(lattice.shape) - 32) * lattice.cell_size
    east, north = downwind(direction)
    along, across = east * x + north * y, east * y - north * x
    share = wind.stress / wind.stress.sum()
    widths = [float(np.sqrt((share * way**2).sum())) for way in (along, across)]
    assert widths == pytest.approx([0.04, 0.01], rel=0.05)


@pytest.mark.extended
def test_wind_by_place_is_the_same_wind_where_it_has_none():
    ripples = model("ripples")
    bed = Simulation(barchan.load(SMALL)).bed
    wind = Segment(0, 1, 0, bed.lattice.cells, 270.0)
    paths = []
    for width in (None, 0.02):
        flight = ripples(ripples.Parameters(feedback={"length": width}, wind_speed=14.0), bed.lattice)
        flight.feedback.stress[...] = 0.05
        paths.append(flight.paths(bed, wind, Stream(1, "paths"), 3))
    for one, other in zip(*paths, strict=True):
        np.testing.assert_allclose(one[:20, :6], other[:20, :6], rtol=2e-3, atol=1e-5)


def test_wind_by_place_survives_a_checkpoint():
    simulation = run(40, model__feedback__length=0.02)
    again = Simulation.from_state(simulation.state())
    np.testing.assert_array_equal(again.model.feedback.stress, simulation.model.feedback.stress)
    for one in (simulation, again):
        one.advance(20)
    np.testing.assert_array_equal(again.bed.sand, simulation.bed.sand)
    assert np.ptp(simulation.model.feedback.stress) > 0


def test_nothing_moves_below_the_threshold_and_a_remark_says_so():
    simulation = run(5, model__wind_speed=8.0)
    assert simulation.tally.moved == 0
    assert any("nothing moves" in remark for remark in simulation.scenario.remarks())


def test_impacts_lift_most_of_the_sand():
    still = {"model__creep__momentum": 0.0}
    splashed, alone = run(100, **still), run(100, model__splash__ejecta_per_speed=0.0, **still)
    assert splashed.tally.moved > 2 * alone.tally.moved


@pytest.mark.extended
@pytest.mark.parametrize("near_bed", ["threshold", "log"])
def test_other_winds_near_the_bed_run_too(near_bed):
    simulation = run(5, model__feedback__near_bed=near_bed)
    assert np.isfinite(simulation.model.pool.motion).all()


def test_all_winds_are_uniform_near_the_bed_at_the_impact_threshold():
    ripples = model("ripples")
    flight = ripples(ripples.Parameters(feedback={"near_bed": "threshold"}), barchan.load(SMALL).lattice)
    height = np.array([1e-4, 1e-3, 9e-3])
    np.testing.assert_allclose(flight.wind_profile(height, 0.3), flight.wind_profile(height, 0.5))
    assert (flight.wind_profile(height + 0.02, 0.3) < flight.wind_profile(height + 0.02, 0.5)).all()


def test_the_stress_that_grains_take_survives_a_checkpoint():
    simulation = run(20)
    again = Simulation.from_state(simulation.state())
    np.testing.assert_array_equal(again.model.feedback.stress, simulation.model.feedback.stress)
    assert simulation.model.feedback.stress.mean() > 0
    for one in (simulation, again):
        one.advance(20)
    np.testing.assert_array_equal(simulation.bed.sand, again.bed.sand)
