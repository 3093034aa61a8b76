"""Grains on fields of a few rows: a time step may carry them round the field more than once."""

import numpy as np
import pytest

from barchan.grains.pool import free_slots, grains_in
from barchan.kernels.bed.state import Grid
from barchan.kernels.grains import landing
from barchan.kernels.grains.state import FLYING, GONE
from barchan.scenario import validate
from barchan.simulation import Simulation
from tests.kernels.called import from_python

come_in = from_python(landing._come_in)

STEEP = {
    "barchan": 5,
    "lattice": {"rows": 1, "columns": 9, "cell_size": 0.002, "slab_height": 0.00015},
    "ground": {"kind": "cliff"},
    "sand": {"kind": "cone", "mean": 0.0, "gradient_y": 0.15, "radius": 60.0},
    "wind": {"kind": "steady", "direction": 0.0001, "unit": "m/s", "speed": 7.0},
    "model": {
        "name": "wang_hu",
        "wind_speed": 0.0006,
        "grain_diameter": 0.0013,
        "grain_density": 1270.0,
        "air_density": 7.0,
        "gravity": 0.41,
        "drag_coefficient": 4.0,
        "iterations_per_step": 5,
        "entrainment": {"max_lift_speed": 9.0, "min_lift_angle": 12.0, "max_lift_angle": 21.0},
        "bounce": {"normal_damping": 1.0},
    },
    "run": {"steps": 60, "seed": 3},
}
"""A cliff of 40 m on cells of 2 mm: grains that bounce off it fly faster than the field is wide in a step."""


@pytest.mark.parametrize(
    ("size", "place", "inside", "laps"),
    [
        (1, -1.5, 0.5, -2),
        (1, 2.25, 0.25, 2),
        (1, 0.75, 0.75, 0),
        (3, 3.0, 0.0, 1),
        (3, -0.5, 2.5, -1),
        (3, 100.5, 1.5, 33),
    ],
)
def test_a_grain_beyond_a_joined_edge_comes_in_after_whole_laps(size, place, inside, laps):
    """place = inside + laps × size, worked out by hand."""
    grains = grains_in(*free_slots(1))
    grains.status[0], grains.x[0], grains.y[0] = FLYING, 1.0, place
    come_in(0, grains, Grid(size, 8, True, True))
    assert (grains.y[0], grains.wraps_y[0], grains.status[0]) == (inside, laps, FLYING)


@pytest.mark.parametrize("place", [-0.25, 1.0, np.inf, np.nan])
def test_a_grain_beyond_an_open_edge_or_nowhere_is_gone(place):
    grains = grains_in(*free_slots(1))
    grains.status[0], grains.y[0] = FLYING, place
    come_in(0, grains, Grid(1, 8, True, False))
    assert grains.status[0] == GONE


@pytest.mark.parametrize("boundary", ["periodic", "open"])
@pytest.mark.parametrize("rows", [1, 2, 3])
def test_grains_off_a_cliff_stay_in_a_field_of_a_few_rows_or_leave_it(rows, boundary):
    lattice = {**STEEP["lattice"], "rows": rows, "boundary_y": boundary}
    simulation = Simulation(validate({**STEEP, "lattice": lattice}))
    for _ in range(20):
        tally = simulation.advance(3)
        flying = simulation.model.pool.counters[0] != 0
        x, y = simulation.model.pool.motion[:2, flying]
        assert ((x >= 0) & (x < 9)).all()
        assert ((y >= 0) & (y < rows)).all()
    assert simulation.tally.moved > 0
    assert tally.steps == 3
