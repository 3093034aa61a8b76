"""How far the nearest wall of ground is, against looking at every way one by one."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.bed import Bed
from barchan.kernels.bed.state import Grid
from barchan.kernels.slabs.obstacles import FARTHEST, clear_distance, hop_until_blocked, way_is_clear
from barchan.kernels.slabs.state import CELL
from barchan.lattice import Lattice
from barchan.models.momiji import Momiji
from barchan.slabs.arguments import build
from barchan.slabs.parameters import ActingRules, SlabParameters
from barchan.slabs.rules import Rules
from barchan.wind.frame import WindFrame


def cells_before_a_wall(ground, turn, grid, limit, corner_limit):
    """For each cell, how many a slab may come over before it could meet a wall: every way, step by step."""
    steps = [(0, 1, limit)] + [(turn, 0, limit), (turn, 1, corner_limit)] * (turn != 0)
    result = np.full(ground.shape, FARTHEST)
    for start in np.ndindex(ground.shape):
        reached = {start}
        for count in range(grid.rows + grid.cols):
            ways = [
                (here, place(here[0] + r, here[1] + c, grid), high)
                for here in reached
                for r, c, high in steps
            ]
            ways = [(here, there, high) for here, there, high in ways if there is not None]
            if any(ground[there] - ground[here] > high for here, there, high in ways):
                result[start] = count
                break
            reached = {there for _, there, _ in ways}
    return result


def place(row, col, grid):
    inside = 0 <= row < grid.rows or grid.wrap_across, 0 <= col < grid.cols or grid.wrap_along
    return (row % grid.rows, col % grid.cols) if all(inside) else None


@settings(max_examples=60, deadline=None)
@given(
    *(st.integers(1, 6), st.integers(1, 9), st.booleans(), st.booleans()),
    *(st.sampled_from([-1, 0, 1]), st.sampled_from([0.02, 0.1, 0.5]), st.integers(0, 2**32)),
)
def test_nearest_wall_is_the_one_that_a_walk_along_every_way_finds(
    rows, cols, along, across, turn, share, seed
):
    random = np.random.default_rng(seed)
    ground = np.where(random.random((rows, cols)) < share, random.integers(0, 6, (rows, cols)), 0)
    lattice = Lattice(rows=8, columns=8)
    parameters = SlabParameters(corner_limit=3, path_test="hard")
    arguments = build(
        parameters, Rules(), lattice, WindFrame(0, turn * 0.3), 5.0, False, ActingRules("centre", "wind")
    )
    grid = Grid(rows, cols, along, across)
    slabs = random.integers(0, 9, (rows, cols)).astype(np.int32)
    surface = ((ground + slabs).astype(np.int64) << 20).ravel()
    clear = np.zeros(rows * cols, np.uint8)
    clear_distance(surface, slabs.ravel(), turn, grid, arguments.rules.repose, clear)
    face, corner = parameters.limits(lattice)
    np.testing.assert_array_equal(
        clear.reshape(rows, cols), cells_before_a_wall(ground, turn, grid, face, corner)
    )


@pytest.mark.parametrize("turn", [-1, 0, 1])
def test_ground_that_rises_gently_is_no_wall_anywhere(turn):
    ramp = np.tile(np.arange(12), (5, 1))
    arguments = build(
        *(SlabParameters(path_test="hard"), Rules(), Lattice(rows=5, columns=12), WindFrame(0, 0.0)),
        *(5.0, False, ActingRules("centre", "wind")),
    )
    surface = (ramp.astype(np.int64) << 20).ravel()
    clear = np.zeros(60, np.uint8)
    clear_distance(
        surface, np.zeros(60, np.int32), turn, Grid(5, 12, False, True), arguments.rules.repose, clear
    )
    assert (clear == FARTHEST).all()


@settings(max_examples=60, deadline=None)
@given(
    *(st.sampled_from(["hard", "surface"]), st.booleans(), st.booleans()),
    *(st.sampled_from([-0.7, -0.2, 0.0, 0.4, math.pi / 4]), st.integers(0, 2**32)),
)
def test_no_hop_over_a_way_that_is_clear_would_be_stopped(test, along, across, angle, seed):
    random = np.random.default_rng(seed)
    edges = ["open", "periodic"]
    lattice = Lattice(rows=9, columns=37, boundary_x=edges[along], boundary_y=edges[across])
    model = Momiji(Momiji.Parameters(path_test=test), lattice)
    ground = random.integers(1, 5, lattice.shape) * (random.random(lattice.shape) < 0.1) + 0.1
    bed = Bed(lattice, ground, random.integers(0, 3, lattice.shape).astype(np.int32))
    frame = WindFrame(0, angle)
    arguments, stacks = model._enter(bed, frame, 5.0, None)
    rules = arguments.rules
    obstacles = model._clear_distances.obstacles(bed.ground, rules, frame, stacks)
    surface, sand = stacks.surface, stacks.sand
    clear = 0
    for _ in range(100):
        start = int(random.integers(37 * CELL)), int(random.integers(9 * CELL))
        hop = random.uniform(-1, 1) * random.choice([1, 5, 35]) * CELL
        way = (*start, round(hop * math.cos(angle)), round(hop * math.sin(angle)))
        if way_is_clear(surface.ctypes.data, *way, rules.grid, obstacles):
            clear += 1
            assert not hop_until_blocked(surface, sand, *way, rules.grid, rules.repose, obstacles)[-1]
    assert clear > 0 or (test == "surface" and angle)
