"""Smoothing, other cells and closing keep the volume, the frame and the tiles; the side-car file says so."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from barchan.errors import ExportError
from barchan.export import Options, export
from barchan.export.source import changed
from tests.export import readers
from tests.export.scenes import CELL, COLUMNS, ROWS, SLAB, asymmetric, slabs

FIELDS = arrays(np.float64, st.tuples(st.integers(1, 9), st.integers(1, 9)), elements=st.floats(-1e3, 1e3))
EDGES = st.tuples(st.booleans(), st.booleans())


@pytest.fixture(scope="module")
def run():
    return asymmetric()


@given(FIELDS, EDGES, st.tuples(st.integers(1, 20), st.integers(1, 20)))
def test_the_mean_stays_on_any_number_of_cells(field, periodic, cells):
    made = changed(field, periodic, Options(cells=cells))
    assert made.shape == cells[::-1]
    assert made.mean() == pytest.approx(field.mean(), abs=1e-9 * (1 + np.abs(field).max()))
    assert made.min() >= field.min() - 1e-9
    assert made.max() <= field.max() + 1e-9


@given(FIELDS, EDGES, st.floats(0.1, 5))
def test_the_mean_stays_under_smoothing(field, periodic, width):
    made = changed(field, periodic, Options(smooth=width))
    assert made.mean() == pytest.approx(field.mean(), abs=1e-9 * (1 + np.abs(field).max()))


@given(FIELDS)
def test_closing_repeats_the_first_row_and_column(field):
    made = changed(field, (True, True), Options(close=True))
    np.testing.assert_array_equal(made[:-1, :-1], field)
    np.testing.assert_array_equal(made[-1], made[0])
    np.testing.assert_array_equal(made[:, -1], made[:, 0])


def test_yes_and_no_stay_yes_and_no():
    field = np.array([[True, False], [False, True]])
    made = changed(field, (True, True), Options(cells=(4, 4), smooth=1.0))
    assert made.dtype == bool
    np.testing.assert_array_equal(made, np.kron(field, np.ones((2, 2), bool)))


def test_volume_is_kept_in_what_another_program_reads(run, tmp_path):
    export(run, tmp_path / "dunes.tif", fields="depth", cells=(60, 42), smooth=1.5)
    with readers.rasterio.open(tmp_path / "dunes.tif") as file:
        area = abs(file.transform.a * file.transform.e)
        volume = file.read(1).astype(float).sum() * area
        assert file.bounds.right == pytest.approx(COLUMNS * CELL)
        assert file.bounds.top == pytest.approx(ROWS * CELL)
    assert volume == pytest.approx(slabs(10).sum() * SLAB * CELL**2, rel=1e-6)


def test_smoothing_removes_terraces(run, tmp_path):
    """Whole slabs leave most neighbours at one height; smoothed, hardly any are."""
    export(run, tmp_path / "steps.r32")
    export(run, tmp_path / "smooth.r32", smooth=1.5)
    level = [
        (np.diff(np.fromfile(tmp_path / f"{name}.r32", "<f4").reshape(ROWS, COLUMNS), axis=1) == 0).mean()
        for name in ("steps", "smooth")
    ]
    assert level[0] > 0.5
    assert level[1] < 0.1


def test_a_closed_mesh_joins_its_own_copy(run, tmp_path):
    export(run, tmp_path / "tile.glb", close=True)
    mesh = readers.trimesh.load(tmp_path / "tile.glb", force="mesh", process=False)
    assert np.ptp(mesh.vertices[:, 0]) == pytest.approx(COLUMNS * CELL)
    assert np.ptp(mesh.vertices[:, 2]) == pytest.approx(ROWS * CELL)
    heights = mesh.vertices.reshape(ROWS + 1, COLUMNS + 1, 3)
    normals = readers.normals_of(tmp_path / "tile.glb").reshape(ROWS + 1, COLUMNS + 1, 3)
    np.testing.assert_array_equal(heights[:, 0, 1], heights[:, -1, 1])
    np.testing.assert_allclose(normals[:, 0], normals[:, -1], atol=1e-6)
    np.testing.assert_allclose(normals[0], normals[-1], atol=1e-6)


def test_an_open_field_has_nothing_to_close(tmp_path):
    run = asymmetric(lattice__boundary_x="open", lattice__boundary_y="open")
    with pytest.raises(ExportError, match="open"):
        export(run, tmp_path / "dunes.r32", close=True)
    assert list(tmp_path.iterdir()) == []


def test_the_side_car_tells_frame_changes_and_origin(run, tmp_path):
    export(run, tmp_path / "dunes.png", step=[0, 10], smooth=1.0, close=True)
    car = json.loads((tmp_path / "dunes.png.json").read_text())
    assert [one["file"] for one in car["files"]] == ["dunes-00.png", "dunes-10.png"]
    assert [one["frames"] for one in car["files"]] == [
        [{"step": 0, "seconds": None}],
        [{"step": 10, "seconds": None}],
    ]
    assert (car["frame"]["rows"], car["frame"]["columns"]) == (ROWS + 1, COLUMNS + 1)
    assert car["frame"]["cell_width_m"] == CELL
    assert car["periodic"]["tiles"] == "repeats every 40 m west to east and repeats every 28 m south to north"
    assert car["periodic"]["first_row_and_column_repeated"]
    assert car["changes"]["smoothed_over_cells"] == 1.0
    assert car["scenario"]["seed"] == 7
    assert len(car["scenario"]["id"]) == 16


def test_maps_of_several_frames_share_one_scale(run, tmp_path):
    """The ground rises by a slab a frame: the same number stands for the same height in all maps."""
    export(run, tmp_path / "dunes.png", step="all")
    told = json.loads((tmp_path / "dunes.png.json").read_text())["numbers"]["elevation"]
    whole = [slabs(step) * SLAB for step in (0, 5, 10)]
    assert told["lowest"] == pytest.approx(min(map(np.min, whole)))
    assert told["highest"] == pytest.approx(max(map(np.max, whole)))
    for step, heights in zip((0, 5, 10), whole, strict=True):
        with readers.Image.open(tmp_path / f"dunes-{step:02d}.png") as picture:
            found = told["lowest"] + np.asarray(picture)[::-1].astype(float) * told["per_unit"]
        np.testing.assert_allclose(found, heights, atol=told["per_unit"] / 2 * 1.001)


def test_given_limits_stand_for_black_and_white(run, tmp_path):
    export(run, tmp_path / "dunes.r16", limits=(0.0, 65.535))
    numbers = np.fromfile(tmp_path / "dunes.r16", "<u2").reshape(ROWS, COLUMNS)[::-1]
    np.testing.assert_array_equal(numbers, np.rint(slabs(10) * SLAB * 1000.0))


def test_limits_that_cut_heights_off_are_refused(run, tmp_path):
    with pytest.raises(ExportError, match="--limits 0 5: elevation lies between"):
        export(run, tmp_path / "dunes.r16", limits=(0.0, 5.0))


def test_a_mask_is_black_and_white(run, tmp_path):
    export(run, tmp_path / "shadow.png", fields="shadow")
    with readers.Image.open(tmp_path / "shadow.png") as picture:
        assert set(np.unique(np.asarray(picture))) == {0, 65535}


def test_a_level_field_can_be_written(tmp_path):
    run = asymmetric()
    run["sand"][...] = 3
    run["elevation"][...] = 3 * SLAB
    export(run, tmp_path / "level.png")
    export(run, tmp_path / "level.stl")
    assert readers.trimesh.load(tmp_path / "level.stl").is_watertight


def test_the_side_car_tells_how_to_read_each_of_several_maps(run, tmp_path):
    export(run, tmp_path / "dunes.png", fields="elevation,depth,slope")
    car = json.loads((tmp_path / "dunes.png.json").read_text())
    assert list(car["numbers"]) == ["elevation", "depth", "slope"]
    assert {*car} == {
        *("format", "program", "scenario", "files", "frame", "periodic", "changes", "ranges", "numbers")
    }
    told = car["numbers"]["depth"]
    with readers.Image.open(tmp_path / "dunes-depth.png") as picture:
        found = told["lowest"] + np.asarray(picture)[::-1].astype(float) * told["per_unit"]
    np.testing.assert_allclose(found, slabs(10) * SLAB, atol=told["per_unit"] / 2 * 1.001)
