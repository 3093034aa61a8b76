"""Territories: the order of what meets is kept, and so are the bits."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numba import njit

import barchan
from barchan.kernels.bed.state import Grid
from barchan.kernels.core import threads as thread_pool
from barchan.kernels.grains import iterations as grain_iterations
from barchan.kernels.grains import territories as territory
from barchan.simulation import Simulation


@njit
def share(rows, cols, reach, stamp, grid, territories, order):
    """Note who does which entry when; the number that is done."""
    done = 0
    number = territories.marks.shape[0]
    for part in range(number):
        territory.enter(part, territories)
        for k in range(rows.size):
            if territory.is_mine(
                k * territory.KINDS, rows[k], cols[k], reach[k], part, stamp, grid, territories
            ):
                order[done] = k
                done += 1
    for k in range(rows.size):
        if territory.is_mine(
            k * territory.KINDS, rows[k], cols[k], reach[k], number, stamp, grid, territories
        ):
            order[done] = k
            done += 1
    return done


def reached(row, col, reach, shape, wraps):
    cells = set()
    for r in range(row - reach, row + reach + 1):
        for c in range(col - reach, col + reach + 1):
            inside = all(w or 0 <= at < size for at, size, w in zip((r, c), shape, wraps, strict=True))
            if inside:
                cells.add((r % shape[0], c % shape[1]))
    return cells


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_each_is_done_once_and_after_all_earlier_ones_that_it_meets(data):
    shape = data.draw(st.tuples(st.integers(4, 20), st.integers(24, 60)))
    if data.draw(st.booleans()):
        shape = shape[::-1]
    wraps = data.draw(st.tuples(st.booleans(), st.booleans()))
    random = np.random.default_rng(data.draw(st.integers(0, 2**32)))
    count = 60
    rows, cols = random.integers(0, shape[0], count), random.integers(0, shape[1], count)
    reach = random.choice([1, 1, 2, 3, 9], count)
    grid = Grid(*shape, wraps[1], wraps[0])
    least = territory.LEAST_WIDTH
    territory.LEAST_WIDTH = 12
    try:
        territories = territory.territories_of(grid, data.draw(st.integers(2, 4)), count, 8)
    finally:
        territory.LEAST_WIDTH = least
    order = np.zeros(count, np.int64)
    for stamp in (1, 2):
        territories.put_off[:] = 0
        assert share(rows, cols, reach, np.int32(stamp), grid, territories, order) == count
        assert sorted(order) == list(range(count))
        places = np.argsort(order)
        boxes = [reached(*at, shape, wraps) for at in zip(rows, cols, reach, strict=True)]
        for late in range(count):
            for early in range(late):
                if boxes[early] & boxes[late]:
                    assert places[early] < places[late]


def test_a_territory_is_at_least_so_wide_and_they_leave_nothing_out():
    for threads, columns, number in ((2, 256, 2), (8, 256, 4), (3, 100, 1), (16, 1024, 16)):
        bounds = territory.territories_of(Grid(64, columns, True, True), threads, 1, 8).bounds
        assert (bounds[0], bounds[-1], bounds.size) == (0, columns, number + 1)
        assert all(east - west >= territory.LEAST_WIDTH for west, east in pairwise(bounds)) or number == 1


@pytest.mark.parametrize(
    "changes",
    [
        {"wind__direction": 230.0},
        {"lattice__boundary_x": "open", "lattice__boundary_y": "open", "model__wind_speed": 14.0},
        {"wind__direction": 100.0, "lattice__rows": 72, "lattice__columns": 40},
    ],
)
def test_territories_that_pushed_grains_cross_give_the_bits_of_one(monkeypatch, changes):
    beds = []
    monkeypatch.setattr(thread_pool, "LEAST", 8)
    monkeypatch.setattr(territory, "LEAST_WIDTH", 20)
    shared = []
    whole = territory.territories_of

    def kept(*given):
        shared.append(whole(*given))
        return shared[-1]

    monkeypatch.setattr(grain_iterations, "MOST_BEYOND", np.inf)

    for threads in (1, 3):
        monkeypatch.setattr(thread_pool, "thread_count", lambda threads=threads: threads)
        monkeypatch.setattr(grain_iterations, "territories_of", kept)
        lattice = {"rows": 40, "columns": 64, "cell_size": 0.005, "slab_height": 0.15e-3 / 16}
        scenario = {"barchan": 5, "lattice": lattice, "sand": {"kind": "flat", "mean": 800}}
        scenario["wind"] = {"kind": "steady", "direction": 270.0}
        scenario["model"] = {"name": "ripples", "wind_speed": 12.0, "max_grains_per_cell": 4.0}
        scenario["model"]["entrainment"] = {"probability": 0.05}
        simulation = Simulation(barchan.load({**scenario, "run": {"steps": 8, "seed": 5}}, **changes))
        tally = simulation.advance(8)
        beds.append((simulation.bed.sand.copy(), simulation.model.pool.motion.copy(), tally))
    assert max(one.marks.shape[0] for one in shared) == 3
    assert beds[0][2] == beds[1][2]
    for one, other in zip(beds[0][:2], beds[1][:2], strict=True):
        np.testing.assert_array_equal(one, other)
