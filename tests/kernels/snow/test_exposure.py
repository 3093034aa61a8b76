"""Exposure to abrasion: how far a cell stands out of the bed that the wind comes over."""

import numpy as np
import pytest
from numba import njit

from barchan.kernels.bed.state import Grid
from barchan.kernels.snow import poll
from barchan.kernels.snow.state import UPWIND, Giving, Pack

HEIGHT = 30_000
"""Height (µm) of the saltation layer."""


@njit
def exposures(giving, pack, grid, row, col, count):
    here = pack.surface[row * grid.cols + col]
    total = 0.0
    for number in range(count):
        state = np.uint64(number) * np.uint64(0x9E3779B97F4A7C15)
        total += poll.exposure(giving, pack, grid, row, col, here, state)
    return total / count


def mean_exposure(slope, tangent, turn):
    """Mean exposure of a cell of an even slope (µm a cell, downwind and across), of an oblique wind."""
    rows, cols = 9, 9
    along, across = slope
    row, col = np.mgrid[0:rows, 0:cols]
    surface = (1_000_000 + along * col + across * row).astype(np.int32).ravel()
    none = np.zeros(rows * cols, np.int64)
    pack = Pack(surface, none.astype(np.int32), none, none.reshape(-1, 1), none.astype(np.uint8))
    giving = Giving(True, HEIGHT, UPWIND + turn, 0.0, 0.5, round(tangent * 2**32))
    return exposures(giving, pack, Grid(rows, cols, True, True), 4, 4, 40_000)


def test_a_face_towards_the_wind_is_exposed_and_one_from_it_is_not():
    """Rising 3 mm a cell: of twenty draws eighteen look at cells 3 mm lower, two at cells beside."""
    assert mean_exposure((3000, 0), 0.0, 1) == pytest.approx(0.1 * 18 / 20, abs=0.002)
    assert mean_exposure((-3000, 0), 0.0, 1) == 0.0


def test_higher_faces_than_the_saltation_layer_are_exposed_no_more():
    assert mean_exposure((90_000, 0), 0.0, 1) == pytest.approx(18 / 20, abs=0.01)


@pytest.mark.parametrize("turn", [1, -1])
def test_under_an_oblique_wind_faces_towards_it_are_exposed(turn):
    """A wind at 45 degrees comes over the corner; faces that rise along it are exposed, across it little.

    Upwind is the corner, 6 mm lower where the bed rises 3 mm a cell both ways: sixteen draws of 6 mm, one
    each of 3 mm to either side, and two beside that are level. Across the wind the corner is level, and of
    those aside one is 3 mm, of those beside one is 6 mm lower.
    """
    towards = mean_exposure((3000, 3000 * turn), 1.0, turn)
    assert towards == pytest.approx((16 * 0.2 + 2 * 0.1) / 20, abs=0.003)
    across = mean_exposure((3000, -3000 * turn), 1.0, turn)
    assert across == pytest.approx((0.1 + 0.2) / 20, abs=0.002)
    assert mean_exposure((-3000, -3000 * turn), 1.0, turn) == 0.0
