"""Heights on cells of another size: means over larger cells, linear between smaller ones."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.ground.resampling import resampled
from barchan.lattice import Lattice


def test_a_coarse_cell_has_the_mean_of_the_cells_that_it_covers():
    """Waves nine cells long, on cells of ten: the mean of ten by ten, as numpy takes it over blocks."""
    fine = np.broadcast_to(np.sin(2 * np.pi * np.arange(480) / 9), (320, 480))
    blocks = fine.reshape(32, 10, 48, 10).mean(axis=(1, 3))
    coarse = resampled(fine, 10.0, 10.0, Lattice(rows=32, columns=48))
    np.testing.assert_allclose(coarse, blocks, atol=1e-12)
    assert coarse.std() < 0.1 * fine.std()


def test_a_cell_that_covers_part_of_others_has_the_mean_of_the_slope_between_them():
    """0, 1, 2, … on cells of 2.5: the value in their middle, but for half a cell of zero at the edge."""
    row = np.arange(20.0)[None, :]
    coarse = resampled(row, 1.0, 2.5, Lattice(rows=1, columns=8))
    np.testing.assert_allclose(coarse[0, :4], [2.0 / 2.5, 3.25, 5.75, 8.25])


@given(st.integers(0, 2**32), st.integers(6, 30), st.integers(9, 50))
def test_means_over_larger_cells_keep_the_volume(seed, rows, columns):
    fine = np.random.default_rng(seed).normal(size=(rows, columns))
    coarse = resampled(fine, rows / 5, columns / 8, Lattice(rows=5, columns=8))
    assert coarse.mean() == pytest.approx(fine.mean(), abs=1e-9)
    assert fine.min() <= coarse.min()
    assert coarse.max() <= fine.max()


@pytest.mark.parametrize("step", [0.25, 0.5, 1.0, 2.0, 3.3])
def test_a_plane_stays_a_plane_at_any_size(step):
    fine = 3.0 + 0.5 * np.arange(40)[:, None] - 0.25 * np.arange(60)
    lattice = Lattice(rows=10, columns=15)
    y = (np.arange(10) + 0.5) * step - 0.5
    x = (np.arange(15) + 0.5) * step - 0.5
    plane = 3.0 + 0.5 * y[:, None] - 0.25 * x
    inner = (slice(2, None), slice(2, None))
    np.testing.assert_allclose(resampled(fine, step, step, lattice)[inner], plane[inner])


def test_a_single_row_or_column_can_be_resampled():
    assert resampled(np.full((1, 1), 7.0), 0.1, 0.1, Lattice(rows=3, columns=8)).tolist() == [[7.0] * 8] * 3
