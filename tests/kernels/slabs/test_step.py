"""The compiled kernel equals the plain reference, cell for cell, for every combination of variants."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.models.werner import Werner
from barchan.slabs.model import SlabModel
from barchan.slabs.parameters import SlabParameters
from barchan.slabs.rules import ErosionChance, HopRule, Rules
from barchan.streams import Stream, derive
from barchan.wind.frame import WindFrame
from barchan.wind.segment import Segment
from tests.kernels.slabs.hex_reference import HexField
from tests.kernels.slabs.slab_reference import SCALE, Field

VARIANTS = {
    "neighbourhood": ["von_neumann", "moore"],
    "neighbour_order": ["wind", "random", "downslope"],
    "upwind_avalanches": [True, False],
    "lee_erosion": [True, False],
    "polling": ["repeated", "non_repeated"],
    "forced_erosion": [True, False],
    "repose_test": ["before", "after"],
    "shadow_from": ["centre", "edge", "place"],
}
EVERY_COMBINATION = [dict(zip(VARIANTS, v, strict=True)) for v in itertools.product(*VARIANTS.values())]


class PlainSlabs(SlabModel):
    """Slab transport with nothing but what a test adds."""

    extra = Rules()
    field = None

    def rules(self):
        return self.extra

    def mobility(self, bed, direction):
        return self.field


def both(
    parameters,
    lattice,
    sand,
    ground,
    direction,
    steps=2,
    key_seed=11,
    first=0,
    count=None,
    extra=None,
    mobility=None,
):
    """Beds and tallies after the same polls, by the kernel and by the reference (winds near west only)."""
    count = lattice.cells if count is None else count
    bed = Bed(lattice, ground, sand)
    model = PlainSlabs(parameters, lattice)
    model.extra = extra or Rules()
    model.field = mobility
    stream = Stream(key_seed, "transport")
    segment = Segment(5, steps, first, count, direction)
    tally = model.advance(bed, segment, stream)
    frame = WindFrame.of(direction, lattice.hexagonal)
    assert frame.turns == 0
    release = parameters.limits(lattice, parameters.static_repose_angle)
    plain = (HexField if lattice.hexagonal else Field)(
        sand.tolist(),
        (ground / lattice.thickness).tolist(),
        parameters,
        lattice.aspect,
        parameters.face_limit(lattice),
        parameters.corner_step_limit(lattice),
        parameters.hop_length,
        frame.angle,
        lattice.boundary_x == "periodic",
        lattice.boundary_y == "periodic",
        model.extra,
        None if mobility is None else np.rint(mobility * SCALE).astype(int).tolist(),
        parameters.limits(lattice, model.extra.stabilised_angle),
        None if release == parameters.limits(lattice) else release,
    )
    for step in range(5, 5 + steps):
        plain.step(derive(stream.key, step), first, count)
    return bed, tally, plain


def assert_same(bed, tally, plain):
    np.testing.assert_array_equal(bed.sand, plain.sand)
    for name in ("moved", "left", "capped", "exhausted"):
        assert getattr(tally, name) == plain.tally[name], name
    across = 2 / math.sqrt(3) if bed.lattice.hexagonal else 1.0
    assert tally.travel_x * 2**16 == plain.tally["x"]
    assert tally.travel_y * 2**16 == pytest.approx(plain.tally["y"] * across, rel=1e-12)


def rough_bed(lattice, seed, top=9):
    random = np.random.default_rng(seed)
    sand = random.integers(0, top, lattice.shape) * (random.random(lattice.shape) < 0.7)
    sand[lattice.rows // 2, lattice.columns // 3] += 25
    return sand.astype(np.int32)


@pytest.mark.parametrize(
    "number",
    [
        pytest.param(number, marks=pytest.mark.extended if number % 7 in (0, 1, 3, 5) else ())
        for number in range(len(EVERY_COMBINATION))
    ],
)
def test_kernel_equals_reference_for_every_combination_of_variants(number):
    variants = EVERY_COMBINATION[number]
    uneven = number % 5 == 0
    # each kind of tops is another kernel, as is each kind of ground
    tops = "sloping" if uneven else "level"
    hop = [3.0, 4.0, 2.5][number % 3]
    parameters = SlabParameters(**variants, stack_tops=tops, band_rows=3, hop_length=hop)
    lattice = Lattice(
        rows=7,
        columns=19,
        boundary_x=["periodic", "open"][number // 2 % 2],
        boundary_y=["open", "periodic"][number // 3 % 2],
    )
    direction = [270.0, 270.0, 250.0, 297.5][number % 4]
    random = np.random.default_rng(number)
    ground = random.random(lattice.shape) * 2 if uneven else np.zeros(lattice.shape)
    sand = rough_bed(lattice, number)
    bed, tally, plain = both(parameters, lattice, sand, ground, direction)
    assert tally.moved > 0
    assert_same(bed, tally, plain)


PARAMETERS = st.builds(
    SlabParameters,
    **{name: st.sampled_from(values) for name, values in VARIANTS.items()},
    hop_length=st.sampled_from([0.4, 1.0, 2.5, 5.0, 12.0, 31.0]),
    p_s=st.sampled_from([0.0, 0.2, 0.6, 1.0]),
    p_ns=st.sampled_from([0.0, 0.4, 1.0]),
    max_hops=st.sampled_from([1, 3, 40]),
    shadow_angle=st.sampled_from([5.0, 15.0, 40.0]),
    repose_angle=st.sampled_from([10.0, 30.0, 33.7, 45.0]),
    corner_limit=st.sampled_from(["face", "geometric", 3]),
    band_rows=st.sampled_from([1, 2, 5, 64]),
)
LATTICES = st.builds(
    Lattice,
    rows=st.integers(1, 6),
    columns=st.integers(8, 36),
    slab_aspect=st.sampled_from([None, 0.1, 0.5]),
    boundary_x=st.sampled_from(["periodic", "open"]),
    boundary_y=st.sampled_from(["periodic", "open"]),
)


@settings(deadline=None, max_examples=150)
@given(
    PARAMETERS,
    LATTICES,
    st.integers(0, 2**32),
    st.sampled_from([270.0, 226.0, 247.5, 262.0, 301.0, 314.0]),
    st.booleans(),
    st.sampled_from([0, 1, 4, 40]),
)
def test_kernel_equals_reference_whatever_the_parameters(parameters, lattice, seed, direction, uneven, top):
    random = np.random.default_rng(seed)
    ground = random.normal(size=lattice.shape) if uneven else np.full(lattice.shape, 7.0)
    sand = random.integers(0, top + 1, lattice.shape).astype(np.int32)
    bed, tally, plain = both(parameters, lattice, sand, ground, direction, key_seed=seed)
    assert_same(bed, tally, plain)


HOP_RULES = st.builds(
    HopRule,
    linear=st.sampled_from([0.0, 0.4, 1.1]),
    quadratic=st.sampled_from([0.0, 0.002, 0.05]),
    follows_relief=st.booleans(),
    whole=st.booleans(),
    every_hop=st.booleans(),
)
EROSION = st.builds(ErosionChance, st.sampled_from([0.3, 1.0]), st.sampled_from([-0.2, 0.0]))
FEATURES = [
    # speed-up, plants, uneven ground, oblique wind, path test, release
    (True, False, False, False, False, False),
    (True, False, True, True, True, False),
    (False, False, True, False, True, False),
    (True, False, True, False, True, False),
    (False, False, True, True, True, False),
    (False, True, False, False, False, False),
    (False, True, True, True, False, True),
    (False, False, False, True, False, True),
    (True, True, False, False, True, True),
    (True, True, True, True, True, True),
]
"""Combinations of what models add; each is a kernel of its own, and takes seconds to compile."""

ALWAYS = (FEATURES[3],)
"""The one that most presets of dunes use; the others are for whoever changes a kernel."""

CASES = [
    pytest.param(case, marks=[] if case in ALWAYS else [pytest.mark.extended], id=f"features{number}")
    for number, case in enumerate(FEATURES)
]

WITH_PLACE = (FEATURES[0], FEATURES[1], FEATURES[8])
"""Those that are tried with the shadow from each slab's place too, which is another kernel."""


@pytest.mark.parametrize("features", CASES)
@settings(max_examples=30)
@given(st.data())
def test_kernel_equals_reference_with_what_models_add(features, data):
    drawn = PARAMETERS if features in WITH_PLACE else PARAMETERS.filter(lambda p: p.shadow_from != "place")
    bed, tally, plain = with_features(features, data, data.draw(LATTICES), [226.0, 262.0, 314.0], drawn)
    assert_same(bed, tally, plain)


def with_features(features, data, lattice, oblique_winds, drawn=PARAMETERS):
    """Beds and tallies under some of what models add, with all else drawn."""
    speedup, plants, uneven, oblique, path, release = features
    parameters = data.draw(drawn)
    seed = data.draw(st.integers(0, 2**32))
    random = np.random.default_rng(seed)
    ground = np.zeros(lattice.shape)
    if uneven and data.draw(st.booleans(), "rocks"):
        ground = 9.0 * (random.random(lattice.shape) < 0.1)
    elif uneven:
        ground = random.normal(size=lattice.shape)
    above = data.draw(st.sampled_from([0.0, 8.0, 20.0])) if release else 0.0
    changes = {
        "path_test": data.draw(st.sampled_from(["hard", "surface"])) if path else "off",
        "static_repose_angle": parameters.repose_angle + above,
    }
    return both(
        parameters.model_copy(update=changes),
        lattice,
        random.integers(0, 9, lattice.shape).astype(np.int32),
        ground,
        data.draw(st.sampled_from(oblique_winds)) if oblique else 270.0,
        steps=1,
        key_seed=seed,
        extra=Rules(
            hop=data.draw(HOP_RULES) if speedup else None,
            erosion=data.draw(EROSION),
            stabilised_angle=data.draw(st.sampled_from([10.0, 40.0, 50.0])),
            stabilised_mobility=data.draw(st.sampled_from([-1.0, 0.7])),
        ),
        mobility=random.normal(0.7, 0.7, lattice.shape) if plants else None,
    )


@settings(deadline=None, max_examples=40)
@given(
    st.sampled_from(["repeated", "non_repeated"]),
    st.booleans(),
    st.integers(0, 200),
    st.integers(1, 300),
    st.integers(0, 99),
)
def test_kernel_equals_reference_for_any_slice_of_a_step(polling, forced, first, count, seed):
    parameters = SlabParameters(polling=polling, forced_erosion=forced, band_rows=2)
    lattice = Lattice(rows=5, columns=16)
    sand = rough_bed(lattice, seed)
    ground = np.zeros(lattice.shape)
    bed, tally, plain = both(parameters, lattice, sand, ground, 270.0, first=first, count=count)
    assert_same(bed, tally, plain)


@pytest.mark.parametrize("cuts", [[64], [10, 54], [1] * 64])
def test_slices_of_a_non_repeated_step_poll_each_cell_once(cuts):
    """With hops of the field's length every slab leaves, so a cell's polls can be counted."""
    lattice = Lattice(rows=8, columns=8, boundary_x="open")
    parameters = SlabParameters(polling="non_repeated", hop_length=8.0, band_rows=3, lee_erosion=True)
    bed = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, 2))
    model = PlainSlabs(parameters, lattice)
    first = 0
    for count in cuts:
        model.advance(bed, Segment(3, 1, first, count, 270.0), Stream(1, "transport"))
        first += count
    np.testing.assert_array_equal(bed.sand, 1)


def test_polls_of_a_banded_step_are_spread_as_if_cells_were_drawn_freely():
    """Each cell's polls follow the binomial distribution of free draws: mean and variance."""
    lattice = Lattice(rows=40, columns=40, boundary_x="open")
    parameters = SlabParameters(hop_length=40.0, band_rows=7, repose_angle=89.0, lee_erosion=True)
    polled = []
    for seed in range(60):
        bed = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, 50))
        PlainSlabs(parameters, lattice).advance(bed, Segment(0, 1, 0, 1600, 270.0), Stream(seed, "x"))
        polled.append(50 - bed.sand)
    counts = np.array(polled)
    assert counts.sum(axis=(1, 2)).tolist() == [1600] * 60
    n = counts.size
    assert counts.var() == pytest.approx(1 - 1 / 1600, abs=4 * math.sqrt(2 / n + 1 / n))
    rows = counts.sum(axis=2)
    assert rows.var() == pytest.approx(40 * (1 - 1 / 40), rel=4 * math.sqrt(2 / rows.size))
    chi2 = ((counts.sum(axis=0) - 60) ** 2 / 60).sum()
    assert abs(chi2 - 1599) < 4 * math.sqrt(2 * 1599)


@pytest.mark.parametrize("turns", [1, 2, 3])
@pytest.mark.parametrize("direction", [270.0, 241.0])
@pytest.mark.parametrize("uneven", [False, True])
def test_turning_wind_and_field_together_turns_the_result(turns, direction, uneven):
    lattice = Lattice(rows=12, columns=31, boundary_x="open", boundary_y="periodic")
    crossed = Lattice(rows=31, columns=12, boundary_x="periodic", boundary_y="open")
    parameters = SlabParameters(neighbourhood="moore", corner_limit=3)
    sand = rough_bed(lattice, 4)
    ground = np.random.default_rng(1).random(lattice.shape) * uneven
    bed = Bed(lattice, ground, sand)
    turned_lattice = crossed if turns % 2 else lattice

    def turn(field):
        """Turn a map anticlockwise; rows grow to the north."""
        return np.rot90(field, turns, axes=(1, 0))

    turned = Bed(turned_lattice, turn(ground), turn(sand))
    stream = Stream(3, "transport")
    PlainSlabs(parameters, lattice).advance(bed, Segment(0, 6, 0, 372, direction), stream)
    other = (direction - 90 * turns) % 360
    PlainSlabs(parameters, turned_lattice).advance(turned, Segment(0, 6, 0, 372, other), stream)
    np.testing.assert_array_equal(turned.sand, turn(bed.sand))


@pytest.mark.parametrize("direction", [270.0, 255.0, 240.0, 225.0, 200.0, 10.0])
@pytest.mark.parametrize("hop", [1.0, 5.0, 3.7])
def test_mean_hop_is_exact_at_every_angle(direction, hop):
    """Single hops on bare ground (p_ns = 1): the mean landing place is one hop downwind of the start."""
    lattice = Lattice(rows=64, columns=64)
    parameters = SlabParameters(hop_length=hop, p_s=1.0, p_ns=1.0, band_rows=64)
    landed = []
    for seed in range(1200):
        sand = np.zeros(lattice.shape, np.int32)
        sand[32, 32] = 1
        bed = Bed(lattice, np.zeros(lattice.shape), sand)
        model = PlainSlabs(SlabParameters(**{**dict(parameters), "forced_erosion": True}), lattice)
        model.advance(bed, Segment(0, 1, 0, 1, direction), Stream(seed, "x"))
        landed.append(np.argwhere(bed.sand)[0] - 32)
    mean = np.mean(landed, axis=0)
    expected = -hop * np.array([math.cos(math.radians(direction)), math.sin(math.radians(direction))])
    error = 4 * 0.5 / math.sqrt(len(landed))
    assert mean == pytest.approx(expected, abs=error)


def test_mean_travel_is_hop_length_over_deposition_probability():
    lattice = Lattice(rows=64, columns=512)
    parameters = Werner.Parameters(p_s=0.5, p_ns=0.5, lee_erosion=True, shadow_angle=89.0, repose_angle=89.0)
    bed = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, 100))
    tally = Werner(parameters, lattice).advance(bed, Segment(0, 4, 0, lattice.cells, 270.0), Stream(1, "x"))
    error = 5.0 * math.sqrt(0.5) / 0.5 / math.sqrt(tally.moved)
    assert tally.travel_x / tally.moved == pytest.approx(10.0, abs=4 * error)


def test_a_slab_that_never_settles_is_put_down_and_counted():
    lattice = Lattice(rows=8, columns=16)
    parameters = SlabParameters(p_s=0.0, p_ns=0.0, max_hops=7, shadow_angle=89.0)
    bed = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, 1))
    tally = PlainSlabs(parameters, lattice).advance(bed, Segment(0, 1, 0, 128, 270.0), Stream(1, "x"))
    assert tally.capped == tally.moved > 0
    assert bed.units == 128


def test_forced_erosion_moves_one_slab_a_poll_and_ends_where_none_can():
    lattice = Lattice(rows=8, columns=16)
    for polling in ("repeated", "non_repeated"):
        parameters = SlabParameters(forced_erosion=True, polling=polling)
        model = PlainSlabs(parameters, lattice)
        sand = np.zeros(lattice.shape, np.int32)
        sand[3, 3] = 1
        bed = Bed(lattice, np.zeros(lattice.shape), sand)
        tally = model.advance(bed, Segment(0, 3, 0, 128, 270.0), Stream(1, "x"))
        assert (tally.moved, tally.exhausted) == (384, 0)
        empty = Bed(lattice, np.zeros(lattice.shape), np.zeros(lattice.shape))
        tally = model.advance(empty, Segment(0, 3, 0, 128, 270.0), Stream(1, "x"))
        assert (tally.moved, tally.exhausted) == (0, 3)
