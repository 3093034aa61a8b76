"""Upright cylinders."""

import numpy as np
import pytest
from scipy.ndimage import label

from barchan.ground.cylinders import Cylinder, Cylinders
from barchan.lattice import Lattice
from barchan.streams import Stream

LATTICE = Lattice(rows=120, columns=160, cell_size=0.5)
STREAM = Stream(4, "ground")


def test_each_has_the_area_and_the_height_stated_and_is_bare():
    stems = [Cylinder(x=0.3, y=0.4, radius=6.0, height=3.0), Cylinder(x=0.7, y=0.6, radius=9.0, height=5.0)]
    ground = Cylinders(cylinders=stems)
    elevation, bare = ground.elevation(LATTICE, STREAM), ground.bare(LATTICE)
    np.testing.assert_array_equal(bare, elevation > 0)
    assert label(bare)[1] == 2
    for stem in stems:
        area = np.sum(elevation == stem.height) * LATTICE.cell_size**2
        assert area == pytest.approx(np.pi * stem.radius**2, rel=0.02)


def test_it_stands_where_it_is_stated():
    elevation = Cylinders(cylinders=[Cylinder(x=0.25, y=0.75, radius=4.0)]).elevation(LATTICE, STREAM)
    rows, columns = np.nonzero(elevation)
    assert LATTICE.x[columns].mean() == pytest.approx(0.25 * 80.0)
    assert LATTICE.y[rows].mean() == pytest.approx(0.75 * 60.0)


def test_where_two_overlap_the_higher_one_stands():
    low, high = Cylinder(radius=10.0, height=2.0), Cylinder(radius=5.0, height=7.0)
    for stems in ([low, high], [high, low]):
        elevation = Cylinders(cylinders=stems).elevation(LATTICE, STREAM)
        assert set(np.unique(elevation)) == {0.0, 2.0, 7.0}


@pytest.mark.parametrize("place", [(0.5, 0.5), (0.503, 0.497), (0.0, 1.0)])
def test_a_cylinder_thinner_than_a_cell_covers_one(place):
    stem = Cylinder(x=place[0], y=place[1], radius=1e-3)
    assert Cylinders(cylinders=[stem]).bare(LATTICE).sum() == 1


def test_a_cylinder_at_a_joined_edge_stands_on_both_sides():
    bare = Cylinders(cylinders=[Cylinder(x=0.0, y=0.5, radius=5.0)]).bare(LATTICE)
    assert bare[:, 0].any()
    np.testing.assert_array_equal(bare, bare[:, ::-1])


def test_none_leaves_level_ground():
    assert not Cylinders(cylinders=[]).elevation(LATTICE, STREAM).any()
