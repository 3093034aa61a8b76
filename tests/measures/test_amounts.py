"""How much sand there is and how high it stands."""

import numpy as np

from barchan.measures import bare_fraction, highest_stack, stack_volume

SAND = np.array([[0, 1, 2, 0], [5, 0, 3, 1]], np.int32)


def test_the_highest_stack_is_counted_in_slabs():
    assert highest_stack(SAND) == 5


def test_bare_cells_are_counted_over_all_cells():
    assert bare_fraction(SAND) == 3 / 8


def test_volume_is_slabs_times_what_a_slab_measures():
    assert stack_volume(SAND, slab_height=0.5, cell_size=4.0) == 12 * 0.5 * 16


def test_volume_is_exact_where_32_bits_would_overflow():
    assert stack_volume(np.full((100, 100), 10**6, np.int32), 1.0, 1.0) == 10**10
