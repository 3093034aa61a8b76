"""Ground far above sea, with thin slabs, gives the bits of the same ground at sea level, or is refused."""

import numpy as np
import pytest

from barchan import Simulation
from barchan.bed import Bed
from barchan.errors import ScenarioError
from barchan.heights import check_heights
from tests.tiny import tiny


@pytest.mark.parametrize("model", ["werner", "momiji", "bishop"])
def test_a_bed_lifted_by_a_hundred_kilometres_moves_like_one_at_sea_level(model):
    """Slabs of 1/1024 m, so that the lift is a whole number of them."""
    scenario = tiny(model={"name": model}, lattice__cell_size=0.01, lattice__slab_height=2.0**-10)
    rocks = 0.1 * (np.random.default_rng(5).random(scenario.lattice.shape) < 0.1)
    beds = []
    for lift in (0.0, 99_999.0):
        simulation = Simulation(scenario)
        ground = np.round(rocks * 1024) / 1024 + lift
        simulation.bed = Bed(scenario.lattice, ground, simulation.bed.sand)
        simulation.advance(5)
        beds.append(simulation.bed.sand)
    np.testing.assert_array_equal(*beds)


def test_ground_of_too_many_slabs_is_refused_with_what_is_allowed():
    thin = {"lattice__cell_size": 0.001, "lattice__slab_height": 1e-6}
    with pytest.raises(ScenarioError) as caught:
        Simulation(tiny(ground={"kind": "bump", "height": 1e4, "radius": 0.005}, **thin))
    assert "ground: rises " in str(caught.value)
    assert "allowed: up to 5.37e+08 slabs" in str(caught.value)


def test_too_much_sand_for_a_sum_of_64_bits_is_refused_only_where_a_mean_is_kept():
    lattice = tiny(lattice__rows=2048, lattice__columns=4096).lattice
    bed = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, 1_000_000, np.int32))
    check_heights(bed, mean_kept=False)
    with pytest.raises(ScenarioError, match="keeps a mean height"):
        check_heights(bed, mean_kept=True)
