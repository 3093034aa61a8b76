"""Painting sand on a bed that the wind works on: exact, clipped, settled, accounted for."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.errors import BarchanError, ScenarioError
from barchan.simulation import Simulation, Stroke
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
    assert simulation.bed.slabs == ledger.initial + ledger.entered - ledger.left
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
    assert simulation.bed.slabs == 9 * 7
    assert simulation.bed.sand.max() < 7


def test_taking_more_than_there_is_takes_what_there_is():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 2}))
    simulation.apply(Stroke(x=6.5, y=4.5, radius=1.5, amount=-100, falloff="none"))
    assert simulation.ledger.left == 9 * 2
    assert simulation.bed.sand[3:6, 5:8].sum() == 0
    assert simulation.bed.slabs == (16 * 24 - 9) * 2


def test_a_stroke_lies_where_it_is_painted():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 0}))
    simulation.apply(Stroke(x=20.5, y=3.5, radius=0.7, amount=1, falloff="none"))
    assert np.argwhere(simulation.bed.sand).tolist() == [[3, 20]]


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
    monkeypatch.setattr(simulation.model, "settle", lambda *_: 0)
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
