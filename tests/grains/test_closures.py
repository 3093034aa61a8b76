"""A model of grains is composed of closures: another set of them is another model."""

from typing import Literal

import numpy as np
import pytest

import barchan
from barchan.bed import Bed
from barchan.errors import ScenarioError
from barchan.grains.closure import composed
from barchan.grains.creep import Creep
from barchan.grains.entrainment import Entrainment
from barchan.grains.model import GrainModel
from barchan.grains.parameters import GrainFlight
from barchan.grains.splash import Splash
from barchan.grains.wind_feedback import Feedback
from barchan.lattice import Lattice
from barchan.models import models
from barchan.parameters import declarations, parameter
from barchan.simulation import SetParameter, Simulation
from barchan.streams import Stream
from barchan.wind.segment import Segment


class NoCreepParameters(GrainFlight):
    name: Literal["no_creep"] = parameter("no_creep", unit="-", meaning="Splash without creep.")


class NoCreep(GrainModel):
    """Splash and wind feedback, without creep, shelter, relief flow or sizes."""

    name = "no_creep"
    closures = (Entrainment, Splash, Feedback)
    Parameters = composed(NoCreepParameters, closures)


LATTICE = Lattice(rows=17, columns=23, cell_size=0.005, slab_height=0.15e-3)
RULES = {
    "time_step": 5e-4,
    "iterations_per_step": 20,
    "drag": "reynolds",
    "wind_speed": 12.0,
    "entrainment": {"probability": 0.02},
}


def run(steps, lattice=LATTICE, model=None, **rules):
    """A model after some steps, its bed, and the tally."""
    model = model or NoCreep(NoCreep.Parameters(**{**RULES, **rules}), lattice)
    bed = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, 20))
    model.initialise(bed, 1)
    return model, bed, blow(model, bed, 0, steps)


def blow(model, bed, first, steps):
    return model.advance(bed, Segment(first, steps, 0, model.lattice.cells, 270.0), Stream(3, "transport"))


@pytest.mark.extended
@pytest.mark.parametrize("boundary", ["periodic", "open"])
def test_a_new_set_of_closures_keeps_the_sand(boundary):
    lattice = LATTICE.model_copy(update={"boundary_x": boundary, "boundary_y": boundary})
    model, bed, tally = run(8, lattice)
    assert tally.moved > 0
    assert model.airborne == tally.airborne > 0
    assert bed.units + tally.airborne + tally.left == 20 * lattice.cells
    assert (tally.left > 0) == (boundary == "open")
    assert bed.sand.min() >= 0


@pytest.mark.extended
def test_a_new_set_of_closures_gives_the_same_bits_resumed():
    whole, bed, _ = run(12)
    begun, same, _ = run(5)
    resumed = NoCreep(begun.parameters, LATTICE)
    resumed.restore({name: np.copy(value) for name, value in begun.state().items()})
    blow(resumed, same, 5, 7)
    np.testing.assert_array_equal(bed.sand, same.sand)
    np.testing.assert_array_equal(whole.feedback.stress, resumed.feedback.stress)
    assert whole.feedback.stress.mean() > 0


def test_a_new_set_of_closures_has_their_parameters_and_no_others():
    keys = [one.key for one in declarations(NoCreep.Parameters)]
    assert "splash.restitution" in keys
    assert not any(key.startswith(("creep.", "relief_flow.", "shelter.", "sizes.")) for key in keys)
    for declaration in declarations(NoCreep.Parameters):
        assert declaration.unit
        assert declaration.meaning.endswith(".")
    parameters = NoCreep.Parameters(**RULES)
    assert NoCreep.Parameters.model_validate_json(parameters.model_dump_json()) == parameters
    assert parameters.part(Creep) is None
    assert parameters.part(Entrainment).probability == 0.02


@pytest.mark.parametrize("name", ["wang_hu", "ripples"])
def test_published_models_name_their_closures(name):
    made = models()[name].Parameters()
    assert [type(one) for one in made.closures()] == list(models()[name].closures)


def test_a_parameter_of_a_closure_changes_during_a_run():
    simulation = Simulation(
        barchan.load("ripples", lattice__rows=8, lattice__columns=16, run__steps=2, run__seed=1)
    )
    simulation.apply(SetParameter(key="model.splash.restitution", value=0.4))
    assert simulation.model.parameters.part(Splash).restitution == 0.4
    assert Simulation.from_state(simulation.state()).model.parameters.part(Splash).restitution == 0.4
    with pytest.raises(ScenarioError, match="cannot change during a run"):
        simulation.apply(SetParameter(key="model.feedback.length", value=0.1))
