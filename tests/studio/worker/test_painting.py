import numpy as np
import pytest

from barchan.simulation import PlantStroke, RockStroke, Simulation, Stroke
from barchan.studio.worker.painting import Painting
from tests.studio.conftest import small


def gesture(painting: Painting, simulation: Simulation, *amounts: int) -> None:
    painting.begin(simulation)
    for number, amount in enumerate(amounts):
        painting.stroke(simulation, Stroke(x=10.0 + number, y=12.0, radius=4.0, amount=amount))
    painting.end(simulation)


def test_stamps_of_a_gesture_name_those_that_they_overlap(scenario):
    simulation, painting = Simulation(scenario), Painting()
    stamps = [
        Stroke(x=4.0, y=12.0, radius=4.0, amount=1),
        Stroke(x=10.0, y=12.0, radius=4.0, amount=1),
        Stroke(x=13.0, y=12.0, radius=4.0, amount=1),
        Stroke(x=13.0, y=12.0, radius=4.0, amount=1, falloff="none"),
    ]
    painting.begin(simulation)
    for stamp in stamps:
        painting.stroke(simulation, stamp)
    trails = [[(stamp.x, stamp.y) for stamp in record.event.trail] for record in simulation.events]
    assert trails == [[], [(4.0, 12.0)], [(10.0, 12.0)], []]


def test_undoing_at_once_puts_back_every_slab_and_the_journal(scenario):
    simulation, painting = Simulation(scenario), Painting()
    simulation.advance(5)
    before = simulation.state()
    gesture(painting, simulation, 5, 5, -3)
    assert len(simulation.events) == 3
    undone = painting.undo(simulation)
    assert np.array_equal(undone.bed.sand, before.arrays["bed/sand"])
    assert undone.events == []
    assert undone.ledger.entered == 0


def test_redoing_gives_the_painted_bed_again(scenario):
    simulation, painting = Simulation(scenario), Painting()
    gesture(painting, simulation, 6)
    painted = simulation.bed.sand.copy()
    again = painting.redo(painting.undo(simulation))
    assert np.array_equal(again.bed.sand, painted)
    assert len(again.events) == 1


def test_undoing_after_steps_is_an_event_and_takes_back_what_was_given(scenario):
    simulation, painting = Simulation(scenario), Painting()
    slabs = simulation.bed.units
    gesture(painting, simulation, 4)
    given = simulation.bed.units - slabs
    simulation.advance(1)
    painting.stepped()
    same = painting.undo(simulation)
    assert same is simulation
    assert len(same.events) == 2
    assert slabs <= same.bed.units < slabs + given
    same.ledger.check(same.bed)


def test_undoing_an_eraser_after_steps_lays_back_about_what_was_there_to_take(scenario):
    simulation, painting = Simulation(scenario), Painting()
    slabs = simulation.bed.units
    gesture(painting, simulation, -50)
    taken = slabs - simulation.bed.units
    assert taken > 0
    simulation.advance(1)
    painting.stepped()
    painting.undo(simulation)
    assert abs(simulation.bed.units - slabs) < taken / 2


def test_a_new_gesture_forgets_what_was_undone(scenario):
    simulation, painting = Simulation(scenario), Painting()
    gesture(painting, simulation, 3)
    simulation = painting.undo(simulation)
    gesture(painting, simulation, 2)
    slabs = simulation.bed.units
    assert painting.redo(simulation).bed.units == slabs


PLACE = {"x": 20.0, "y": 12.0, "radius": 6.0}
OTHERS = {
    "ground": RockStroke(**PLACE, amount=7),
    "grass": PlantStroke(**PLACE, field="grass", amount=0.4),
}


@pytest.mark.parametrize("field", OTHERS)
@pytest.mark.parametrize("later", [False, True])
def test_rock_and_plants_are_undone_and_done_again(field, later):
    simulation, painting = Simulation(small(model={"name": "nield_baas"})), Painting()
    before = simulation.bed.arrays[field].copy()
    painting.begin(simulation)
    painting.stroke(simulation, OTHERS[field])
    painting.end(simulation)
    painted = simulation.bed.arrays[field].copy()
    assert painted.max() > before.max()
    if later:
        simulation.advance(1)
        painting.stepped()
    simulation = painting.undo(simulation)
    assert np.allclose(simulation.bed.arrays[field], before, atol=1e-12)
    assert len(simulation.events) == (2 if later else 0)
    simulation = painting.redo(simulation)
    assert np.allclose(simulation.bed.arrays[field], painted, atol=1e-12)
