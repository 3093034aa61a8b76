"""Painting sand on a bed that the wind works on: exact, clipped, settled, accounted for."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.errors import BarchanError, ScenarioError
from barchan.simulation import PlantStroke, RockStroke, Simulation, Stamp, Stroke
from tests.tiny import tiny

strokes = st.builds(
    Stroke,
    x=st.floats(0, 24),
    y=st.floats(0, 16),
    radius=st.floats(0.5, 12),
    amount=st.integers(-30, 30),
    falloff=st.sampled_from(["none", "linear", "smooth"]),
)


def steepest_step(sand):
    """The largest step between face neighbours of a periodic field."""
    return max(int(np.abs(sand - np.roll(sand, 1, axis)).max()) for axis in (0, 1))


@given(st.lists(strokes, max_size=4), st.integers(0, 3))
def test_the_ledger_stays_closed_to_the_slab(painted, steps):
    simulation = Simulation(tiny())
    for stroke in painted:
        simulation.advance(steps)
        simulation.apply(stroke)
    ledger = simulation.ledger
    assert simulation.bed.units == ledger.initial + ledger.entered - ledger.left
    assert simulation.bed.sand.min() >= 0


@given(strokes)
def test_painted_sand_comes_to_rest_within_the_repose_limit(stroke):
    simulation = Simulation(tiny())
    simulation.apply(stroke)
    assert steepest_step(simulation.bed.sand) <= 2


def test_painting_adds_exactly_the_slabs_of_the_stroke():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 0}))
    simulation.apply(Stroke(x=6.5, y=4.5, radius=1.5, amount=7, falloff="none"))
    assert simulation.ledger.entered == 9 * 7
    assert simulation.bed.units == 9 * 7
    assert simulation.bed.sand.max() < 7


def test_taking_more_than_there_is_takes_what_there_is():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 2}))
    simulation.apply(Stroke(x=6.5, y=4.5, radius=1.5, amount=-100, falloff="none"))
    assert simulation.ledger.left == 9 * 2
    assert simulation.bed.sand[3:6, 5:8].sum() == 0
    assert simulation.bed.units == (16 * 24 - 9) * 2


def test_a_stroke_lies_where_it_is_painted():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 0}))
    simulation.apply(Stroke(x=20.5, y=3.5, radius=0.7, amount=1, falloff="none"))
    assert np.argwhere(simulation.bed.sand).tolist() == [[3, 20]]


def test_a_line_of_stamps_is_as_even_as_its_sum():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 0}))
    places = [(4.5 + 2.5 * number, 8.0) for number in range(7)]
    for number, (x, y) in enumerate(places):
        stamp = Stroke(x=x, y=y, radius=5.0, amount=1, trail=[Stamp(x=x, y=y) for x, y in places[:number]])
        simulation.apply(stamp)
    rows, columns = np.mgrid[:16, :24] + 0.5
    total = 0.0
    for x, y in places:
        share = np.minimum(np.hypot(columns - x, rows - y) / 5.0, 1.0)
        total = total + 0.5 + 0.5 * np.cos(np.pi * share)
    np.testing.assert_array_equal(simulation.bed.sand, np.rint(total))
    assert set(simulation.bed.sand[7, 8:16]) == {2}


def test_a_stamp_names_at_most_some_of_those_before_it():
    with pytest.raises(ScenarioError, match="trail"):
        Stroke(x=1.0, y=1.0, radius=2.0, amount=1, trail=[Stamp(x=1.0, y=1.0)] * 17)


def test_a_gentle_heap_is_undone_by_its_opposite():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 5}))
    heap = Stroke(x=12.0, y=8.0, radius=6.0, amount=4)
    simulation.apply(heap)
    assert simulation.bed.sand.max() == 9
    simulation.apply(heap.model_copy(update={"amount": -4}))
    assert set(simulation.bed.sand.ravel()) == {5}
    assert simulation.ledger.entered == simulation.ledger.left > 0


def test_the_wind_works_on_painted_sand():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 0}))
    assert simulation.advance(3).moved == 0
    simulation.apply(Stroke(x=12.0, y=8.0, radius=6.0, amount=4))
    assert simulation.advance(3).moved > 0


@pytest.mark.parametrize("amount", [2**31, -(2**31) - 1, 10**30])
def test_a_stroke_of_more_than_a_cell_can_hold_is_refused_and_leaves_the_bed_alone(monkeypatch, amount):
    simulation = Simulation(tiny())
    monkeypatch.setattr(simulation.model, "relax", lambda *_: 0)
    before = simulation.bed.sand.copy()
    with pytest.raises(ScenarioError, match=r"amount: is -?[0-9]+; allowed: whole number"):
        simulation.apply(Stroke(x=12.0, y=8.0, radius=6.0, amount=amount))
    np.testing.assert_array_equal(simulation.bed.sand, before)


def test_strokes_that_pile_up_beyond_what_a_cell_can_hold_are_refused():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 0}))
    simulation.bed.sand[8, 12] = 2**31 - 10
    before = simulation.bed.sand.copy()
    with pytest.raises(BarchanError, match="more than a cell can hold"):
        simulation.apply(Stroke(x=12.5, y=8.5, radius=1.0, amount=10, falloff="none"))
    np.testing.assert_array_equal(simulation.bed.sand, before)
    assert simulation.events == []


def planted(**vegetation):
    vegetation = {"kind": "uniform", **vegetation}
    return Simulation(tiny(model={"name": "nield_baas", "vegetation": vegetation}, sand__mean=9))


def test_painted_rock_lifts_the_sand_on_it_by_whole_slabs():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 1}))
    slabs = simulation.bed.units
    simulation.apply(RockStroke(x=12.0, y=8.0, radius=6.0, amount=20))
    risen = simulation.bed.ground / simulation.lattice.thickness
    assert risen.max() == pytest.approx(20, abs=1)
    assert np.allclose(risen, np.rint(risen))
    assert simulation.bed.units == slabs
    assert (simulation.bed.sand[risen > 10] == 0).any()


def test_rock_is_lowered_to_the_lowest_ground_at_most():
    simulation = Simulation(tiny())
    simulation.apply(RockStroke(x=12.0, y=8.0, radius=4.0, amount=9))
    simulation.apply(RockStroke(x=12.0, y=8.0, radius=8.0, amount=-100, falloff="none"))
    assert not simulation.bed.ground.any()


def test_rock_that_a_model_cannot_count_is_refused_and_leaves_the_ground_alone():
    simulation = Simulation(tiny())
    simulation.bed.ground[8, 12] = 2**29 * simulation.lattice.thickness
    before = simulation.bed.ground.copy()
    with pytest.raises(ScenarioError, match="allowed: up to"):
        simulation.apply(RockStroke(x=12.0, y=8.0, radius=4.0, amount=10**6))
    np.testing.assert_array_equal(simulation.bed.ground, before)
    assert simulation.events == []


def test_the_wind_meets_painted_rock_at_once():
    """Walls that slabs stop at are searched again: the run goes on as one taken up from its state."""
    simulation = Simulation(
        tiny(ground={"kind": "bump", "height": 3.0, "radius": 6.0}, model__path_test="hard")
    )
    simulation.advance(3)
    simulation.apply(RockStroke(x=4.0, y=8.0, radius=5.0, amount=12, falloff="none"))
    again = Simulation.from_state(simulation.state())
    simulation.advance(5)
    again.advance(5)
    np.testing.assert_array_equal(simulation.bed.sand, again.bed.sand)


@pytest.mark.parametrize(("field", "most"), [("grass", 1.0), ("mesquite", 3.0), ("shrub", 1.5)])
def test_plants_are_painted_between_none_and_their_greatest_effectiveness(field, most):
    simulation = planted()
    simulation.apply(PlantStroke(field=field, x=12.0, y=8.0, radius=5.0, amount=50.0, falloff="none"))
    cover = simulation.bed.arrays[field]
    assert set(cover.ravel()) == {0.0, most}
    simulation.apply(PlantStroke(field=field, x=12.0, y=8.0, radius=9.0, amount=-50.0, falloff="none"))
    assert not cover.any()


def test_thinning_leaves_alone_what_is_less_than_bare():
    simulation = planted(shrub=-0.4)
    simulation.apply(PlantStroke(field="shrub", x=12.0, y=8.0, radius=5.0, amount=-1.0))
    assert set(simulation.bed.arrays["shrub"].ravel()) == {-0.4}


def test_slopes_that_lose_their_plants_come_to_rest():
    simulation = planted(grass=1.0)
    simulation.apply(Stroke(x=12.0, y=8.0, radius=5.0, amount=40))
    steep = steepest_step(simulation.bed.sand)
    simulation.apply(PlantStroke(field="grass", x=12.0, y=8.0, radius=40.0, amount=-1.0, falloff="none"))
    assert steepest_step(simulation.bed.sand) < steep


def test_what_a_model_does_not_let_paint_is_refused():
    with pytest.raises(ScenarioError, match=r"'gras' cannot be painted; did you mean 'grass'\?"):
        planted().apply(PlantStroke(field="gras", x=1.0, y=1.0, radius=2.0, amount=1.0))
    with pytest.raises(ScenarioError, match="allowed: none of this model"):
        Simulation(tiny()).apply(PlantStroke(field="grass", x=1.0, y=1.0, radius=2.0, amount=1.0))


def test_strokes_of_all_kinds_give_the_same_bits_again():
    simulation = planted()
    for event in (
        RockStroke(x=4.0, y=4.0, radius=4.0, amount=6),
        PlantStroke(field="shrub", x=12.0, y=8.0, radius=5.0, amount=0.3),
        Stroke(x=12.0, y=8.0, radius=5.0, amount=6),
    ):
        simulation.advance(2)
        simulation.apply(event)
    simulation.advance(3)
    again = Simulation(simulation.scenario)
    for record in map(type(simulation.events[0]).from_data, [r.data() for r in simulation.events]):
        again.advance(record.step - again.steps_done)
        again.apply(record.event)
    again.advance(3)
    for name, array in simulation.bed.arrays.items():
        np.testing.assert_array_equal(array, again.bed.arrays[name])
