"""Positions on joined edges, however far a slab hops."""

import pytest
from numba import njit

from barchan.kernels.slabs.hop import wrapped

CELL = 1 << 32


@njit
def wrap(place, size, joined):
    """Call the kernel's function from Python."""
    return wrapped(place, size, joined)


@pytest.mark.parametrize(
    ("cells", "size", "inside"),
    [
        (0.5, 1, 0.5),
        (1.0, 1, 0.0),
        (7.25, 8, 7.25),
        (8.25, 8, 0.25),
        (99_999.5, 8, 7.5),
        (-0.5, 8, 7.5),
        (-100_001.5, 3, 0.5),
    ],
)
def test_a_position_over_joined_edges_comes_back_after_whole_laps(cells, size, inside):
    """cells = inside + whole laps × size, worked out by hand."""
    assert wrap(int(cells * CELL), size, True) == int(inside * CELL)


@pytest.mark.parametrize("cells", [8.0, 100.0, -0.25, -100.0])
def test_a_position_over_an_open_edge_has_left(cells):
    assert wrap(int(cells * CELL), 8, False) == -1
