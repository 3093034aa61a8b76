"""Bound and mean of mesh cells, as a whole and about what changed."""

import numpy as np
import pytest

from barchan.bed import Bed
from barchan.grains.bed import GrainGround
from barchan.kernels.grains import surface
from barchan.kernels.grains.surface import renew_mesh
from barchan.lattice import Lattice
from barchan.models import model
from tests.kernels.called import from_python

beyond = from_python(surface.beyond)
note_stale, renew_stale = from_python(surface.note_stale), from_python(surface.renew_stale)


def ground_of(shape, boundary):
    lattice = Lattice(
        rows=shape[0],
        columns=shape[1],
        cell_size=0.01,
        slab_height=1e-3,
        boundary_x=boundary,
        boundary_y=boundary,
    )
    random = np.random.default_rng(2)
    bed = Bed(lattice, np.zeros(shape), random.integers(0, 30, shape))
    ground = GrainGround(model("ripples").Parameters(), bed)
    ground.arrays.shelter_surface[:] = ground.arrays.height + random.random(lattice.cells).astype(np.float32)
    renew_mesh(ground.arrays)
    return ground, random


def mesh(ground):
    """The highest corner and the mean shelter surface of each mesh cell, one after the other."""
    height, shelter, cols = ground.arrays.height, ground.arrays.shelter_surface, ground.arrays.grid.cols
    found = []
    for row in range(ground.arrays.grid.rows):
        for col in range(cols):
            north, east = beyond(row, col, ground.arrays.grid)
            sw, se, nw, ne = (r * cols + c for r in (row, north) for c in (col, east))
            mean = np.float32(0.25) * ((shelter[sw] + shelter[se]) + (shelter[nw] + shelter[ne]))
            found.append((height[[sw, se, nw, ne]].max(), mean))
    return np.array(found).T


def renew_changed(ground, row, about):
    """Renew the mesh where stacks changed in a row, and in as many about it."""
    note_stale(row, about, about, ground.arrays)
    rows = ground.arrays.grid.rows
    for first, last in ((rows // 2, rows), (0, rows // 2)):
        renew_stale(first, last, ground.arrays)
    assert not ground.arrays.stale.any()


@pytest.mark.parametrize("boundary", ["periodic", "open"])
@pytest.mark.parametrize("shape", [(8, 8), (8, 11), (9, 13)])
def test_bounds_and_means_follow_the_surface(shape, boundary):
    ground, random = ground_of(shape, boundary)
    np.testing.assert_array_equal((ground.arrays.top, ground.arrays.base), mesh(ground))
    rows, cols = shape
    for cell in range(rows * cols):
        ground.arrays.height[cell] = ground.arrays.shelter_surface[cell] = random.random()
        renew_changed(ground, cell // cols, 0)
        np.testing.assert_array_equal((ground.arrays.top, ground.arrays.base), mesh(ground))


@pytest.mark.parametrize("boundary", ["periodic", "open"])
@pytest.mark.parametrize("shape", [(8, 8), (8, 11), (9, 13)])
def test_a_patch_renews_all_that_it_touches(shape, boundary):
    ground, random = ground_of(shape, boundary)
    rows, cols = shape
    for cell in range(rows * cols):
        row, col = cell // cols, cell % cols
        about = [
            (row + r) % rows * cols + (col + c) % cols
            for r in (-1, 0, 1)
            for c in (-1, 0, 1)
            if boundary == "periodic" or (0 <= row + r < rows and 0 <= col + c < cols)
        ]
        ground.arrays.height[about] = random.random(len(about))
        renew_changed(ground, row, 1)
        np.testing.assert_array_equal((ground.arrays.top, ground.arrays.base), mesh(ground))
