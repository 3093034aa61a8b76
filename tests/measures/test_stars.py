"""Arms lead away from summits; slopes are measured by height."""

import numpy as np
import pytest

from barchan.measures.stars import summits


def star(arms, row=48, column=48, size=96, height=6.0):
    """A peak with ridges at even angles, which fall away at 45 degrees along and fast across."""
    surface = np.zeros((size, size))
    north = (np.arange(size) - row + size / 2) % size - size / 2
    east = (np.arange(size) - column + size / 2) % size - size / 2
    for k in range(arms):
        angle = 2 * np.pi * k / arms + 0.3
        along = east[None, :] * np.cos(angle) + north[:, None] * np.sin(angle)
        across = -east[None, :] * np.sin(angle) + north[:, None] * np.cos(angle)
        ridge = height * (1 - np.abs(along) / 40) - np.abs(across)
        surface = np.maximum(surface, np.where(along > 0, ridge, 0.0))
    return surface


@pytest.mark.parametrize("arms", [2, 3, 4, 5])
@pytest.mark.parametrize("place", [(48, 48), (2, 90)])
def test_a_star_has_as_many_arms_as_it_was_made_with(arms, place):
    found = summits(star(arms, *place), 1.0)
    assert found[0].arms == arms
    assert abs(found[0].row - place[0]) <= 2
    assert abs(found[0].column - place[1]) <= 2


def test_a_cone_has_one_summit_and_its_slope_at_the_top_and_at_the_foot():
    north, east = np.mgrid[:128, :128] - 64
    cone = np.maximum(8.0 - 0.5 * np.hypot(north, east), 0.0)
    (summit,) = summits(cone, 1.0)
    assert summit.arms == 0
    assert summit.top_slope == pytest.approx(np.degrees(np.arctan(0.5)), abs=3.0)


def test_a_peak_steeper_at_its_top_is_told():
    north, east = np.mgrid[:128, :128] - 64
    radius = np.hypot(north, east)
    peak = np.where(radius < 8, 7 - 0.5 * radius, np.maximum(3 - 0.15 * (radius - 8), 0.0))
    (summit,) = summits(peak, 1.0)
    assert summit.top_slope > 20 > 10 > summit.foot_slope


def test_a_flat_bed_has_no_summits():
    assert summits(np.zeros((32, 32)), 1.0) == []


def test_a_summit_beside_an_open_edge_is_left_out():
    field = star(3, row=4)
    assert len(summits(field, 1.0)) == 1
    assert summits(field, 1.0, (False, True)) == []
