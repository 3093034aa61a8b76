"""The coupled-map model: exact sand, hops of the stated length, growth and decay."""

import numpy as np
import pytest

import barchan
from barchan.simulation import Simulation

SMALL = {
    "barchan": 5,
    "lattice": {"rows": 32, "columns": 64, "cell_size": 0.01, "slab_height": 0.0005},
    "sand": {"kind": "dropped", "mean": 300},
    "model": {"name": "nishimori_ouchi"},
    "run": {"steps": 1000, "seed": 2},
}


def test_the_mean_hop_is_the_hop_length():
    simulation = Simulation(barchan.load(SMALL, model__hop_length=4.3, model__hop_growth=0.0))
    tally = simulation.advance(5)
    assert tally.travel_x / tally.moved == pytest.approx(4.3, rel=0.02)
    assert tally.travel_y == 0


def test_crests_across_the_wind_grow_from_noise():
    simulation = Simulation(barchan.load(SMALL))
    simulation.advance(60)
    surface = simulation.elevation
    assert surface.mean(axis=0).std() > 5 * surface.mean(axis=1).std()


def test_creep_alone_levels_the_bed():
    simulation = Simulation(barchan.load(SMALL, model__hop_share=1e-9))
    before = simulation.elevation.std()
    simulation.advance(40)
    assert simulation.elevation.std() < 0.2 * before


@pytest.mark.parametrize("direction", [0.0, 90.0, 180.0])
def test_sand_goes_where_the_wind_blows(direction):
    simulation = Simulation(barchan.load(SMALL, wind__direction=direction))
    tally = simulation.advance(3)
    x, y = -np.sin(np.radians(direction)), -np.cos(np.radians(direction))
    assert tally.travel_x * x + tally.travel_y * y > 0
