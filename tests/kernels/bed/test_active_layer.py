"""Sand of several sizes in compiled code against lists of parcels, draw by draw."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.kernels.bed.active_layer import put, slide, take
from barchan.kernels.bed.state import ActiveLayer
from tests.kernels.bed.active_layer_reference import Stacks

CELLS = 3


@st.composite
def stacks(draw):
    sizes, full = draw(st.integers(1, 4)), draw(st.integers(1, 6))
    kinds = st.integers(0, sizes - 1)
    layers = [draw(st.lists(kinds, max_size=full)) for _ in range(CELLS)]
    deeps = [draw(st.lists(kinds, max_size=8)) if len(one) == full else [] for one in layers]
    return sizes, Stacks(layers, deeps, full, draw(st.integers(0, 2**64 - 1)))


@settings(deadline=None)
@given(stacks(), st.data())
def test_parcels_move_as_in_the_obvious_lists(made, data):
    sizes, slow = made
    layer, deep = (np.array(counts, np.int32) for counts in slow.counts(sizes))
    fast = ActiveLayer(layer, deep, slow.full, np.array([slow.turn], np.uint64))
    for _ in range(data.draw(st.integers(0, 12))):
        cell, other = data.draw(st.permutations(range(CELLS)))[:2]
        kind, parcels = data.draw(st.integers(0, sizes - 1)), data.draw(st.integers(1, 5))
        held = slow.layers[cell].count(kind)
        what = data.draw(st.sampled_from(["put", "take", "slide"]))
        if what == "put":
            slow.put(cell, kind, parcels)
            put(fast, cell, kind, parcels)
        elif what == "take" and held:
            slow.take(cell, kind, min(parcels, held))
            take(fast, cell, kind, min(parcels, held))
        elif what == "slide" and slow.layers[cell]:
            slow.slide(cell, other)
            slide(fast, cell, other, 1)
        layer, deep = slow.counts(sizes)
        np.testing.assert_array_equal(fast.surface, layer)
        np.testing.assert_array_equal(fast.substrate, deep)
        assert int(fast.rng_state[0]) == slow.turn
