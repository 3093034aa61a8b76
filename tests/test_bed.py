"""The lattice and the fields on it."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from barchan.bed import Bed
from barchan.fields import SAND, FieldInfo, LayerInfo
from barchan.lattice import Lattice


def bed_of(sand, **lattice):
    sand = np.asarray(sand)
    lattice = Lattice(rows=sand.shape[0], columns=sand.shape[1], **lattice)
    return Bed(lattice, np.zeros(sand.shape), sand)


@pytest.mark.parametrize(
    ("given_", "aspect", "thickness"),
    [
        ({}, 1 / 3, 1 / 3),
        ({"cell_size": 6.0}, 1 / 3, 2.0),
        ({"cell_size": 4.0, "slab_aspect": 0.25}, 0.25, 1.0),
        ({"cell_size": 4.0, "slab_height": 0.1}, 0.025, 0.1),
    ],
)
def test_a_slab_is_a_third_of_a_cell_high_unless_its_aspect_or_height_is_given(given_, aspect, thickness):
    lattice = Lattice(rows=2, columns=8, **given_)
    assert lattice.aspect == pytest.approx(aspect, rel=1e-12)
    assert lattice.thickness == pytest.approx(thickness, rel=1e-12)


def test_a_slab_cannot_have_both_an_aspect_and_a_height():
    with pytest.raises(ValidationError, match="give one of them"):
        Lattice(slab_aspect=0.3, slab_height=0.1)


@pytest.mark.parametrize(
    "given_", [{"rows": 0}, {"columns": 7}, {"cell_size": 0.0}, {"kind": "hexagonal"}, {"boundary_x": "wall"}]
)
def test_impossible_lattices_are_refused(given_):
    with pytest.raises(ValidationError):
        Lattice(**given_)


def test_one_row_and_eight_columns_are_enough():
    assert Lattice(rows=1, columns=8).shape == (1, 8)


def test_x_runs_east_over_columns_and_y_north_over_rows_through_cell_centres():
    lattice = Lattice(rows=2, columns=8, cell_size=10.0)
    assert lattice.x.tolist() == [5.0, 15.0, 25.0, 35.0, 45.0, 55.0, 65.0, 75.0]
    assert lattice.y.tolist() == [5.0, 15.0]
    assert lattice.cells == 16


def test_elevation_is_ground_plus_slabs_times_thickness():
    lattice = Lattice(rows=1, columns=8, slab_height=0.5)
    ground = np.arange(8.0)[None, :]
    sand = np.array([[0, 1, 2, 3, 0, 0, 0, 4]], np.int32)
    bed = Bed(lattice, ground, sand)
    assert bed.elevation.tolist() == [[0.0, 1.5, 3.0, 4.5, 4.0, 5.0, 6.0, 9.0]]


def test_the_total_of_slabs_is_exact_beyond_32_bits():
    assert bed_of(np.full((16, 24), 10**9)).units == 16 * 24 * 10**9


def test_a_bed_keeps_fields_of_its_own():
    sand = np.ones((2, 8), np.int32)
    bed = bed_of(sand)
    sand[0, 0] = 99
    frame = bed.frame()
    bed.sand[1, 1] = 50
    assert bed.sand[0, 0] == 1
    assert frame["sand"][1, 1] == 1


def test_a_field_of_another_shape_is_refused_by_name():
    bed = bed_of(np.zeros((2, 8), np.int32))
    with pytest.raises(ValueError, match=r"hardness has shape \(8, 2\), the lattice \(2, 8\)"):
        bed.add(FieldInfo("hardness", "float64", "-", "hardness of snow"), np.zeros((8, 2)))


def test_frames_carry_the_fields_that_are_declared_for_them_and_no_others():
    bed = bed_of(np.zeros((2, 8), np.int32))
    bed.add(FieldInfo("hardness", "float32", "-", "hardness of snow"), np.ones((2, 8)))
    bed.add(FieldInfo("scratch", "int8", "-", "work space", in_frames=False), np.ones((2, 8)))
    frame = bed.frame()
    assert set(frame) == {"ground", "sand", "hardness"}
    assert frame["hardness"].dtype == np.float32


def test_the_bed_of_a_frame_has_its_fields_without_what_frames_do_not_carry():
    bed = bed_of(np.arange(16).reshape(2, 8))
    hardness = FieldInfo("hardness", "float32", "-", "hardness of snow")
    scratch = FieldInfo("scratch", "int8", "-", "work space", in_frames=False)
    bed.add(hardness, np.full((2, 8), 0.5))
    bed.add(scratch, np.ones((2, 8)))
    seen = Bed.from_fields(bed.lattice, bed.frame(), [hardness, scratch])
    assert set(seen.declared) == {"ground", "sand", "hardness"}
    for name, values in seen.arrays.items():
        np.testing.assert_array_equal(values, bed.arrays[name])
        assert values.dtype == bed.arrays[name].dtype


@given(st.integers(1, 12), st.integers(8, 20), st.integers(0, 2**20), st.floats(0.001, 10))
def test_a_level_bed_stands_at_its_stack_everywhere(rows, columns, stack, height):
    bed = bed_of(np.full((rows, columns), stack), slab_height=height)
    assert bed.elevation.shape == (rows, columns)
    assert math.isclose(float(bed.elevation.min()), stack * height, rel_tol=1e-12)
    assert bed.elevation.min() == bed.elevation.max()


OLD = LayerInfo("old", "int32", "kg/m²", "snow that has hardened", mass=1.0)
FRESH = LayerInfo("fresh", "int32", "kg/m²", "snow that fell last", mass=1.0, height_field="height")
HEIGHT = FieldInfo("height", "int32", "µm", "thickness of the snow")


def snow_bed():
    """Two layers of mass: 3 and 2 kg/m² on each cell, 5 cm of snow together."""
    lattice = Lattice(rows=2, columns=8)
    old, fresh = np.full(lattice.shape, 3), np.full(lattice.shape, 2)
    bed = Bed(lattice, np.full(lattice.shape, 10.0), old, fresh, layers=(OLD, FRESH))
    bed.add(HEIGHT, np.full(lattice.shape, 50_000))
    return bed


def test_elevation_of_layers_of_a_mass_follows_from_their_height_and_not_from_their_count():
    bed = snow_bed()
    np.testing.assert_allclose(bed.depth, 0.05, rtol=1e-12)
    np.testing.assert_allclose(bed.elevation, 10.05, rtol=1e-12)
    assert bed.volume == pytest.approx(16 * 0.05)
    bed.arrays["height"] //= 2  # densified: the same mass, half as thick
    np.testing.assert_allclose(bed.depth, 0.025, rtol=1e-12)
    assert bed.units == 16 * 5


def test_units_are_laid_on_the_uppermost_layer_and_taken_from_the_top_down():
    bed = snow_bed()
    change = np.zeros(bed.lattice.shape, np.int64)
    change[0, 0], change[1, 1] = 4, -4
    bed.lay(change)
    assert (bed.arrays["old"][0, 0], bed.arrays["fresh"][0, 0]) == (3, 6)
    assert (bed.arrays["old"][1, 1], bed.arrays["fresh"][1, 1]) == (1, 0)
    assert (bed.stack[0, 0], bed.stack[1, 1]) == (9, 1)
    with pytest.raises(ValueError, match="more units are taken"):
        bed.lay(np.full(bed.lattice.shape, -6))
    assert bed.units == 16 * 5


def test_layers_of_different_quanta_do_not_lie_on_one_bed():
    lattice = Lattice(rows=2, columns=8)
    nothing = np.zeros(lattice.shape)
    with pytest.raises(ValueError, match="same quantum"):
        Bed(lattice, nothing, nothing, nothing, layers=(OLD, SAND))


def test_the_classes_of_a_layer_add_up_to_it():
    bed = bed_of([[3] * 8, [2] * 8])
    fine = LayerInfo("fine", "int32", "slabs", "", part_of="sand", class_value=1e-4, class_unit="m")
    coarse = LayerInfo("coarse", "int32", "slabs", "", part_of="sand", class_value=1e-3, class_unit="m")
    bed.add(fine, np.full(bed.lattice.shape, 2))
    bed.add(coarse, bed.sand - 2)
    assert [one.class_value for one in bed.classes_of("sand")] == [1e-4, 1e-3]
    assert bed.undivided() == []
    bed.arrays["fine"][0, 0] += 1
    assert bed.undivided() == ["sand"]


def test_a_bed_shows_its_size_its_layers_and_its_heights():
    assert repr(bed_of([[3] * 8, [6] * 8])) == (
        "<Bed of 2 × 8 cells of 1 m: 72 slabs of sand, elevation 1 to 2 m>"
    )
    assert repr(snow_bed()) == (
        "<Bed of 2 × 8 cells of 1 m: 48 kg/m² of old, 32 kg/m² of fresh, elevation 10.05 to 10.05 m; "
        "fields height>"
    )
    assert repr(Lattice(rows=2, columns=8)) == (
        "<Lattice of 2 × 8 cells of 1 m, slabs of 0.3333 m, periodic edges>"
    )
