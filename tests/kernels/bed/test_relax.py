"""Full relaxation: every slope holds afterwards, no sand is lost, and heaps stand straight."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.bed import Bed
from barchan.kernels.bed import relax
from barchan.lattice import Lattice
from barchan.slabs.parameters import SlabParameters
from tests.kernels.slabs.test_step import PlainSlabs


def steepest_steps(elevation, periodic_x, periodic_y):
    """The largest step between face neighbours and between corner neighbours."""

    def step(dr, dc):
        moved = np.roll(elevation, (dr, dc), (0, 1))
        kept = np.ones(elevation.shape, bool)
        if not periodic_y:
            kept[: max(dr, 0)] = False
        if not periodic_x:
            kept[:, : max(dc, 0)] = False
            kept[:, elevation.shape[1] + min(dc, 0) :] = False
        return np.abs(elevation - moved)[kept].max(initial=0)

    return max(step(1, 0), step(0, 1)), max(step(1, 1), step(1, -1))


@given(
    st.integers(0, 2**32),
    st.sampled_from(["von_neumann", "moore"]),
    st.sampled_from(["face", "geometric", 3]),
    st.sampled_from(["before", "after"]),
    st.sampled_from(["periodic", "open"]),
    st.sampled_from(["periodic", "open"]),
)
def test_every_slope_holds_after_settling(seed, neighbourhood, corner_limit, test, boundary_x, boundary_y):
    lattice = Lattice(rows=9, columns=14, boundary_x=boundary_x, boundary_y=boundary_y)
    parameters = SlabParameters(neighbourhood=neighbourhood, corner_limit=corner_limit, repose_test=test)
    sand = np.random.default_rng(seed).integers(0, 40, lattice.shape)
    bed = Bed(lattice, np.zeros(lattice.shape), sand)
    PlainSlabs(parameters, lattice).relax(bed)
    face, corner = steepest_steps(bed.sand, boundary_x == "periodic", boundary_y == "periodic")
    assert face <= parameters.face_limit(lattice)
    if neighbourhood == "moore":
        assert corner <= parameters.corner_step_limit(lattice)
    assert bed.units == sand.sum()
    assert bed.sand.min() >= 0


@given(st.integers(0, 2**32))
def test_only_sand_slides_on_steep_ground(seed):
    """No sand stands too steep over a neighbour's surface, though bare rock may."""
    lattice = Lattice(rows=8, columns=12)
    random = np.random.default_rng(seed)
    ground = random.random(lattice.shape) * 10
    bed = Bed(lattice, ground, random.integers(0, 8, lattice.shape))
    before = bed.units
    PlainSlabs(SlabParameters(), lattice).relax(bed)
    assert bed.units == before
    np.testing.assert_array_equal(bed.ground, ground)
    surface = bed.elevation / lattice.thickness
    for axis in (0, 1):
        for shift in (1, -1):
            drop = surface - np.roll(surface, shift, axis)
            assert drop[bed.sand > 0].max(initial=0) <= 2 + 1e-5


def test_a_settled_bed_is_left_alone():
    lattice = Lattice(rows=8, columns=12)
    bed = Bed(lattice, np.zeros(lattice.shape), np.random.default_rng(1).integers(3, 6, lattice.shape))
    before = bed.sand.copy()
    assert PlainSlabs(SlabParameters(), lattice).relax(bed) == 0
    np.testing.assert_array_equal(bed.sand, before)


@pytest.mark.parametrize("neighbourhood", ["von_neumann", "moore"])
def test_a_tower_settles_to_a_heap_about_its_place(neighbourhood):
    lattice = Lattice(rows=41, columns=41)
    sand = np.zeros(lattice.shape, np.int32)
    sand[20, 20] = 3000
    bed = Bed(lattice, np.zeros(lattice.shape), sand)
    PlainSlabs(SlabParameters(neighbourhood=neighbourhood), lattice).relax(bed)
    rows, cols = np.mgrid[0:41, 0:41]
    assert np.average(rows, weights=bed.sand) == pytest.approx(20, abs=0.1)
    assert np.average(cols, weights=bed.sand) == pytest.approx(20, abs=0.1)


def test_only_what_a_change_upsets_slides():
    lattice = Lattice(rows=20, columns=20)
    sand = np.zeros(lattice.shape, np.int32)
    sand[5, 5] = sand[15, 15] = 9
    bed = Bed(lattice, np.zeros(lattice.shape), sand)
    where = np.zeros(lattice.shape, bool)
    where[5, 5] = True
    PlainSlabs(SlabParameters(), lattice).relax(bed, where)
    assert bed.sand[5, 5] < 9
    assert bed.sand[15, 15] == 9


@pytest.mark.parametrize("boundary", ["periodic", "open"])
@pytest.mark.parametrize("ground", [0.0, 3.0])
def test_a_tower_of_sand_relaxes_in_work_that_does_not_grow_with_its_height(ground, boundary, monkeypatch):
    """The work is the number of slides; a tower 64 times as high takes 64 times as many slabs to other cells.

    Slab by slab it would take more than 64 times as many slides. Halving an excess takes log2(64) = 6 slides
    more for each one of the low tower, where the sand spreads over the same cells: the whole field. Before
    that each tower slides slab by slab, 256 slides for each cell.
    """
    lattice = Lattice(rows=15, columns=17, boundary_x=boundary, boundary_y=boundary)
    rock = np.zeros(lattice.shape)
    rock[3, 4] = ground
    parameters = SlabParameters(neighbourhood="moore")

    def relaxed(height):
        sand = np.zeros(lattice.shape, np.int32)
        sand[7, 8] = height
        bed, slides = Bed(lattice, rock, sand), []

        def counting(*arguments):
            progress = some(*arguments)
            slides.append(progress[2])
            return progress

        monkeypatch.setattr(relax, "_relax_some", counting)
        PlainSlabs(parameters, lattice).relax(bed)
        face, corner = steepest_steps(bed.sand + rock / lattice.thickness, *2 * [boundary == "periodic"])
        assert bed.units == height
        assert ground or (face <= parameters.face_limit(lattice))
        assert ground or (corner <= parameters.corner_step_limit(lattice))
        return slides[-1]

    some = relax._relax_some
    low, high = relaxed(10_000), relaxed(640_000)
    assert high <= 7 * low
