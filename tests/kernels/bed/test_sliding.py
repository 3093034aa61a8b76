"""Slabs that slide to a neighbour drawn by the steps: on a plane they go straight down the slope."""

import numpy as np
import pytest

from barchan.kernels.bed.sliding import drawn_downslope
from barchan.kernels.bed.state import DOWN, DOWNSLOPE, UP, UPSLOPE, Grid, Stacks, repose_rule
from barchan.lattice import HEX_ROWS, Lattice
from barchan.slabs.neighbours import neighbour_groups, order_table
from barchan.slabs.parameters import SlabParameters
from tests.kernels.called import from_python

SIZE, MIDDLE = 10, (4, 4)
DRAWS = [np.uint64(k * (2**64 // 3000) + 2**50) for k in range(3000)]

STEPS = {
    "square": np.array([(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)], float),
    "hex": np.array(
        [(1, 0), (0, 0), (-1, 0), (0, 0)]
        + [(x, y * HEX_ROWS) for x, y in ((0.5, 1), (-0.5, 1), (-0.5, -1), (0.5, -1))],
        float,
    ),
}
"""Where the neighbours lie (cells, along and across), in the kernels' order."""


def plane(kind, rises):
    """Whole heights that rise by so many slabs from cell to cell along the rows and to the next row."""
    row, col = np.indices((SIZE, SIZE))
    along = col - row // 2 - 4 * SIZE if kind == "hex" else col
    heights = rises[0] * along + rises[1] * row
    return (heights - heights.min()).astype(np.int32).ravel()


def gradient(kind, rises):
    """Rise (slabs) over a cell along and across."""
    if kind == "hex":  # the next row's cell lies half a cell farther along
        return np.array([rises[0], (rises[1] - rises[0] / 2) / HEX_ROWS])
    return np.array(rises, float)


@pytest.mark.parametrize(
    ("kind", "neighbourhood"), [("square", "von_neumann"), ("square", "moore"), ("hex", "von_neumann")]
)
@pytest.mark.parametrize("rises", [(6, 3), (-6, 3), (2, -7), (-5, -5), (4, 0)])
@pytest.mark.parametrize("sign", [UP, DOWN])
def test_the_mean_slide_on_a_plane_is_straight_down_or_in_from_straight_above(
    kind, neighbourhood, rises, sign
):
    lattice = Lattice(kind=kind, rows=SIZE, columns=SIZE, boundary_x="open", boundary_y="open")
    groups = neighbour_groups(SlabParameters(neighbourhood=neighbourhood), lattice)
    orders = order_table(0.3, groups, True)
    repose = repose_rule(1, (2, 3), corners=neighbourhood == "moore", downslope=True)
    surface = plane(kind, rises)
    grid = Grid(SIZE, SIZE, False, False, kind == "hex")
    here = np.int64(surface[MIDDLE[0] * SIZE + MIDDLE[1]]) - sign
    order = UPSLOPE if sign == UP else DOWNSLOPE
    kernel = from_python(drawn_downslope)
    ways = [
        kernel(Stacks(surface, None), orders, order, *MIDDLE, here, sign, draw, grid, repose)
        for draw in DRAWS
    ]
    mean = STEPS[kind][ways].mean(axis=0)
    towards = sign * gradient(kind, rises)
    aside = (mean[0] * towards[1] - mean[1] * towards[0]) / np.hypot(*towards)
    assert mean @ towards > 0.0
    assert aside == pytest.approx(0.0, abs=2 * 8 / len(DRAWS))


def test_cells_without_sand_and_sand_that_plants_hold_give_nothing():
    surface = np.zeros(SIZE * SIZE, np.int64)
    surface[[45, 54, 43, 34]] = (8, 8, 8, 5)  # of the middle 44: ahead, above, behind, below
    sand = np.ones(SIZE * SIZE, np.int32)
    sand[45] = 0
    mobility = np.full(SIZE * SIZE, 100, np.int32)
    mobility[[43, 54]] = 0
    stacks = Stacks(surface, sand, mobility)
    groups = neighbour_groups(SlabParameters(), Lattice(rows=SIZE, columns=SIZE))
    repose = repose_rule(1, (2, 3), corners=False, downslope=True, stabilised=(8, 9), stabilised_below=0)
    grid = Grid(SIZE, SIZE, True, True)
    kernel, orders = from_python(drawn_downslope), order_table(0.0, groups, True)
    ways = [kernel(stacks, orders, UPSLOPE, *MIDDLE, np.int64(-1), UP, draw, grid, repose) for draw in DRAWS]
    # steps of 9 from the cells that plants hold exceed their limit of 8; sand below has a step of 6
    shares = {1: 8 / 21, 2: 8 / 21, 3: 5 / 21}
    assert set(ways) == set(shares)
    for way, share in shares.items():
        assert ways.count(way) / len(DRAWS) == pytest.approx(share, abs=2 / len(DRAWS))
    surface[[43, 54]] = 7  # steps of 8 stand there
    ways = [kernel(stacks, orders, UPSLOPE, *MIDDLE, np.int64(-1), UP, draw, grid, repose) for draw in DRAWS]
    assert set(ways) == {3}
