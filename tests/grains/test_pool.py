"""Slots of grains, and how they are kept together."""

import numpy as np
import pytest

from barchan.grains.pool import close_gaps, free_slots, grains_in


def test_free_slots_lie_below_any_surface():
    motion, counters = free_slots(2000)
    assert motion.shape[1] == counters.shape[1] == 2000
    grains = grains_in(motion, counters)
    assert (grains.z < 0.0).all()
    assert not grains.status.any()
    assert grains.size_class is None
    grains.status[7] = 1
    assert counters[0, 7] == 1


@pytest.mark.parametrize("spare", [0, 3, 40])
def test_grains_move_up_in_their_order_and_free_slots_follow_in_theirs(spare):
    random = np.random.default_rng(1)
    used = random.random(60) < 0.6
    used[50:] = False
    names = np.arange(60)
    kept, other = names.copy(), names * 2
    last = close_gaps((kept, other), used, spare)
    full = np.flatnonzero(used)
    if full[-1] + 1 <= full.size + spare:
        assert last == full[-1] + 1
        np.testing.assert_array_equal(kept, names)
        return
    assert last == full.size
    np.testing.assert_array_equal(kept, names[np.argsort(~used, kind="stable")])
    np.testing.assert_array_equal(other, kept * 2)


def test_no_grain_needs_no_slot():
    assert close_gaps((), np.zeros(5, np.bool_), 2) == 0
