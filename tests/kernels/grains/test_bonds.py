"""What grains take from snow that has bonded in part, against the slow and obvious way."""

import numpy as np
import pytest

import barchan
from barchan.bed import Bed
from barchan.kernels.bed.state import AGES
from barchan.kernels.grains import bonds as grain_bonds
from barchan.kernels.grains import exchange
from barchan.simulation import Simulation
from tests.kernels.called import from_python

restitution_at = from_python(grain_bonds.restitution_at)
lay_down, take_up = from_python(exchange.lay_down), from_python(exchange.take_up)

SCENARIO = {
    "barchan": 5,
    "lattice": {"rows": 8, "columns": 9, "cell_size": 0.005, "slab_height": 0.2e-3 / 16},
    "sand": {"kind": "flat", "mean": 8},
    "model": {"name": "snow_grains"},
    "run": {"steps": 1, "seed": 3},
}

PATCH = {
    (0, 0): 4,
    (0, 1): 2,
    (1, 0): 2,
    (0, -1): 2,
    (-1, 0): 2,
    (1, 1): 1,
    (1, -1): 1,
    (-1, -1): 1,
    (-1, 1): 1,
}
"""Parcels of a grain by step (row, column) from the middle stack: sixteen."""


def scene(seed):
    """A model, a bed whose snow has bonded in part, and the same as lists of ages."""
    simulation = Simulation(barchan.load(SCENARIO))
    bed, random = simulation.bed, np.random.default_rng(seed)
    loose = random.integers(0, 3, (bed.lattice.cells, AGES)).astype(np.int32)
    bonded = random.integers(0, 4, bed.lattice.cells).astype(np.int32)
    for age in range(AGES):
        bed.arrays[f"loose_{age + 1}"].reshape(-1)[...] = loose[:, age]
    bed.arrays["bonded"].reshape(-1)[...] = bonded
    bed.sand.reshape(-1)[...] = loose.sum(axis=1) + bonded
    return simulation.model, bed, loose, bonded


def leave(loose, bonded, cell, parcels):
    for _ in range(parcels):
        age = next((age for age in range(AGES) if loose[cell, age]), None)
        if age is None:
            bonded[cell] -= 1
        else:
            loose[cell, age] -= 1


def taken(bed: Bed, loose, bonded, middle, breaks):
    """Whether a grain's snow was there, and was taken."""
    rows, cols = bed.lattice.shape
    row, col = divmod(middle, cols)
    demands, rest = {}, 16
    for (north, east), share in PATCH.items():
        cell = (row + north) % rows * cols + (col + east) % cols
        if cell != middle:
            free = loose[cell].sum() + (bonded[cell] if breaks else 0)
            demands[cell] = min(share, int(free))
            rest -= demands[cell]
    if loose[middle].sum() + (bonded[middle] if breaks else 0) < rest:
        return False
    for cell, parcels in [*demands.items(), (middle, rest)]:
        leave(loose, bonded, cell, parcels)
    return True


@pytest.mark.extended
@pytest.mark.parametrize("breaks", [True, False])
def test_a_grain_takes_the_youngest_and_bonded_snow_only_where_bonds_break(breaks):
    model, bed, loose, bonded = scene(4)
    ground = model.ground_of(bed, 270.0)
    random, given = np.random.default_rng(8), 0
    for _ in range(80):
        cell = int(random.integers(bed.lattice.cells))
        found = taken(bed, loose, bonded, cell, breaks)
        assert take_up(*divmod(cell, bed.lattice.columns), 0, ground.arrays, breaks) == found
        given += found
        assert np.array_equal(ground.arrays.bonds.loose, loose)
        assert np.array_equal(bed.sand.reshape(-1), loose.sum(axis=1) + bonded)
    assert 3 < given < 80
    lay_down(1, 5, 0, ground.arrays)
    assert ground.arrays.bonds.loose[14, 0] == loose[14, 0] + 4


def test_grains_rebound_faster_where_no_footprint_of_loose_snow_is_left():
    model, bed, _, _ = scene(4)
    bonds = model.ground_of(bed, 270.0).arrays.bonds
    bonds.loose[:2] = [[1, 0, 2, 0], [1, 0, 2, 1]]
    assert restitution_at(bonds, 0, 4, 0.55) == pytest.approx(0.7)
    assert restitution_at(bonds, 1, 4, 0.55) == pytest.approx(0.55)
    assert restitution_at(None, 1, 4, 0.55) == pytest.approx(0.55)
