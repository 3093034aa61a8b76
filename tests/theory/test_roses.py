"""Roses add up to the record they were made from."""

from dataclasses import replace

import numpy as np
import pytest

from barchan.theory.drift import drift_of, drift_potential
from barchan.theory.roses import sand_rose, sectors, wind_rose
from tests.theory.winds import record


def test_sectors_lie_about_the_points_of_the_compass():
    assert sectors(np.array([0.0, 11.2, 11.3, 348.7, 348.8, 90.0, 180.0, 270.0])).tolist() == [
        0, 0, 1, 15, 0, 4, 8, 12,
    ]  # fmt: skip


@pytest.mark.parametrize("count", [16, 36])
def test_a_sand_rose_holds_all_the_drift(count):
    drift = drift_of([(10.0, 1.0), (355.0, 2.0), (180.0, 4.0)])
    rose = sand_rose(drift, count)
    assert rose.shape == (count,)
    assert rose.sum() == drift.total
    assert rose[count // 2] == 4


def test_a_wind_rose_gives_shares_of_the_time_by_speed_and_the_calms():
    winds = record([0.0, 3.0, 5.0, 20.0], [0.0, 90.0, 90.0, 180.0], hours=[4, 3, 2, 1])
    table, calms, unknown = wind_rose(winds, (5.0, 10.0))
    assert (calms, unknown) == (pytest.approx(0.4), 0.0)
    assert table[4].tolist() == pytest.approx([0.3, 0.2, 0])
    assert table[8].tolist() == pytest.approx([0, 0, 0.1])
    assert table.sum() + calms == pytest.approx(1)


def even(step, speed=10.0):
    """A wind as often from every multiple of a step (degrees)."""
    ways = np.arange(0.0, 360.0, step)
    return replace(record(np.full(len(ways), speed), ways), direction_width=step)


@pytest.mark.parametrize("count", [8, 16, 36, 18])
@pytest.mark.parametrize("step", [10.0, 22.5, 45.0])
def test_winds_reported_in_steps_that_are_equally_frequent_have_equal_petals(step, count):
    table, _, _ = wind_rose(even(step), (5.0, 8.0), count)
    np.testing.assert_allclose(table.sum(axis=1), 1.0 / count, rtol=1e-9)
    rose = sand_rose(drift_potential(even(step)), count)
    np.testing.assert_allclose(rose, rose.sum() / count, rtol=1e-9)
    assert rose.sum() == pytest.approx(drift_potential(even(step)).total)
