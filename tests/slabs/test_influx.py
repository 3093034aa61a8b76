"""Slabs that enter across open edges: how many, where, and that all are booked."""

import numpy as np
import pytest

from barchan.simulation import Simulation
from barchan.streams import Stream
from barchan.wind import Segment
from barchan.wind.influx import CountedInflux
from tests.tiny import tiny

OPEN = {
    "lattice__rows": 32,
    "lattice__columns": 48,
    "lattice__boundary_x": "open",
    "sand": {"kind": "flat", "mean": 0},
}


def run(steps=1, **changes):
    simulation = Simulation(tiny(run__steps=10**6, **{**OPEN, **changes}))
    simulation.advance(steps)
    return simulation


def test_a_saturated_influx_is_the_flux_of_a_flat_bed():
    """1 slab a poll, hops of 5 cells, settling with a chance of 0.6: 5 / 0.6 slabs a step and row."""
    simulation = run(60, influx={"kind": "saturation"}, sand={"kind": "flat", "mean": 20})
    expected = 5 / 0.6 * 32 * 60
    spread = 0.5 * np.sqrt(32 * 60)  # each number is rounded at random
    assert abs(simulation.ledger.entered - expected) < 4 * spread


def test_a_stated_number_of_slabs_enters_in_each_step():
    simulation = run(200, influx={"kind": "slabs", "slabs_per_step": 0.3})
    expected = 0.3 * 32 * 200
    assert abs(simulation.ledger.entered - expected) < 4 * np.sqrt(0.3 * 0.7 * 32 * 200)
    assert simulation.ledger.entered == simulation.ledger.left + simulation.bed.units


@pytest.mark.parametrize(
    ("direction", "edge"),
    [(270.0, (slice(None), slice(5))), (90.0, (slice(None), slice(-5, None)))],
    ids=["from the west", "from the east"],
)
def test_slabs_land_first_within_a_hop_of_the_edge_that_they_enter_across(direction, edge):
    scenario = tiny(**OPEN, model__p_s=1.0, model__p_ns=1.0, run__seed=1)
    model, bed = scenario.new_model(), scenario.first_bed()
    wind = Segment(0, 1, 0, 1, direction, influx=CountedInflux(slabs_per_step=3.0))
    tally = model.advance(bed, wind, Stream(1, "transport"))
    landed = bed.sand[edge]
    assert landed.sum() >= bed.units - 1 == tally.entered - 1 == 32 * 3 - 1
    columns = landed.sum(axis=0)
    assert abs(columns - 32 * 3 / 5).max() < 5 * np.sqrt(32 * 3 * 0.2 * 0.8)


def test_an_oblique_wind_brings_slabs_across_both_edges_in_proportion_to_the_cosine():
    oblique = {"wind__direction": 240.0, "lattice__boundary_y": "open"}
    simulation = run(1, influx={"kind": "slabs", "slabs_per_step": 1000.0}, **oblique)
    expected = 1000.0 * (32 * np.cos(np.radians(30)) + 48 * np.sin(np.radians(30)))
    assert simulation.ledger.entered == pytest.approx(expected, abs=80)


def test_hops_that_are_ended_carry_no_farther_than_they_come():
    """Ten hops at most, each the last with a chance of 0.001: 1 + 0.999 + ... + 0.999⁹ hops of 5 cells."""
    model = Simulation(tiny(model__p_s=0.001, model__max_hops=10, model__hop_length=5.0)).model
    hops = sum(0.999**k for k in range(10))
    assert model.step_volume() == pytest.approx(
        5.0 * hops * model.lattice.cell_size * model.lattice.thickness
    )


def test_a_profile_brings_sand_where_it_says():
    stay = {"model__p_s": 1.0, "model__p_ns": 1.0}
    influx = {"kind": "slabs", "slabs_per_step": 4.0, "profile": [1.0, 0.0]}
    simulation = run(20, influx=influx, **stay)
    by_row = simulation.bed.sand.sum(axis=1)
    assert by_row[:8].sum() > 4 * by_row[-8:].sum()


def test_the_bits_do_not_depend_on_how_a_run_is_cut():
    influx = {"kind": "saturation", "share": 0.7}
    whole, cut = run(12, influx=influx), run(5, influx=influx)
    cut.advance(7)
    np.testing.assert_array_equal(whole.bed.sand, cut.bed.sand)


@pytest.mark.extended
def test_oblique_slabs_among_obstacles_with_hops_that_grow_are_all_booked():
    simulation = run(
        10,
        influx={"kind": "saturation", "share": 0.5},
        ground={"kind": "bump", "height": 3.0, "radius": 6.0},
        model={"name": "momiji", "path_test": "hard"},
        wind__direction=250.0,
        lattice__boundary_y="open",
    )
    ledger = simulation.ledger
    assert ledger.entered > 0
    assert simulation.bed.units == ledger.entered - ledger.left


@pytest.mark.parametrize("direction", [270.0, 225.0])
def test_slabs_whose_first_hop_passes_over_the_whole_field_enter_and_leave(direction):
    far = {"model__hop_length": 5000, "model__p_s": 1.0, "model__p_ns": 1.0}
    influx = {"kind": "slabs", "slabs_per_step": 2.0}
    simulation = run(2, influx=influx, wind__direction=direction, lattice__boundary_y="open", **far)
    assert simulation.ledger.left > 0.9 * simulation.ledger.entered > 0


@pytest.mark.parametrize("model", ["bishop", "momiji"])
def test_slabs_whose_hops_depend_on_height_enter_alike_however_the_run_is_cut(model):
    changes = {**OPEN, "sand": {"kind": "ripples", "mean": 3, "amplitude": 2}, "model": {"name": model}}
    whole = run(9, influx={"kind": "saturation"}, **changes)
    parts = run(2, influx={"kind": "saturation"}, **changes)
    for steps in (1, 1, 5):
        parts.advance(steps)
    np.testing.assert_array_equal(whole.bed.sand, parts.bed.sand)
    assert whole.tally.entered == parts.tally.entered
