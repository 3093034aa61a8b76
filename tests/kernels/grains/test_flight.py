"""The compiled flight of grains against the slow and obvious one, bit for bit, on any number of threads."""

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from barchan.aeolian.flow_over_relief import ReliefWind
from barchan.bed import Bed
from barchan.kernels.core import threads as thread_pool
from barchan.kernels.grains import iterations as grain_iterations
from barchan.kernels.grains import territories
from barchan.lattice import Lattice
from barchan.models import model
from barchan.streams import Stream, derive
from barchan.wind.segment import Segment
from tests.grains.keys import nested
from tests.kernels.grains.grain_reference import ReferenceFlight

STREAM = Stream(3, "transport")

STAND = {"west": 0.2, "east": 0.8, "south": 0.3, "height": 0.03}
BUSY = nested(feedback__momentum_weight=0.02, entrainment__probability=0.05)

STANDS = [STAND, {**STAND, "west": 0.5, "height": 0.002}]


def small_bed(seed, boundary="periodic", uneven=False, depth=6):
    random = np.random.default_rng(seed)
    lattice = Lattice(
        rows=9,
        columns=13,
        cell_size=0.01,
        slab_height=0.15e-3,
        boundary_x=boundary,
        boundary_y=boundary,
    )
    ground = random.random(lattice.shape) * 2e-3 if uneven else np.zeros(lattice.shape)
    return Bed(lattice, ground, random.integers(0, depth, lattice.shape))


def fly_both(bed, wind, iterations, stream=None, **rules):
    flight = model("wang_hu")
    rules = flight.Parameters(collapse_every=10**6, iterations_per_step=iterations, repose_angle=89, **rules)
    fast = flight(rules, bed.lattice)
    fast.initialise(bed, 1)
    same = Bed.from_fields(bed.lattice, bed.frame(), fast.fields)
    slow = ReferenceFlight(fast, same, wind, stream)
    if stream is not None:
        level = fast.blow
        fast.blow = lambda ground, wind: ground.bend_wind(ReliefWind(*stream)) or level(ground, wind)
    tally = fast.advance(bed, wind, STREAM)
    for iteration in range(iterations):
        slow.iterate(derive(STREAM.key, iteration))
    return fast, slow, tally


FLIGHTS = st.tuples(
    st.integers(0, 2**32),
    st.sampled_from([270.0, 0.0, 143.0]),
    st.sampled_from(["periodic", "open"]),
    st.booleans(),
    st.booleans(),
    st.sampled_from(["euler", "trapezoid"]),
    st.sampled_from(["constant", "reynolds"]),
    st.sampled_from(["stack", "patch"]),
    st.sampled_from([0.0, 0.005, -0.5]),
)


@pytest.mark.parametrize(
    ("plants", "bent"),
    [  # each is a kernel of its own, and takes long to compile
        ([], "level"),
        (STANDS, "faster"),
        pytest.param(STANDS, "level", marks=pytest.mark.extended),
        pytest.param(STANDS, "bent", marks=pytest.mark.extended),
        pytest.param([], "faster", marks=pytest.mark.extended),
    ],
)
@settings(max_examples=6, deadline=None, phases=[Phase.explicit, Phase.generate])
@given(FLIGHTS)
def test_kernels_equal_the_obvious_flight_bit_for_bit(plants, bent, drawn):
    seed, direction, boundary, uneven, lee, scheme, drag, footprint, lifted = drawn
    bed = small_bed(seed, boundary, uneven, depth=6 if footprint == "stack" else 12)
    wind = Segment(0, 1, 0, bed.lattice.cells, direction)
    rules = {"scheme": scheme, "drag": drag, "max_bounces": 3, "max_grains_per_cell": 0.5}
    rules |= {"footprint": footprint, **nested(entrainment__from_lee=lee, canopy__stands=plants)}
    rules |= {"displacement": lifted} if lifted >= 0 else {"stability": lifted}
    if bent != "level":
        stream = np.random.default_rng(seed).uniform(-0.3, 0.3, (3, *bed.lattice.shape)).astype(np.float32)
        rules["stream"] = (stream[0], 1 + stream[1], stream[2])[: 3 if bent == "faster" else 1]
    fast, slow, tally = fly_both(bed, wind, 40, **rules)
    np.testing.assert_array_equal(bed.sand, slow.bed.sand)
    assert fast.pool.flying == sum(grain.flies for grain in slow.grains)
    assert (tally.moved, tally.left, tally.capped) == (slow.moved, slow.left, slow.capped)
    assert (tally.travel_x * 2**16, tally.travel_y * 2**16) == tuple(slow.travel)
    for slot, grain in enumerate(slow.grains):
        if grain.flies:
            found = tuple(fast.pool.motion[:6, slot])
            assert found == (grain.x, grain.y, grain.z, grain.u, grain.v, grain.w)


@pytest.mark.parametrize(
    ("name", "rules"),
    [
        ("wang_hu", {}),
        ("wang_hu", {"footprint": "patch", "max_bounces": 5}),
        ("wang_hu", nested(canopy__stands=[STAND])),
        ("wang_hu", {"collapse": "filter", "filter_scale": 50.0}),
        pytest.param(
            "ripples",
            nested(
                canopy__stands=[STAND],
                feedback__length=0.03,
                feedback__momentum_weight=0.02,
                entrainment__probability=0.05,
            ),
            marks=pytest.mark.extended,
        ),
        ("ripples", {**BUSY, "time_step": 1e-3, "max_grains_per_cell": 2.0}),
    ],
)
def test_bits_do_not_depend_on_the_number_of_threads(monkeypatch, name, rules):
    beds = []
    for threads in (1, 2, 3):
        monkeypatch.setattr(thread_pool, "LEAST", 256)
        monkeypatch.setattr(territories, "LEAST_WIDTH", 16)
        monkeypatch.setattr(grain_iterations, "MOST_BEYOND", np.inf)
        monkeypatch.setattr(thread_pool, "thread_count", lambda threads=threads: threads)
        lattice = Lattice(rows=40, columns=50, cell_size=0.01, slab_height=0.15e-3)
        bed = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, 20))
        flight = model(name)(model(name).Parameters(**rules), lattice)
        flight.initialise(bed, 1)
        monkeypatch.setattr(grain_iterations, "PIECE", 1024 if threads == 1 else 256)
        tally = flight.advance(bed, Segment(0, 200, 0, lattice.cells, 200.0), STREAM)
        beds.append((bed.sand.copy(), flight.pool.motion.copy(), tally))
    for sand, motion, tally in beds[1:]:
        np.testing.assert_array_equal(sand, beds[0][0])
        np.testing.assert_array_equal(motion, beds[0][1])
        assert tally == beds[0][2]


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("name", ["wang_hu", "ripples"])
def test_bits_do_not_depend_on_how_iterations_are_cut_into_batches(monkeypatch, name, threads):
    monkeypatch.setattr(thread_pool, "LEAST", 256)
    monkeypatch.setattr(thread_pool, "thread_count", lambda: threads)
    beds = []
    for most in (256, 3):
        monkeypatch.setattr("barchan.grains.iterations.MOST_ITERATIONS", most)
        lattice = Lattice(rows=30, columns=40, cell_size=0.01, slab_height=0.15e-3)
        bed = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, 20))
        flight = model(name)(model(name).Parameters(max_grains_per_cell=1.0), lattice)
        flight.advance(bed, Segment(0, 30, 0, lattice.cells, 200.0), STREAM)
        beds.append((bed.sand.copy(), flight.pool.motion.copy()))
    np.testing.assert_array_equal(beds[0][0], beds[1][0])
    np.testing.assert_array_equal(beds[0][1], beds[1][1])


@pytest.mark.parametrize("bounces", [0, 5])
def test_no_grain_bounces_for_ever(bounces):
    bed = small_bed(1, depth=60)
    wind = Segment(0, 400, 0, bed.lattice.cells, 270.0)
    rules = model("wang_hu").Parameters(
        max_bounces=bounces,
        bounce={"normal_damping": 1.0, "tangential_damping": 1.0, "stop_speed": 0.0},
    )
    flight = model("wang_hu")(rules, bed.lattice)
    tally = flight.advance(bed, wind, STREAM)
    assert tally.capped > 0
    assert flight.pool.counters[1].max() <= bounces
    assert np.isfinite(flight.pool.motion).all()
