"""A run hands out the frames that its scenario asks for."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.simulation import Simulation
from tests.tiny import tiny


@given(st.integers(0, 23), st.integers(1, 25))
def test_frames_come_at_the_start_at_every_interval_and_at_the_end(steps, every):
    frames = list(Simulation(tiny(run__steps=steps, run__save_every=every)))
    assert [frame.step for frame in frames] == sorted({*range(0, steps + 1, every), steps})


def test_a_frame_is_the_bed_of_its_step():
    simulation = Simulation(tiny())
    for frame in simulation:
        alone = Simulation(tiny())
        alone.advance(frame.step)
        np.testing.assert_array_equal(frame.fields["sand"], alone.bed.sand)
        assert frame.tally == alone.tally
        assert frame.ledger == alone.ledger


def test_frames_stay_as_they_are_while_the_run_goes_on():
    frames = list(Simulation(tiny()))
    assert not np.array_equal(frames[0].fields["sand"], frames[-1].fields["sand"])
    assert [frame.tally.steps for frame in frames] == [0, 5, 10, 15, 20]


def test_iterating_goes_on_from_where_the_simulation_is():
    simulation = Simulation(tiny())
    simulation.advance(7)
    assert [frame.step for frame in simulation] == [10, 15, 20]


def test_a_run_that_is_over_has_no_more_frames():
    simulation = Simulation(tiny())
    assert len(list(simulation)) == 5
    assert list(simulation) == []
    assert simulation.done


@pytest.mark.parametrize(("before", "expected"), [(20, [30, 40]), (18, [20, 30, 40])])
def test_a_run_that_is_extended_goes_on_with_its_interval(before, expected):
    simulation = Simulation(tiny(run__steps=before, run__save_every=10))
    assert [frame.step for frame in simulation][-1] == before
    simulation.extend(40)
    assert not simulation.done
    assert [frame.step for frame in simulation] == expected


def test_a_longer_run_begins_like_a_shorter_one():
    short = list(Simulation(tiny(run__steps=10)))
    long = list(Simulation(tiny(run__steps=20)))
    for one, other in zip(short, long, strict=False):
        np.testing.assert_array_equal(one.fields["sand"], other.fields["sand"])
