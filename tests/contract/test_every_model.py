"""The contract of all models; a new model is tested as soon as it is there."""

import json

import numpy as np
import pytest

from barchan.bed import Bed
from barchan.fields import count_names
from barchan.models import models
from barchan.parameters import declarations
from barchan.scenario import Scenario, validate
from barchan.simulation import Simulation, Stroke

SMALL = {"rows": 17, "columns": 23}
EVERY_MODEL = pytest.mark.parametrize("name", list(models()))


def scenario(name, **changes):
    data = {
        "barchan": 5,
        "lattice": SMALL,
        "sand": {"kind": "dropped", "mean": 4.0},
        "model": {"name": name},
        "run": {"steps": 12, "seed": 5, "save_every": 4},
    }
    for key, value in changes.items():
        data[key] = {**data.get(key, {}), **value}
    return validate(data)


BOUNDARIES = pytest.mark.parametrize("boundary", ["periodic", "open"])
WINDS = pytest.mark.parametrize("direction", [270.0, 0.0, 33.0])
FLAT, BUMP = {"kind": "flat"}, {"kind": "bump", "height": 3.0, "radius": 6.0}


def grounds_and_winds(*oblique):
    """Grounds under winds along the axes; oblique ones over the flat only, as each ground has its kernels."""
    return pytest.mark.parametrize(
        ("ground", "direction"),
        [
            pytest.param(
                ground, wind, marks=[pytest.mark.extended] if ground is BUMP and wind in oblique else []
            )
            for ground in (FLAT, BUMP)
            for wind in (270.0, 0.0, 33.0)
        ],
    )


GROUNDS_AND_WINDS = grounds_and_winds(33.0)


@EVERY_MODEL
def test_a_model_counts_its_work_and_says_in_what(name):
    simulation = Simulation(scenario(name))
    assert simulation.model.work_unit.endswith("s")
    assert simulation.advance(4).polls > 0


@EVERY_MODEL
@BOUNDARIES
@GROUNDS_AND_WINDS
def test_sand_is_conserved_exactly_and_no_stack_is_negative(name, boundary, direction, ground):
    simulation = Simulation(
        scenario(
            name,
            lattice={**SMALL, "boundary_x": boundary, "boundary_y": boundary},
            wind={"direction": direction},
            ground=ground,
        )
    )
    before = simulation.bed.units
    rock = simulation.bed.ground.copy()
    for _ in range(3):
        simulation.advance(4)
        ledger = simulation.ledger
        assert simulation.bed.units + ledger.airborne == before + ledger.entered - ledger.left
        assert simulation.bed.stack.min() >= 0
    np.testing.assert_array_equal(simulation.bed.ground, rock)
    if boundary == "periodic":
        assert simulation.ledger.left == 0


@EVERY_MODEL
@WINDS
def test_no_slope_exceeds_the_limit_that_the_model_states(name, direction):
    simulation = Simulation(scenario(name, wind={"direction": direction}))
    limits = list(simulation.model.slope_limits().values())
    if not limits:
        pytest.skip("the model states none")
    face, *corner = np.max(limits, axis=0)
    for _ in range(4):
        simulation.advance(3)
        sand = simulation.bed.stack
        for shift in ((0, 1), (1, 0)):
            assert np.abs(sand - np.roll(sand, shift, (0, 1))).max() <= face
        for shift in ((1, 1), (1, -1)):
            assert not corner or np.abs(sand - np.roll(sand, shift, (0, 1))).max() <= corner[0]


@EVERY_MODEL
def test_same_seed_same_bits_and_another_seed_others(name):
    first, again = Simulation(scenario(name)), Simulation(scenario(name))
    other = Simulation(scenario(name, run={"seed": 6}))
    for simulation in (first, again, other):
        simulation.advance(10)
    np.testing.assert_array_equal(first.bed.stack, again.bed.stack)
    assert (first.bed.stack != other.bed.stack).any()


@EVERY_MODEL
def test_bits_do_not_depend_on_how_a_run_is_cut_into_calls(name):
    whole, pieces = Simulation(scenario(name)), Simulation(scenario(name))
    whole.advance(12)
    for steps in (1, 5, 2, 4):
        pieces.advance(steps)
    np.testing.assert_array_equal(whole.bed.stack, pieces.bed.stack)
    assert whole.tally == pieces.tally


@EVERY_MODEL
def test_a_resumed_run_equals_an_uninterrupted_one(name):
    whole, begun = Simulation(scenario(name)), Simulation(scenario(name))
    stroke = Stroke(x=10.0, y=8.0, radius=4.0, amount=12)
    whole.advance(5)
    whole.apply(stroke)
    whole.advance(7)
    begun.advance(5)
    begun.apply(stroke)
    resumed = Simulation.from_state(begun.state())
    resumed.advance(7)
    assert set(whole.bed.arrays) == set(resumed.bed.arrays)
    for field, values in whole.bed.arrays.items():
        np.testing.assert_array_equal(values, resumed.bed.arrays[field])
    assert (whole.ledger, whole.tally) == (resumed.ledger, resumed.tally)


@EVERY_MODEL
def test_a_scenario_survives_its_file(name):
    made = scenario(name)
    assert validate(json.loads(made.text())) == made
    default = Scenario(model=models()[name].Parameters())
    assert validate(json.loads(default.text())) == default


@EVERY_MODEL
def test_every_parameter_has_unit_bounds_meaning_and_source(name):
    for declaration in declarations(models()[name].Parameters):
        assert declaration.unit, declaration.key
        assert declaration.meaning.endswith("."), declaration.key
        assert declaration.bounds, declaration.key
        if "number" in declaration.type:
            assert any(sign in declaration.bounds for sign in "<>≤≥"), declaration.key


@EVERY_MODEL
def test_a_model_says_what_it_is(name):
    model = models()[name]
    assert model.title
    assert model.citation
    assert len(model.__doc__ or "") > 200
    assert model.Parameters.model_fields["name"].default == name


@EVERY_MODEL
def test_a_model_declares_its_fields_on_the_bed(name):
    simulation = Simulation(scenario(name))
    model = simulation.model
    declared = {"ground", *count_names(model.layers)} | {field.name for field in model.fields}
    assert set(simulation.bed.arrays) == declared
    assert isinstance(simulation.bed, Bed)
    for field in simulation.bed.declared.values():
        assert field.unit
        assert field.meaning
