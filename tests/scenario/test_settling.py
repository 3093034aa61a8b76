"""Slides before a run, estimated on a coarse copy of the bed: two cells by hand, blocks by sliding them."""

import numpy as np
import pytest

from barchan.scenario import validate
from barchan.scenario.settling import expected_slides, settling_seconds


def test_a_bed_at_rest_slides_nowhere():
    ramp = np.tile(np.arange(40.0), (8, 1))
    assert expected_slides(ramp, ramp, 1.5, (False, False)) == 0.0


def test_a_step_slides_to_the_ramp_that_stands():
    """Two cells, 10 slabs and none, steps of 2 stand: 4 slabs slide by one cell (6 and 4 are left)."""
    step = np.array([[10.0, 0.0]])
    assert expected_slides(step, step, 2.0, (False, False)) == pytest.approx(4.0, rel=0.02)


def test_rock_does_not_slide():
    assert expected_slides(np.array([[10.0, 0.0]]), np.zeros((1, 2)), 2.0, (False, False)) == 0.0


@pytest.mark.parametrize("rows", [64, 150])
def test_the_estimate_for_a_block_is_what_slides(rows):
    lattice = {"rows": rows, "columns": rows}
    scenario = validate(
        {"barchan": 5, "lattice": lattice, "sand": {"kind": "block", "height": 60.0}}
    ).seeded()
    model, bed = scenario.new_model(), scenario.first_bed()
    model.initialise(bed, 1)
    height = bed.stack.astype(float)
    estimate = expected_slides(height, height, 2.0, (True, True))
    assert settling_seconds(model, bed) > 0.0
    assert estimate == pytest.approx(model.relax(bed), rel=0.1)
