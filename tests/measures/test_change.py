"""Displacements and volumes between surveys whose change was made."""

import numpy as np
import pytest

from barchan.measures.change import budget, difference_noise, displacement_between
from tests.measures.waves import random_surface

SHAPE = (128, 160)


def test_a_surface_that_moved_as_a_whole_is_found_where_it_is():
    before = random_surface(3, shape=SHAPE)
    after = random_surface(3, drift=(2.3, -4.6), shape=SHAPE)
    found = displacement_between(before, after, (True, True))
    assert found.north.value == pytest.approx(2.3, abs=0.1)
    assert found.east.value == pytest.approx(-4.6, abs=0.1)
    assert found.windows >= 8
    assert found.north.error < 0.3


def test_the_error_covers_parts_that_move_at_different_speeds():
    slow, fast = (random_surface(3, drift=(0.0, drift), shape=SHAPE) for drift in (2.0, 4.0))
    after = np.concatenate([slow[:64], fast[64:]])
    found = displacement_between(random_surface(3, shape=SHAPE), after)
    # half of the windows at 2 and half at 4: a standard deviation of 1 between them
    assert found.east.error == pytest.approx(1.0 / np.sqrt(found.windows), rel=0.3)
    assert 2.0 < found.east.value < 4.0


def test_surfaces_that_have_nothing_in_common_have_not_moved():
    found = displacement_between(random_surface(3, shape=SHAPE), random_surface(4, shape=SHAPE))
    assert found.correlation < 0.5
    assert np.isnan(found.east.value)
    assert np.isnan(displacement_between(np.zeros(SHAPE), np.ones(SHAPE)).correlation)


def test_the_noise_of_a_change_is_found_under_dunes_that_moved():
    noise = np.random.default_rng(2).normal(0.0, 0.03, SHAPE)
    moved = random_surface(3, drift=(0, 3.0), shape=SHAPE, size=6.0) - random_surface(
        3, shape=SHAPE, size=6.0
    )
    assert difference_noise(20 * moved + noise) == pytest.approx(0.03, rel=0.1)


def test_a_block_that_was_moved_is_eroded_here_and_deposited_there():
    rng = np.random.default_rng(2)
    before, after = rng.normal(0.0, 0.01, (2, *SHAPE))
    before[20:40, 20:40] += 2.0
    after[80:100, 100:130] += 1.0
    found = budget(before, after, 4.0)
    assert found.noise == pytest.approx(0.01 * np.sqrt(2), rel=0.1)
    assert found.eroded.value == pytest.approx(20 * 20 * 2.0 * 4.0, rel=0.02)
    assert found.deposited.value == pytest.approx(20 * 30 * 1.0 * 4.0, rel=0.02)
    expected = (600 - 800) * 4.0
    assert abs(found.net.value - expected) < 3 * found.net.error
    cells = SHAPE[0] * SHAPE[1]
    assert found.net.error == pytest.approx(4.0 * np.sqrt(cells) * found.noise)
    assert found.area == 4.0 * cells


@pytest.mark.parametrize("seed", range(3))
def test_volumes_of_wide_dunes_that_moved_are_right_within_their_errors(seed):
    """Much of the change of gentle dunes is within a cell's noise; the truth is the change without noise."""
    north, east = 5.0 * np.mgrid[:128, :128]

    def dunes(moved):
        places = ((120, 150, 6), (300, 260, 8), (180, 420, 7), (430, 470, 5), (470, 150, 6), (330, 560, 6))
        return sum(
            h * np.exp(-((east - x - moved) ** 2 + (north - y) ** 2) / (2.0 * 28.0**2)) for x, y, h in places
        )

    truth = (dunes(15.0) - dunes(0.0)).clip(0.0).sum() * 25.0
    before, after = np.random.default_rng(seed).normal(0.0, 0.05, (2, *east.shape))
    found = budget(dunes(0.0) + before, dunes(15.0) + after, 25.0)
    for volume in (found.deposited, found.eroded):
        assert abs(volume.value - truth) < 3.0 * volume.error
        assert volume.error < 0.01 * truth


def test_noise_alone_deposits_nothing():
    before, after = np.random.default_rng(5).normal(0.0, 0.05, (2, *SHAPE))
    found = budget(before, after, 1.0)
    assert abs(found.deposited.value) < 3.0 * found.deposited.error


def test_a_common_offset_counts_for_every_cell():
    found = budget(np.zeros((10, 10)), np.full((10, 10), 0.1), 1.0, noise=0.0, offset=0.02)
    assert (found.net.value, found.net.error) == pytest.approx((10.0, 100 * 0.02))


def test_voids_of_either_survey_are_left_out():
    before, after = np.zeros((10, 10)), np.ones((10, 10))
    before[0], after[:, 0] = np.nan, np.nan
    assert budget(before, after, 1.0, noise=0.0).net.value == pytest.approx(81.0)


def test_surveys_of_other_frames_are_refused():
    with pytest.raises(ValueError, match="allowed: the same"):
        budget(np.zeros((3, 3)), np.zeros((3, 4)), 1.0)
    with pytest.raises(ValueError, match="allowed: the same"):
        displacement_between(np.zeros((3, 3)), np.zeros((3, 4)))
