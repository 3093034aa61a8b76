"""Plants over which grains fly: the wind among them, the sand they catch, painting, checkpoints, pictures."""

import numpy as np
import pytest

import barchan
from barchan.analysis.fields import field_of
from barchan.bed import Bed
from barchan.entry import simulate
from barchan.errors import ScenarioError
from barchan.figures.layers import layers_of
from barchan.grains.canopy import TALLEST, Canopy
from barchan.grains.pool import free_slots, grains_in
from barchan.kernels.grains import wind as grain_wind
from barchan.kernels.grains.flight import BLOCK
from barchan.models import model
from barchan.simulation import PlantStroke, SetParameter, Simulation
from barchan.studio.colours import colours
from barchan.studio.worker.brushes import brushes
from barchan.wind.segment import Segment
from tests.grains.keys import nested
from tests.kernels.called import from_python

GRASS = {"west": 0.25, "east": 0.75, "height": 0.05}
PLANTED = {"canopy": {"stands": [GRASS]}}
SMALL = {
    "barchan": 5,
    "lattice": {"rows": 16, "columns": 64, "cell_size": 0.01, "slab_height": 0.15e-3},
    "sand": {"kind": "flat", "mean": 40},
    "model": {"name": "wang_hu", "iterations_per_step": 20, "canopy": {"stands": [GRASS]}},
    "run": {"steps": 20, "seed": 3},
}
LATTICE = barchan.load(SMALL).lattice
WESTERLY = Segment(0, 1, 0, LATTICE.cells, 270.0)


def blowing(flight, bed, x, height):
    """Wind speeds as the kernels find them at a place (cells) and heights (m) over the bed."""
    ground = flight.ground_of(bed, 270.0)
    air = flight.blow(ground, WESTERLY)
    grains = grains_in(*free_slots(len(height)))
    grains.x[:], grains.y[:], grains.z[:] = x, 8.0, height
    cell, (wind, share) = np.zeros(BLOCK, np.int32), np.zeros((2, BLOCK), np.float32)
    from_python(grain_wind.find_wind)(0, len(height), grains, air, ground.arrays, cell, wind, share)
    return wind[: len(height)]


def flat(name="wang_hu", **rules):
    flight = model(name)(model(name).Parameters(**rules), LATTICE)
    bed = Bed(LATTICE, np.zeros(LATTICE.shape), np.zeros(LATTICE.shape, np.int32))
    bed.sand[0, 0] = 1
    flight.initialise(bed, 1)
    return flight, bed


def test_the_wind_over_plants_follows_the_law_of_the_wall_with_their_roughness():
    flight, bed = flat(canopy={"stands": [GRASS]})
    height = np.array([0.001, 0.03, 0.039, 0.042, 0.06, 0.1, 0.3, 1.0, 3.0])
    friction = flight.parameters.friction_velocity(10.0)
    above = np.maximum(height - 2 / 3 * 0.05, 1e-9)
    expected = friction / 0.4 * np.maximum(np.log(above / (0.123 * 0.05)), 0.0)
    np.testing.assert_allclose(blowing(flight, bed, 32.0, height), expected, rtol=0.01, atol=0.02)
    assert (blowing(flight, bed, 32.0, height)[:3] == 0).all()


def test_where_no_plants_stand_the_wind_is_the_same_to_the_bit():
    height = np.geomspace(1e-5, 2.0, 50)
    for rules in ({}, {"stability": -0.5}):
        bare, planted = (blowing(*flat(**rules, **more), 5.0, height) for more in ({}, PLANTED))
        np.testing.assert_array_equal(bare, planted)


@pytest.mark.parametrize("near_bed", ["log", "threshold", "slowed"])
@pytest.mark.parametrize("width", [None, 0.03])
@pytest.mark.parametrize("tall", [0.002, 0.05, 1.0])
def test_plants_take_the_same_from_every_wind_near_the_bed_but_never_more_than_there_is(
    near_bed, width, tall
):
    rules = nested(feedback__near_bed=near_bed, feedback__length=width, wind_speed=14.0)
    flight, bed = flat("ripples", canopy={"stands": [{**GRASS, "height": tall}]}, **rules)
    flight.feedback.stress[...] = 0.05
    height = np.geomspace(1e-4, 3.0, 40)
    friction = flight.parameters.friction_velocity(14.0)
    found = blowing(flight, bed, 32.0, height + 2 / 3 * tall)
    bare = blowing(flight, bed, 5.0, height)
    taken = friction / 0.4 * np.log(0.123 * tall / flight.parameters.roughness_length)
    np.testing.assert_allclose(found, np.maximum(bare - taken, 0.0), rtol=1e-3, atol=0.15)
    assert (found >= 0).all()


def test_low_plants_leave_the_roughness_and_displacement_of_the_field():
    height = np.geomspace(1e-3, 2.0, 50)
    rules = {"roughness": 0.01, "displacement": 0.04}
    bare, low = (blowing(*flat(**rules, **more), 32.0, height) for more in ({}, PLANTED))
    np.testing.assert_array_equal(bare, low)


def test_the_shelter_of_crests_is_lifted_too():
    flight, bed = flat(canopy={"stands": [GRASS]}, shelter={"angle": 15.0})
    bed.sand[:, 20] = 400
    ground = flight.ground_of(bed, 270.0)
    ground.raise_shelter()
    bare = flat(shelter={"angle": 15.0})[0].ground_of(bed, 270.0)
    bare.raise_shelter()
    lift = 2 / 3 * 0.05
    rise = (ground.arrays.base - bare.arrays.base).reshape(LATTICE.shape)
    assert rise[8, 32] == pytest.approx(lift)
    assert rise[8, 5] == 0
    assert rise[8, 15] == pytest.approx(lift / 2)


def test_at_open_edges_plants_stand_up_to_the_edge():
    for boundary, share in (("open", 1.0), ("periodic", 0.5)):
        lattice = barchan.load(SMALL, lattice__boundary_x=boundary).lattice
        flight = model("wang_hu")(
            model("wang_hu").Parameters(canopy={"stands": [{**GRASS, "east": 1.0}]}), lattice
        )
        bed = Bed(lattice, np.zeros(lattice.shape), np.ones(lattice.shape, np.int32))
        flight.initialise(bed, 1)
        rise = flight.ground_of(bed, 270.0).arrays.canopy.displacement_height.reshape(lattice.shape)
        assert rise[8, -1] == pytest.approx(share * 2 / 3 * 0.05)


@pytest.mark.extended
def test_a_stand_catches_sand():
    rules = {
        "name": "ripples",
        "iterations_per_step": 50,
        "wind_speed": 14.0,
        "feedback": {"momentum_weight": 0.02},
    }
    simulation = Simulation(barchan.load({**SMALL, "model": {**rules, "canopy": {"stands": [GRASS]}}}))
    simulation.advance(60)
    grown = simulation.bed.sand.mean(axis=0) - 40
    assert grown[16:32].mean() > 3
    assert grown[[*range(10), *range(54, 64)]].mean() < -1
    assert simulation.bed.units + simulation.ledger.airborne == 16 * 64 * 40


@pytest.mark.extended
def test_a_resumed_run_keeps_its_plants_and_its_bits():
    simulation = Simulation(barchan.load(SMALL, model__displacement=0.001))
    simulation.advance(5)
    simulation.apply(PlantStroke(x=0.1, y=0.08, radius=0.05, field="plant_height", amount=0.03))
    simulation.advance(5)
    again = Simulation.from_state(simulation.state())
    for one in (simulation, again):
        one.advance(5)
    for name in ("sand", "plant_height"):
        np.testing.assert_array_equal(again.bed.arrays[name], simulation.bed.arrays[name])
    np.testing.assert_array_equal(again.model.pool.motion, simulation.model.pool.motion)


@pytest.mark.extended
def test_a_brush_plants_no_lower_than_none_and_no_higher_than_the_tallest_may_be():
    simulation = Simulation(barchan.load(SMALL, model__canopy__stands=[{"height": 0.0}]))
    (brush,) = (one for one in brushes(simulation) if one["title"] == "plant_height")
    assert (brush["unit"], brush["most"]) == ("m", 1.0)
    for amount, found in ((0.7, 0.7), (0.7, 1.0), (-3.0, 0.0)):
        stroke = PlantStroke(x=0.105, y=0.085, radius=0.05, field="plant_height", amount=amount)
        simulation.apply(stroke)
        assert simulation.bed.arrays["plant_height"][8, 10] == pytest.approx(found)
    simulation.advance(1)
    tall = Simulation(barchan.load(SMALL, model__canopy__stands=[{"height": 3.0}]))
    assert tall.model.paintable() == {"plant_height": (0.0, 3.0)}


def test_without_plants_there_is_no_field_and_nothing_to_paint_or_draw():
    scenario = barchan.load(SMALL, model__canopy__stands=[])
    simulation = Simulation(scenario)
    assert "plant_height" not in simulation.bed.arrays
    assert simulation.model.paintable() == {}
    assert "plants" not in simulation.model.facts()
    assert layers_of(scenario) == ()
    assert simulation.model.ground_of(simulation.bed, 270.0).arrays.canopy is None


@pytest.mark.extended
def test_frames_carry_plants_and_pictures_show_them():
    scenario = barchan.load(SMALL, run__steps=2)
    frame = simulate(scenario).isel(step=-1)
    assert frame["plant_height"].values[8, 32] == 0.05
    (layer,) = layers_of(scenario)
    assert layer.colours in colours()
    shown = field_of(frame, scenario, layer.field).values
    assert (shown[8, 5], shown[8, 32]) == (0.0, 1.0)


def test_facts_mention_plants():
    facts = Simulation(barchan.load(SMALL)).model.facts()
    assert facts["plants"] == (
        "on 50% of the field, up to 0.05 m high, with a roughness of 0.00615 m and a displacement of 0.0333 m"
    )


def test_later_stands_replace_earlier_ones():
    stands = [GRASS, {"west": 0.4, "east": 0.5, "height": 0.0}]
    bed = Simulation(barchan.load(SMALL, model__canopy__stands=stands)).bed
    assert bed.arrays["plant_height"][0, [5, 20, 28, 40]].tolist() == [0.0, 0.05, 0.0, 0.05]


def test_shares_of_the_height_may_change_during_a_run():
    simulation = Simulation(barchan.load(SMALL))
    ground = [simulation.model.ground_of(simulation.bed, 270.0).arrays.canopy.displacement_height.max()]
    simulation.apply(SetParameter(key="model.canopy.displacement", value=0.5))
    ground.append(simulation.model.ground_of(simulation.bed, 270.0).arrays.canopy.displacement_height.max())
    np.testing.assert_allclose(ground, [0.05 * 2 / 3, 0.025], rtol=1e-6)


def test_no_plants_reach_the_height_at_which_winds_are_stated():
    most = {
        name: next(part.le for part in Canopy.model_fields[name].metadata if hasattr(part, "le"))
        for name in ("roughness", "displacement")
    }
    assert TALLEST * sum(most.values()) < 10.0


@pytest.mark.parametrize(
    ("stand", "said"),
    [
        ({"height": -0.1}, "model.canopy.stands[0].height"),
        ({"height": 5.1}, "≤ 5"),
        ({"height": float("nan")}, "model.canopy.stands[0].height"),
        ({}, "model.canopy.stands[0].height"),
        ({"height": 0.1, "west": 0.5, "east": 0.5}, "a stand must have an area"),
        ({"hight": 0.1}, "height"),
    ],
)
def test_what_is_wrong_with_a_stand_is_named(stand, said):
    with pytest.raises(ScenarioError) as caught:
        barchan.load(SMALL, model__canopy__stands=[stand])
    assert said in str(caught.value)
