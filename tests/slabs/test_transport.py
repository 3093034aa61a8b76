"""Slab transport in several threads gives the bits of one, whichever thread runs which band and when."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.bed import Bed
from barchan.kernels.slabs.plan import BROKEN_OFF, reach_of
from barchan.kernels.slabs.state import TALLY_SIZE, Schedule
from barchan.lattice import Lattice
from barchan.models.bishop import Bishop
from barchan.models.momiji import Momiji
from barchan.models.werner import Werner
from barchan.slabs import rounds, transport
from barchan.slabs.transport import Transport
from barchan.streams import Stream
from barchan.wind.segment import Segment
from tests.kernels.slabs.test_step import PlainSlabs
from tests.slabs.any_order import run_in_any_order

WINDS = [270.0, 90.0, 0.0, 247.5, 225.0, 300.0, 137.0]


@pytest.fixture(autouse=True)
def threads_for_small_fields(monkeypatch):
    monkeypatch.setattr(rounds, "_LEAST_POLLS", 0)


def field_of(lattice, seed, tower=0):
    random = np.random.default_rng(seed)
    sand = random.integers(0, 9, lattice.shape).astype(np.int32)
    sand[(lattice.rows // 2, lattice.columns // 2)] += tower
    return sand


def moved_by(threads, model, sand, direction, steps=3, ground=None):
    """The bed and the tally after some steps on so many threads."""
    lattice = model.lattice
    bed = Bed(lattice, np.zeros(lattice.shape) if ground is None else ground, sand)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("barchan.kernels.core.threads.thread_count", lambda: threads)
        tally = model.advance(bed, Segment(3, steps, 0, lattice.cells, direction), Stream(5, "transport"))
    return bed.sand, tally


@pytest.mark.parametrize("direction", WINDS)
@pytest.mark.parametrize("threads", [2, 3, 8])
def test_bits_are_those_of_one_thread(threads, direction):
    lattice = Lattice(rows=90, columns=80)
    model = Werner(Werner.Parameters(band_rows=8), lattice)
    sand = field_of(lattice, 1)
    alone, beside = (moved_by(n, model, sand, direction) for n in (1, threads))
    np.testing.assert_array_equal(alone[0], beside[0])
    assert alone[1] == beside[1]


@pytest.mark.parametrize("shadow", ["centre", "place"])
@pytest.mark.parametrize("direction", WINDS)
def test_bits_on_hexagons_are_those_of_one_thread(direction, shadow):
    lattice = Lattice(kind="hex", rows=90, columns=80, boundary_x="open")
    model = Werner(Werner.Parameters(band_rows=8, shadow_from=shadow), lattice)
    alone, beside = (moved_by(n, model, field_of(lattice, 1), direction) for n in (1, 3))
    np.testing.assert_array_equal(alone[0], beside[0])
    assert alone[1] == beside[1]


@pytest.mark.parametrize("kind", [Momiji, Bishop])
@pytest.mark.parametrize("boundary", ["periodic", "open"])
def test_bits_are_those_of_one_thread_where_hops_depend_on_height(kind, boundary):
    lattice = Lattice(rows=72, columns=64, boundary_x=boundary)
    model = kind(kind.Parameters(band_rows=8), lattice)
    alone, beside = (moved_by(n, model, field_of(lattice, 2), 270.0, steps=8) for n in (1, 3))
    np.testing.assert_array_equal(alone[0], beside[0])
    assert alone[1] == beside[1]


@settings(max_examples=40, deadline=None)
@given(
    rows=st.integers(5, 70),
    band_rows=st.integers(1, 12),
    boundary=st.sampled_from(["periodic", "open"]),
    polling=st.sampled_from(["repeated", "non_repeated"]),
    order=st.sampled_from(["wind", "random"]),
    lee=st.booleans(),
    shadow=st.sampled_from(["centre", "place"]),
    direction=st.sampled_from(WINDS),
    tower=st.sampled_from([0, 60, 200]),
    seed=st.integers(0, 99),
)
def test_any_field_and_any_rules_have_the_bits_of_one_thread(
    rows, band_rows, boundary, polling, order, lee, shadow, direction, tower, seed
):
    lattice = Lattice(rows=rows, columns=24, boundary_y=boundary)
    rules = {"polling": polling, "neighbour_order": order, "lee_erosion": lee, "shadow_from": shadow}
    model = PlainSlabs(PlainSlabs.Parameters(band_rows=band_rows, **rules), lattice)
    sand = field_of(lattice, seed, tower)
    alone, beside = (moved_by(n, model, sand, direction) for n in (1, 3))
    np.testing.assert_array_equal(alone[0], beside[0])
    assert alone[1] == beside[1]


def test_a_tower_that_slides_over_many_rows_makes_bands_wait_for_more(monkeypatch):
    distances = []
    whole = Transport._run_in

    def watched(self, threads, rounds):
        broken = whole(self, threads, rounds)
        distances.append((self.distance, broken))
        return broken

    monkeypatch.setattr(Transport, "_run_in", watched)
    lattice = Lattice(rows=64, columns=32)
    model = Werner(Werner.Parameters(band_rows=4), lattice)
    sand = np.full(lattice.shape, 3, np.int32)
    sand[32, :] = 200
    alone = moved_by(1, model, sand, 270.0)
    distances.clear()
    beside = moved_by(2, model, sand, 270.0)
    np.testing.assert_array_equal(alone[0], beside[0])
    assert alone[1] == beside[1]
    assert distances[0][1] != 0
    assert distances[-1][1] == 0
    assert distances[-1][0] > distances[0][0]


@pytest.mark.parametrize("threads", [1, 2])
def test_no_cell_exceeds_the_heights_that_bands_go_by(threads, monkeypatch):
    seen = []
    whole = Transport._plan

    def watched(self, *arguments):
        plan = whole(self, *arguments)
        seen.append((plan, self.stacks.surface, plan.peaks.copy()))
        return plan

    monkeypatch.setattr(Transport, "_plan", watched)
    lattice = Lattice(rows=64, columns=32)
    model = Werner(Werner.Parameters(band_rows=8), lattice)
    moved_by(threads, model, np.full(lattice.shape, 5, np.int32), 270.0, steps=8)
    (plan, surface, before), *_ = seen
    heights = surface.reshape(8, -1).max(axis=1)
    assert heights.max() > before.max()
    assert (plan.peaks >= heights).all()


def test_slabs_that_hop_far_find_room_however_many_they_are(monkeypatch):
    lattice = Lattice(rows=64, columns=64)
    model = Werner(Werner.Parameters(band_rows=4, hop_length=9.0), lattice)
    sand = field_of(lattice, 4)
    roomy = moved_by(2, model, sand, 225.0)
    monkeypatch.setattr(transport, "_FLIGHTS", 1)
    tight = moved_by(2, model, sand, 225.0)
    np.testing.assert_array_equal(roomy[0], tight[0])
    assert roomy[1] == tight[1]


@pytest.mark.parametrize("seed", range(6))
def test_every_order_that_a_plan_allows_gives_the_same_bits(monkeypatch, seed):
    random = np.random.default_rng(seed).integers(0, 1 << 30, 997)

    def at_random(self, threads, rounds):
        plan = self._plan(2, rounds)
        tally = np.zeros(TALLY_SIZE, np.int64)
        run_in_any_order(self.stacks, self.rules, self.work(), self.schedule, plan, tally, random)
        broken = plan.signals[BROKEN_OFF]
        self.counts += 0 if broken else tally
        return broken

    lattice = Lattice(rows=96, columns=48)
    model = Werner(Werner.Parameters(band_rows=6), lattice)
    sand = field_of(lattice, seed)
    direction = 270.0 if seed % 2 else 230.0
    in_order = moved_by(1, model, sand, direction, steps=6)
    monkeypatch.setattr(Transport, "_run_in", at_random)
    shuffled = moved_by(1, model, sand, direction, steps=6)
    np.testing.assert_array_equal(in_order[0], shuffled[0])
    assert in_order[1] == shuffled[1]


@given(
    rows=st.integers(4, 300),
    band_rows=st.integers(1, 40),
    distance=st.integers(1, 4),
    periodic=st.booleans(),
)
def test_bands_that_do_not_wait_for_each_other_share_no_row(rows, band_rows, distance, periodic):
    schedule = Schedule(each_once=False, forced=False, band_rows=band_rows)
    reach = reach_of(distance, rows, schedule, periodic)
    bands = -(-rows // band_rows)
    touched = {}
    for number in range(bands):
        first = number * band_rows
        own = range(first, min(first + band_rows, rows))
        touched[number] = (
            {(row + step) % rows for row in own for step in range(-reach, reach + 1)},
            {(row + step) % rows for row in own for step in range(-reach - 1, reach + 2)},
        )
        if not periodic:
            touched[number] = tuple(
                {row for row in rows_of if min(abs(row - o) for o in own) <= reach + 1}
                for rows_of in touched[number]
            )
    for one in range(bands):
        for other in range(one):
            apart = one - other
            if periodic:
                apart = min(apart, bands - apart)
            if apart > distance:
                assert not touched[one][0] & touched[other][1]
