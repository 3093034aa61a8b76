"""Wang & Hu's filter against the slow and obvious one, bit for bit."""

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from barchan.bed import Bed
from barchan.grains.bed import GrainGround
from barchan.kernels.grains.filter import smooth_slopes
from barchan.kernels.grains.surface import renew_mesh
from barchan.lattice import Lattice
from barchan.models import model
from tests.kernels.grains.grain_reference import smooth


def smoothed(ground):
    """Parcels moved by one pass over a ground."""
    unstable = ground.slopes.unstable
    return smooth_slopes(ground.arrays, ground.filter, unstable.queue, unstable.waiting)


@settings(max_examples=60, deadline=None, phases=[Phase.explicit, Phase.generate])
@given(
    st.integers(0, 2**32),
    st.sampled_from([(9, 13), (16, 8), (8, 40)]),
    st.sampled_from(["periodic", "open"]),
    st.sampled_from(["periodic", "open"]),
    st.sampled_from([3, 12, 200]),
    st.sampled_from([0.3, 1.0]),
    st.sampled_from([2.0, 20.0, 100.0]),
    st.booleans(),
)
def test_the_filter_equals_the_obvious_one(seed, shape, boundary_x, boundary_y, depth, gain, scale, uneven):
    random = np.random.default_rng(seed)
    lattice = Lattice(
        rows=shape[0],
        columns=shape[1],
        cell_size=0.01,
        slab_height=0.15e-3,
        boundary_x=boundary_x,
        boundary_y=boundary_y,
    )
    floor = random.random(shape) * 2e-3 if uneven else np.zeros(shape)
    rules = model("wang_hu").Parameters(collapse="filter", filter_gain=gain, filter_scale=scale)
    ground = GrainGround(rules, Bed(lattice, floor, random.integers(0, depth, shape)))
    arrays = ground.arrays
    level, sand = (part.reshape(shape).copy() for part in (arrays.level, arrays.sand))
    for _ in range(3):
        moved = smoothed(ground)
        assert moved == smooth(level, sand, ground.filter, ground.arrays.scale.parcel, lattice.periodic)
        np.testing.assert_array_equal(arrays.sand.reshape(shape), sand)
        np.testing.assert_array_equal(arrays.level.reshape(shape), level)
    assert not ground.slopes.unstable.waiting.any()
    kept = [part.copy() for part in (arrays.height, arrays.top, arrays.base)]
    np.testing.assert_array_equal(kept[0], (arrays.level * ground.arrays.scale.part).astype(np.float32))
    renew_mesh(arrays)
    np.testing.assert_array_equal(kept[1:], (arrays.top, arrays.base))


@pytest.mark.parametrize("heap", [2, 40])
def test_the_filter_leaves_a_flat_bed_alone_and_lowers_a_heap(heap):
    lattice = Lattice(rows=9, columns=9, cell_size=0.01, slab_height=0.15e-3)
    sand = np.full(lattice.shape, 50)
    rules = model("wang_hu").Parameters(collapse="filter", filter_scale=20.0)
    ground = GrainGround(rules, Bed(lattice, np.zeros(lattice.shape), sand.copy()))
    assert smoothed(ground) == 0
    sand[4, 4] += heap
    ground = GrainGround(rules, Bed(lattice, np.zeros(lattice.shape), sand))
    assert (smoothed(ground) > 0) == (heap > 6)
    assert ground.arrays.sand.sum() == 81 * 50 + heap
