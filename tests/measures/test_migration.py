"""Migration is how far the surface moves in a step, to a fraction of a cell."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.measures import migration
from tests.measures.waves import COLUMNS, ROWS, hill, random_surface, sine

TENTH_OF_A_CELL = 0.1

drifts = st.floats(-2.5, 2.5)


def course(drift, count=5, seed=1):
    """A surface that drifts by a number of rows and columns from one frame to the next."""
    return [random_surface(seed, (drift[0] * k, drift[1] * k)) for k in range(count)]


@settings(max_examples=40)
@given(drifts, drifts, st.integers(0, 5))
def test_a_surface_that_drifts_is_followed_to_a_fraction_of_a_cell(rows, columns, seed):
    moved = migration([0, 10, 20, 30, 40], course((rows, columns), seed=seed))
    assert moved.x * 10 == pytest.approx(columns, abs=TENTH_OF_A_CELL)
    assert moved.y * 10 == pytest.approx(rows, abs=TENTH_OF_A_CELL)


@settings(max_examples=40)
@given(drifts, drifts)
def test_two_surfaces_are_enough(rows, columns):
    moved = migration([3, 4], course((rows, columns), count=2))
    assert moved.x == pytest.approx(columns, abs=TENTH_OF_A_CELL)
    assert moved.y == pytest.approx(rows, abs=TENTH_OF_A_CELL)


@pytest.mark.parametrize("shift", [(0, 3), (2, 0), (-3, 5), (7, -4)])
def test_whole_cells_are_followed_exactly(shift):
    first = random_surface(2)
    moved = migration([0, 1], [first, np.roll(first, shift, (0, 1))])
    assert (moved.y, moved.x) == pytest.approx(shift, abs=1e-6)
    assert moved.correlation == pytest.approx(1.0, abs=1e-9)


def test_what_stands_still_does_not_move():
    surface = random_surface(3)
    moved = migration([0, 5, 9], [surface] * 3)
    assert (moved.x, moved.y) == pytest.approx((0, 0), abs=1e-9)


def test_speed_is_per_step_however_frames_are_spaced():
    drift = (0.0, 0.3)
    steps = [0, 1, 4, 6, 10]
    surfaces = [random_surface(4, (drift[0] * s, drift[1] * s)) for s in steps]
    moved = migration(steps, surfaces)
    assert moved.x == pytest.approx(0.3, abs=0.01)
    assert moved.y == pytest.approx(0.0, abs=0.01)


def test_crests_are_not_mistaken_for_their_neighbours_over_long_lags():
    """Over the longest lag the wave moves by more than one wavelength."""
    shift = 4
    surfaces = [np.roll(sine(5, 0), shift * k, axis=1) for k in range(6)]
    assert migration(range(6), surfaces, lags=5).x == pytest.approx(shift, abs=1e-6)


HILLS = [(0.0, 1.3), (0.8, 0.0), (-0.6, 1.1), (0.25, -0.25)]


def hill_in_an_open_field(drift):
    """The migration of a hill that stays in the middle of an open field."""
    surfaces = [hill(24 + drift[0] * k, 40 + drift[1] * k) for k in range(4)]
    return migration(range(4), surfaces, (False, False))


@pytest.mark.parametrize("drift", HILLS)
def test_a_hill_in_the_middle_of_an_open_field_is_not_held_back_by_the_edges(drift):
    moved = hill_in_an_open_field(drift)
    assert (moved.y, moved.x) == pytest.approx(drift, rel=0.02, abs=0.001)


def test_only_joined_edges_are_crossed():
    surfaces = [hill(24, 77 + 2 * k) + hill(24, 77 + 2 * k - COLUMNS) for k in range(3)]
    moved = migration(range(3), surfaces, (False, True))
    assert moved.x == pytest.approx(2.0, abs=TENTH_OF_A_CELL)


@pytest.mark.parametrize(
    ("vector", "along"), [((1, 0), 3.0), ((0, 1), 4.0), ((0.6, 0.8), 5.0), ((-1, 0), -3.0)]
)
def test_speed_along_a_direction_is_a_projection(vector, along):
    moved = migration([0, 1], [random_surface(5), np.roll(random_surface(5), (4, 3), (0, 1))])
    assert moved.along(*vector) == pytest.approx(along, abs=1e-6)
    assert moved.speed == pytest.approx(5.0, abs=1e-6)


def stands_or_moves(level, periodic):
    """Migrations between a flat bed and others."""
    flat = np.full((ROWS, COLUMNS), level)
    pairs = [flat, flat], [flat, random_surface(1)], [random_surface(1), flat]
    return [migration([0, 1], pair, periodic) for pair in pairs]


@pytest.mark.parametrize("periodic", [(True, True), (False, False)])
@pytest.mark.parametrize("level", [0.0, 3.0])
def test_a_flat_bed_does_not_move(level, periodic):
    for moved in stands_or_moves(level, periodic):
        assert all(map(math.isnan, (moved.x, moved.y, moved.speed, moved.correlation)))


@pytest.mark.parametrize("periodic", [(True, True), (False, False)])
@pytest.mark.parametrize("slabs", [1, 4, 7])
def test_a_bed_of_whole_slabs_everywhere_does_not_move(slabs, periodic):
    for moved in stands_or_moves(slabs * 0.1, periodic):
        assert math.isnan(moved.x)


def test_one_surface_alone_does_not_move():
    assert math.isnan(migration([0], [random_surface(1)]).x)


def test_a_field_of_one_row_moves_along_it():
    first = sine(3, 0, (1, 64))
    moved = migration([0, 1], [first, np.roll(first, 2, axis=1)])
    assert (moved.x, moved.y) == pytest.approx((2.0, 0.0), abs=1e-6)


def test_surfaces_since_the_last_flat_one_are_compared():
    """Runs that start from level sand have a speed from their third frame on."""
    surfaces = [np.full((ROWS, COLUMNS), 3.0), *course((0.0, 1.5), count=3)]
    assert migration([0, 10, 20, 30], surfaces).x == pytest.approx(0.15, abs=0.01)


@pytest.mark.parametrize("cells", [(slice(10, 20), slice(30, 50)), (slice(0, 12), slice(0, 80))])
def test_unknown_cells_do_not_hold_waves_back(cells):
    surfaces = course((0.0, 1.5), count=4)
    for surface in surfaces:
        surface[cells] = np.nan
    moved = migration([0, 10, 20, 30], surfaces)
    assert (moved.x, moved.y) == pytest.approx((0.15, 0.0), abs=0.01)


def test_over_whole_cycles_only_the_net_shift_counts():
    """East by 6 cells and back by 4 in each cycle of 20 steps, looked at every 5."""
    places = [0.0, 3.0, 6.0, 4.0, 2.0, 5.0, 8.0, 6.0, 4.0]
    surfaces = [random_surface(3, (0.0, place)) for place in places]
    steps = list(range(0, 45, 5))
    assert migration(steps, surfaces, cycle=20.0).x == pytest.approx(0.1, abs=0.005)
    assert math.isnan(migration(steps[:4], surfaces[:4], cycle=20.0).x)


def test_surfaces_that_are_not_alike_are_not_followed():
    """Hills of 2 cells, smoothed over 2: correlations deviate by sqrt(2 pi 8 / 3840) = 0.11 from 0.

    The highest of 76 independent ones is about sqrt(2 ln 76) = 2.9 times as much, 0.34.
    """
    moved = migration([0, 10], [random_surface(1, size=2.0), random_surface(2, size=2.0)])
    assert math.isnan(moved.x)
    assert moved.correlation < 0.5


def test_a_tilted_plane_under_waves_in_an_open_field_does_not_hold_them_back():
    plane = np.add.outer(0.3 * np.arange(ROWS), 0.5 * np.arange(COLUMNS))
    waves = [random_surface(8, (0.0, 1.0 * k)) for k in range(4)]
    level = migration(range(4), waves, (False, False))
    tilted = migration(range(4), [wave + plane for wave in waves], (False, False))
    assert (tilted.x, tilted.y) == pytest.approx((level.x, level.y), abs=1e-6)
