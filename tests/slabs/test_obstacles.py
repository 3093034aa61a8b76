"""Distances kept for one ground never outlive that ground, its limits or the wind."""

import numpy as np
import pytest

from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.models.momiji import Momiji
from barchan.streams import Stream
from barchan.wind.segment import Segment

LATTICE = Lattice(rows=24, columns=40)


def rocks(seed):
    random = np.random.default_rng(seed)
    ground = 3.0 * (random.random(LATTICE.shape) < 0.05)
    return ground, random.integers(0, 9, LATTICE.shape).astype(np.int32)


def moved(model, ground, sand, direction):
    bed = Bed(LATTICE, ground, sand)
    model.advance(bed, Segment(0, 3, 0, LATTICE.cells, direction), Stream(1, "transport"))
    return bed.sand


@pytest.mark.extended
def test_a_model_that_has_seen_other_grounds_and_winds_moves_sand_like_a_new_one():
    parameters = Momiji.Parameters(path_test="hard")
    model = Momiji(parameters, LATTICE)
    for ground, sand in (rocks(1), rocks(2), rocks(1)):
        for direction in (270.0, 250.0, 290.0, 180.0, 20.0, 270.0):
            for steep in (30.0, 60.0):
                model.change(parameters.model_copy(update={"repose_angle": steep}))
                fresh = Momiji(model.parameters, LATTICE)
                once = moved(fresh, ground, sand, direction)
                np.testing.assert_array_equal(moved(model, ground, sand, direction), once)
