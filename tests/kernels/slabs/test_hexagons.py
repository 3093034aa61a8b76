"""On hexagons the compiled kernel equals the plain reference, which looks every cell up by its centre."""


import numpy as np
import pytest

from barchan.lattice import Lattice
from barchan.slabs.parameters import SlabParameters
from tests.kernels.slabs.test_step import EVERY_COMBINATION, PARAMETERS, PlainSlabs, assert_same, both, rough_bed

WINDS = [270.0, 240.0, 300.0, 210.0, 262.0, 225.0, 200.0, 330.0, 181.0, 359.0, 315.0]


@pytest.mark.parametrize("number", range(0, len(EVERY_COMBINATION), 3))
def test_kernel_equals_reference_on_hexagons_for_combinations_of_variants(number):
    variants = EVERY_COMBINATION[number]
    parameters = SlabParameters(**variants, band_rows=3, hop_length=[3.0, 4.0, 2.5][number % 5 % 3])
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
