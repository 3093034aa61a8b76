"""How far impacts may reach, against following every way that a pushed grain may take."""

import numpy as np
import pytest
from scipy import ndimage

from barchan.kernels.bed.state import Grid
from barchan.kernels.grains import reach as reaching
from barchan.kernels.grains.air_state import BedStress
from barchan.kernels.grains.creep import FARTHEST
from barchan.kernels.grains.rules import Creep
from barchan.kernels.grains.state import Ground, Scale


def farthest(ustar, stress, threshold, grid):
    """The longest way of a pushed grain from each cell, by following every step that it may take."""
    rows, cols = ustar.shape
    known = np.zeros((rows, cols), int)
    for _ in range(FARTHEST):
        longer = np.zeros_like(known)
        for row in range(rows):
            for col in range(cols):
                if ustar[row, col] <= threshold:
                    continue
                x, y = stress[row, col]
                steps = [(int(np.sign(y)), int(np.sign(x)))]
                steps += [(int(np.sign(y)), 0)] if abs(x) < abs(y) else []
                steps += [(0, int(np.sign(x)))] if abs(y) < abs(x) else []
                ahead = []
                for step_row, step_col in steps:
                    r, c = row + step_row, col + step_col
                    if (grid.wrap_across or 0 <= r < rows) and (grid.wrap_along or 0 <= c < cols):
                        ahead.append(known[r % rows, c % cols])
                longer[row, col] = 1 + max(ahead, default=0)
        known = np.minimum(longer, FARTHEST)
    return known


@pytest.mark.parametrize("angle", [0.0, 30.0, 45.0, 90.0, 200.0, 300.0])
@pytest.mark.parametrize("sides", [(-1.0, -0.3, 0.0, 0.4, 1.0), (0.1, 0.2)])
@pytest.mark.parametrize("joined", [True, False])
def test_the_reach_of_impacts_covers_every_way_that_pushed_grains_may_take(angle, joined, sides):
    random, shape = np.random.default_rng(int(angle)), (9, 14)
    grid, ustar = Grid(*shape, joined, joined), random.random(shape)
    deflection = random.choice(sides, shape)
    wind = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    ones = np.ones(1)
    creep = Creep(ones, ones, np.array([0.35]), 0.6, *wind, 0.0)
    empty, cells = np.zeros(0, np.float32), shape[0] * shape[1]
    ground = Ground(
        sand=np.zeros(cells, np.int32),
        level=np.zeros(cells, np.int64),
        height=empty,
        shelter_surface=empty,
        top=empty,
        base=empty,
        stale=np.zeros(shape[0], np.uint8),
        grid=grid,
        scale=Scale(1, 1.0, 1.0, 1),
        bed_stress=BedStress(ustar.ravel(), deflection.ravel()),
    )
    ways = reaching.Ways(*np.zeros((len(reaching.Ways._fields), cells), np.uint8))
    reach = np.zeros(cells, np.uint8)
    reaching.find_reach(creep, ground, ways, reach)
    stress = np.stack((wind[0] - deflection * wind[1], wind[1] + deflection * wind[0]), axis=-1)
    course = farthest(ustar, stress, 0.35, grid)
    found = ways.course.reshape(shape)
    assert (found >= course).all()
    if (np.ptp(np.sign(stress), axis=(0, 1)) == 0).all():
        np.testing.assert_array_equal(found, course)
    about = ndimage.maximum_filter(found, 3, mode="wrap")
    np.testing.assert_array_equal(reach.reshape(shape), about + 2)
