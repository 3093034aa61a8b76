"""Flux is the sand that the wind carries through a line across it."""

import math

import pytest

from barchan.directions import downwind
from barchan.measures import flux
from barchan.simulation import Simulation
from tests.tiny import tiny

DEEP = {
    "lattice__rows": 48,
    "lattice__columns": 64,
    "lattice__cell_size": 2.0,
    "sand": {"kind": "flat", "mean": 200},
    "model__shadow_angle": 89.0,
}
"""Sand everywhere and no shadow anywhere: every poll moves a slab, and only chance lets it settle."""

STEPS = 4


def test_flux_is_travel_over_cells_and_steps_times_what_a_slab_is_high_and_a_cell_long():
    assert flux(travel=600.0, cells=100, steps=2, slab_height=0.5, cell_size=4.0) == 6.0


def test_there_is_no_flux_in_no_time():
    assert math.isnan(flux(0.0, 100, 0, 0.5, 4.0))


@pytest.mark.parametrize("direction", [270.0, 0.0, 205.0])
@pytest.mark.parametrize(("hop", "p"), [(5.0, 0.6), (1.0, 0.2), (2.5, 1.0)])
def test_flux_over_deep_sand_is_a_hop_over_the_chance_to_settle(direction, hop, p):
    """A slab hops until it settles: geometric, with mean 1/p and variance (1-p)/p² hops."""
    chances = {"model__hop_length": hop, "model__p_s": p, "model__p_ns": p}
    simulation = Simulation(tiny(wind__direction=direction, **DEEP, **chances))
    tally = simulation.advance(STEPS)
    lattice = simulation.lattice
    assert tally.moved == lattice.cells * STEPS
    x, y = downwind(direction)
    along = tally.travel_x * x + tally.travel_y * y
    measured = flux(along, lattice.cells, STEPS, lattice.thickness, lattice.cell_size)
    unit = hop * lattice.thickness * lattice.cell_size
    error = unit * math.sqrt(1 - p) / p / math.sqrt(tally.moved)
    assert abs(measured - unit / p) <= 4 * error + 1e-4 * unit
