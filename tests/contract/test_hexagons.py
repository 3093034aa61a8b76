"""The contract of the models whose rules hold on hexagons, beside that of all models on squares."""

import numpy as np
import pytest

from barchan.errors import ScenarioError
from barchan.models import models
from barchan.simulation import Simulation, Stroke
from tests.contract.test_every_model import BOUNDARIES, grounds_and_winds, scenario

SMALL = {"kind": "hex", "rows": 18, "columns": 23}
RARE = ("nield_baas", "bishop", "snow_werner")
ON_HEXAGONS = pytest.mark.parametrize(
    "name",
    [
        # kernels that take long to compile, for rules that do the same on squares
        pytest.param(name, marks=[pytest.mark.extended] if name in RARE else [])
        for name in models()
        if "hex" in models()[name].lattices
    ],
)
WINDS = pytest.mark.parametrize("direction", [270.0, 0.0, 33.0])
GROUNDS_AND_WINDS = grounds_and_winds(0.0, 33.0)


def steps_to_neighbours(heights):
    """Differences of height to the neighbours east, north-east and north-west of hexagons, edges joined."""
    odd = (np.arange(len(heights)) % 2 == 1)[:, None]
    north = np.roll(heights, -1, 0)
    northeast = np.where(odd, np.roll(north, -1, 1), north)
    northwest = np.where(odd, north, np.roll(north, 1, 1))
    return [other - heights for other in (np.roll(heights, -1, 1), northeast, northwest)]


@ON_HEXAGONS
@BOUNDARIES
@GROUNDS_AND_WINDS
def test_sand_on_hexagons_is_conserved_exactly_and_no_stack_is_negative(name, boundary, direction, ground):
    edges = {"boundary_x": boundary, "boundary_y": boundary}
    simulation = Simulation(
        scenario(name, lattice={**SMALL, **edges}, wind={"direction": direction}, ground=ground)
    )
    before = simulation.bed.units
    for _ in range(3):
        simulation.advance(4)
        ledger = simulation.ledger
        assert simulation.bed.units == before + ledger.entered - ledger.left
        assert simulation.bed.stack.min() >= 0
    if boundary == "periodic":
        assert simulation.ledger.left == 0


@ON_HEXAGONS
@WINDS
def test_no_slope_of_hexagons_exceeds_the_one_limit_that_the_model_states(name, direction):
    simulation = Simulation(scenario(name, lattice=SMALL, wind={"direction": direction}))
    limits = list(simulation.model.slope_limits().values())
    assert {len(limit) for limit in limits} == {1}
    for _ in range(3):
        simulation.advance(4)
        steps = steps_to_neighbours(simulation.bed.stack.astype(np.int64))
        assert max(np.abs(step).max() for step in steps) <= np.max(limits)


@ON_HEXAGONS
def test_a_run_on_hexagons_that_is_cut_and_taken_up_again_has_the_bits_of_one_in_one_go(name):
    wind = {"direction": 33.0}
    whole, begun = (Simulation(scenario(name, lattice=SMALL, wind=wind)) for _ in range(2))
    stroke = Stroke(x=10.0, y=8.0, radius=4.0, amount=12)
    for simulation in (whole, begun):
        simulation.advance(5)
        simulation.apply(stroke)
    whole.advance(7)
    resumed = Simulation.from_state(begun.state())
    resumed.advance(3)
    resumed.advance(4)
    np.testing.assert_array_equal(whole.bed.stack, resumed.bed.stack)


@pytest.mark.parametrize("name", [name for name in models() if "hex" not in models()[name].lattices])
def test_models_that_are_not_made_for_hexagons_say_so(name):
    with pytest.raises(ScenarioError, match=r"lattice\.kind: is hex; allowed with .*: square"):
        scenario(name, lattice=SMALL)


def test_a_lattice_of_hexagons_has_an_even_number_of_rows():
    with pytest.raises(ScenarioError, match="rows 17 is odd; allowed with kind hex: even numbers of rows"):
        scenario("werner", lattice={**SMALL, "rows": 17})


def test_squares_in_a_file_are_refused_on_hexagons():
    with pytest.raises(ScenarioError, match=r"ground\.kind: is file, whose cells are squares"):
        scenario("werner", lattice=SMALL, ground={"kind": "file", "path": "none.npy"})
