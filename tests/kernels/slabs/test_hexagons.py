"""On hexagons the compiled kernel equals the plain reference, which looks every cell up by its centre."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.slabs.parameters import SlabParameters
from barchan.streams import Stream
from barchan.wind.segment import Segment
from tests.kernels.slabs.test_step import (
    EVERY_COMBINATION,
    FEATURES,
    PARAMETERS,
    PlainSlabs,
    assert_same,
    both,
    rough_bed,
    with_features,
)

WINDS = [270.0, 240.0, 300.0, 210.0, 262.0, 225.0, 200.0, 330.0, 181.0, 359.0, 315.0]


@pytest.mark.parametrize(
    "number",
    [
        pytest.param(number, marks=pytest.mark.extended if number % 8 else ())
        for number in range(0, len(EVERY_COMBINATION), 3)
    ],
)
def test_kernel_equals_reference_on_hexagons_for_combinations_of_variants(number):
    variants = EVERY_COMBINATION[number]
    shadow = {
        "shadow_from": ["edge", "place"][number // 48 % 2],
        "stack_tops": "sloping" if number % 5 == 0 else "level",
    }
    parameters = SlabParameters(
        **{**variants, **shadow}, band_rows=3, hop_length=[3.0, 4.0, 2.5][number % 5 % 3]
    )
    lattice = Lattice(
        kind="hex",
        rows=8,
        columns=17,
        boundary_x=["periodic", "open"][number // 2 % 2],
        boundary_y=["open", "periodic"][number // 4 % 2],
    )
    ground = np.zeros(lattice.shape)
    if number % 5 == 0:
        ground = np.random.default_rng(number).random(lattice.shape) * 2
    wind = WINDS[number % len(WINDS)]
    bed, tally, plain = both(parameters, lattice, rough_bed(lattice, number), ground, wind)
    assert tally.moved > 0
    assert_same(bed, tally, plain)


HEX_LATTICES = st.builds(
    Lattice,
    kind=st.just("hex"),
    rows=st.sampled_from([2, 4, 6, 10]),
    columns=st.integers(8, 23),
    slab_aspect=st.sampled_from([None, 0.1, 0.5]),
    boundary_x=st.sampled_from(["periodic", "open"]),
    boundary_y=st.sampled_from(["periodic", "open"]),
)


@settings(deadline=None, max_examples=60)
@given(PARAMETERS, HEX_LATTICES, st.integers(0, 2**32), st.sampled_from(WINDS), st.booleans())
def test_kernel_equals_reference_on_hexagons_whatever_the_parameters(
    parameters, lattice, seed, direction, uneven
):
    random = np.random.default_rng(seed)
    ground = random.normal(size=lattice.shape) if uneven else np.full(lattice.shape, 7.0)
    sand = random.integers(0, 5, lattice.shape).astype(np.int32)
    bed, tally, plain = both(parameters, lattice, sand, ground, direction, steps=1, key_seed=seed)
    assert_same(bed, tally, plain)


@pytest.mark.parametrize(
    "features", [pytest.param(FEATURES[k], marks=pytest.mark.extended) for k in (4, 8, 9)]
)
@settings(deadline=None, max_examples=20)
@given(st.data())
def test_kernel_equals_reference_on_hexagons_with_what_models_add(features, data):
    bed, tally, plain = with_features(features, data, data.draw(HEX_LATTICES), WINDS[1:])
    assert_same(bed, tally, plain)


@pytest.mark.parametrize("direction", [270.0, 240.0, 255.0, 250.0, 180.0, 10.0])
@pytest.mark.parametrize("hop", [1.0, 3.7])
def test_mean_hop_is_exact_at_every_angle_on_hexagons(direction, hop):
    """Single hops on bare ground: the mean distance between centres is one hop, straight downwind."""
    lattice = Lattice(kind="hex", rows=32, columns=32)
    rules = {"hop_length": hop, "p_s": 1.0, "p_ns": 1.0, "band_rows": 32, "forced_erosion": True}
    x, y = lattice.centres
    landed = []
    for seed in range(900):
        sand = np.zeros(lattice.shape, np.int32)
        sand[16, 16] = 1
        bed = Bed(lattice, np.zeros(lattice.shape), sand)
        PlainSlabs(SlabParameters(**rules), lattice).advance(
            bed, Segment(0, 1, 0, 1, direction), Stream(seed, "x")
        )
        landed.append((x[bed.sand > 0].item() - x[16, 16], y[bed.sand > 0].item() - y[16, 16]))
    expected = -hop * np.array([math.sin(math.radians(direction)), math.cos(math.radians(direction))])
    # a hexagon's second moment is 5/72 on every axis; start and end of a hop differ by at most two such
    error = 4 * math.sqrt(2 * 5 / 72 / len(landed))
    assert np.mean(landed, axis=0) == pytest.approx(expected, abs=error)


@pytest.mark.parametrize("rule", ["centre", "place"])
@pytest.mark.parametrize("turns", [1, 2, 5])
def test_a_wind_turned_by_sixty_degrees_shelters_the_turned_cells(turns, rule):
    """The lattice fits onto itself after sixth parts of a turn, so do shadow zones of one stack on it."""
    lattice = Lattice(kind="hex", rows=40, columns=40)
    sand = np.zeros(lattice.shape, np.int32)
    sand[20, 20] = 9
    bed = Bed(lattice, np.zeros(lattice.shape), sand)
    model = PlainSlabs(SlabParameters(shadow_from=rule), lattice)
    x, y = (centre - centre[20, 20] for centre in lattice.centres)

    def places(direction, turn):
        zone = model.shadow_zone(bed, direction)
        turned = (x[zone] + 1j * y[zone]) * np.exp(1j * math.radians(turn))
        return sorted(zip(turned.real.round(6) + 0.0, turned.imag.round(6) + 0.0, strict=True))

    for wind in (270.0, 255.0):
        was, now = places(wind, 60.0 * turns), places((wind - 60.0 * turns) % 360, 0.0)
        assert len(was) > 5
        np.testing.assert_allclose(was, now, atol=1e-5)
