"""Ripples lie on the dune's sand, in the wind, and nowhere else."""

import numpy as np
import pytest

from barchan.entry import simulate
from barchan.errors import BarchanError
from barchan.figures.composition import finer, laid_over
from barchan.figures.maps import relief_map
from tests.tiny import COLUMNS, ROWS, tiny

FACTOR = 4
DEEP = 30
"""Slabs much deeper than the ripples."""
SPACING = 8
"""Fine cells from crest to crest: whole waves on the fine field."""


def waves(columns=FACTOR * COLUMNS):
    """Ripples of 0.2 m across a west wind."""
    return np.tile(0.1 * np.sin(2 * np.pi * np.arange(columns) / SPACING), (3, 1))


def roughness(frame):
    """Fine relief (m) beside what a few cells' mean leaves."""
    sand = frame["elevation"].values
    return np.abs(sand - (np.roll(sand, SPACING // 2, 1) + np.roll(sand, -SPACING // 2, 1)) / 2)


def test_deep_flat_sand_in_the_wind_carries_the_ripples_whole(painted):
    frame, scenario = painted(DEEP)
    fine, composed = laid_over(frame, scenario, waves(), FACTOR)
    assert composed.lattice.shape == (FACTOR * ROWS, FACTOR * COLUMNS)
    assert composed.lattice.cell_size * FACTOR == scenario.lattice.cell_size
    expected = DEEP * scenario.lattice.thickness + np.broadcast_to(waves()[0], composed.lattice.shape)
    np.testing.assert_allclose(fine["elevation"].values, expected, atol=composed.lattice.thickness)
    np.testing.assert_allclose(
        fine["elevation"].values, fine["ground"] + fine["sand"] * composed.lattice.thickness
    )


def test_bare_ground_stays_bare_and_at_its_height(painted):
    sand = np.zeros((ROWS, COLUMNS), int)
    sand[4:8, 4:8] = DEEP
    frame, scenario = painted(sand, ground={"kind": "ramp", "height": 0.0})
    fine, _ = laid_over(frame, scenario, waves(), FACTOR, smoothing=0.5)
    far = fine["sand"].values[12 * FACTOR :, 12 * FACTOR :]
    assert (far == 0).all()
    assert fine["sand"].values[6 * FACTOR, 6 * FACTOR] > 0


def test_ripples_are_lower_on_sand_thinner_than_they_are_and_leave_none_below_zero(painted):
    frame, scenario = painted(1, lattice__slab_aspect=0.05)
    fine, composed = laid_over(frame, scenario, waves(), FACTOR)
    depth = fine["sand"].values * composed.lattice.thickness
    assert depth.min() >= 0
    assert np.ptp(depth) == pytest.approx(0.2 * 0.05 / 0.2, abs=2 * composed.lattice.thickness)


def test_the_lee_of_a_ridge_carries_none(painted):
    sand = np.full((ROWS, COLUMNS), DEEP)
    sand[:, 6:9] = DEEP + 9
    frame, scenario = painted(sand)
    fine, _ = laid_over(frame, scenario, waves(), FACTOR, smoothing=0.5)
    lee = roughness(fine)[:, 14 * FACTOR : 18 * FACTOR]
    windward = roughness(fine)[:, FACTOR : 3 * FACTOR]
    assert lee.max() < 0.02 < 0.1 < windward.max()


def test_a_frame_of_a_run_can_be_composed_and_drawn():
    scenario = tiny(run__steps=20)
    fine, composed = laid_over(simulate(scenario).isel(step=-1), scenario, waves(50), 3)
    assert "with ripples" in composed.title
    assert float(fine["elevation"].min()) >= 0
    assert relief_map(fine, composed).axes


def test_without_relief_the_dune_is_only_finer(painted):
    frame, scenario = painted(DEEP)
    fine, composed = laid_over(frame, scenario, np.zeros((2, 2)), 2)
    np.testing.assert_allclose(
        fine["elevation"].values, DEEP * scenario.lattice.thickness, atol=composed.lattice.thickness
    )


def test_a_factor_below_one_is_refused(painted):
    with pytest.raises(BarchanError, match="factor is 0"):
        laid_over(*painted(DEEP), waves(), 0)


@pytest.mark.parametrize("order", [1, 3])
@pytest.mark.parametrize("periodic", [(True, True), (False, True), (False, False)])
def test_fine_cells_have_the_mean_of_the_coarse_ones_about_them(order, periodic):
    """A plane stays a plane inside; a wave over joined edges stays a wave."""
    row, col = np.mgrid[0:24, 0:32].astype(float)
    field = np.sin(2 * np.pi * col / 32) if all(periodic) else 3 * row + 2 * col
    fine = finer(field, 3, periodic, order)
    middles = fine[1::3, 1::3]
    inside = (slice(6, -6), slice(6, -6))
    np.testing.assert_allclose(middles[inside], field[inside], atol=1e-4)
    if all(periodic):
        np.testing.assert_allclose(
            fine[0], np.sin(2 * np.pi * ((np.arange(96) + 0.5) / 3 - 0.5) / 32), atol=6e-3
        )
