"""Heights from files: turned, scaled and fitted as stated, or refused with the reason."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

import barchan
from barchan.errors import ScenarioError
from barchan.ground import reading
from barchan.ground.raster import UnreadableError
from barchan.ground.reading import read
from barchan.ground.resampling import resampled
from barchan.ground.sand import FileSand
from barchan.ground.surface import FileGround
from barchan.ground.voids import filled
from barchan.lattice import Lattice
from barchan.streams import Stream

rasterio = pytest.importorskip("rasterio")

ROWS, COLUMNS = 9, 12
LATTICE = Lattice(rows=ROWS, columns=COLUMNS, cell_size=2.0)
STREAM = Stream(1, "ground")
HEIGHTS = np.arange(ROWS * COLUMNS, dtype=np.float64).reshape(ROWS, COLUMNS)
"""Highest in the north-east, and like none of its mirror images."""


@pytest.fixture
def array(tmp_path):
    def write(heights=HEIGHTS, name="heights.npy"):
        np.save(tmp_path / name, heights)
        return tmp_path / name

    return write


@pytest.fixture
def image(tmp_path):
    def write(values, name="heights.png"):
        Image.fromarray(values).save(tmp_path / name)
        return tmp_path / name

    return write


@pytest.fixture
def model(tmp_path):
    def write(heights=HEIGHTS, crs="EPSG:32633", cell=2.0, nodata=None, name="heights.tif", transform=None):
        place = transform or rasterio.transform.Affine(cell, 0.0, 500_000.0, 0.0, -cell, 4_000_018.0)
        rows, columns = heights.shape
        shape = {"height": rows, "width": columns, "count": 1, "dtype": "float64"}
        with rasterio.open(
            tmp_path / name, "w", driver="GTiff", crs=crs, transform=place, nodata=nodata, **shape
        ) as target:
            target.write(heights[::-1] if place.e < 0 else heights, 1)
        return tmp_path / name

    return write


def elevation(path, lattice=LATTICE, **more):
    return FileGround(path=str(path), **more).elevation(lattice, STREAM)


def refused(path, lattice=LATTICE, **more):
    """The one thing that is said to be wrong with a file."""
    with pytest.raises(ScenarioError) as caught:
        elevation(path, lattice, **more)
    (problem,) = caught.value.problems
    assert problem.key == "ground.path"
    file, _, said = problem.message.partition(": ")
    assert file == f"'{path}'"
    return said


def test_an_array_lies_as_ours_do(array):
    np.testing.assert_array_equal(elevation(array()), HEIGHTS)


def test_an_elevation_model_is_turned_so_that_its_south_comes_first(model):
    np.testing.assert_array_equal(elevation(model()), HEIGHTS)


def test_an_elevation_model_that_begins_in_the_south_is_not_turned(model):
    upward = rasterio.transform.Affine(2.0, 0.0, 500_000.0, 0.0, 2.0, 4_000_000.0)
    np.testing.assert_array_equal(elevation(model(transform=upward)), HEIGHTS)


@pytest.mark.parametrize(("depth", "white"), [(np.uint8, 255), (np.uint16, 65535)])
def test_an_image_is_turned_and_scaled_between_the_heights_of_black_and_white(image, depth, white):
    shares = HEIGHTS / HEIGHTS.max()
    path = image(np.rint(shares * white).astype(depth)[::-1])
    read = elevation(path, lowest=-10.0, highest=40.0)
    np.testing.assert_allclose(read, -10.0 + 50.0 * shares, atol=50.0 / white)
    assert read[0, 0] == -10.0
    assert read[-1, -1] == 40.0


def test_the_place_of_an_elevation_model_on_earth_is_kept(model):
    ground = FileGround(path=str(model()))
    place = ground.georeference()
    assert (place.crs, place.west, place.south) == ("EPSG:32633", 500_000.0, 4_000_000.0)


def test_an_array_has_no_place_on_earth_and_a_lost_file_none_either(array, tmp_path):
    assert FileGround(path=str(array())).georeference() is None
    assert FileGround(path=str(tmp_path / "gone.tif")).georeference() is None


def test_frames_tell_where_on_earth_they_lie(model):
    ground = {"kind": "file", "path": str(model())}
    lattice = {"rows": ROWS, "columns": COLUMNS, "cell_size": 2.0}
    frames = barchan.simulate(
        barchan.load({"barchan": 5, "lattice": lattice, "ground": ground}, run__steps=1)
    )
    assert frames.attrs["crs"] == "EPSG:32633"
    assert (frames.attrs["west"], frames.attrs["south"]) == (500_000.0, 4_000_000.0)


@pytest.mark.parametrize("crs", ["EPSG:4326", "EPSG:2272", None])
def test_a_reference_system_without_metres_is_refused(model, crs):
    message = refused(model(crs=crs))
    assert (crs or "no coordinate reference system") in message
    assert "allowed: a projected one in metres" in message


def test_cells_that_are_no_upright_squares_are_refused(model):
    oblong = rasterio.transform.Affine(2.0, 0.0, 0.0, 0.0, -3.0, 0.0)
    turned = rasterio.transform.Affine(2.0, 0.5, 0.0, 0.5, -2.0, 0.0)
    assert refused(model(transform=oblong)).startswith("has cells of 2 × 3 m; allowed: 2 m")
    assert "no upright rectangles (rows turned by 14°)" in refused(model(transform=turned))


def test_another_cell_size_is_refused_unless_the_file_may_be_resampled(model):
    assert "cells of 5 m; allowed: 2 m" in refused(model(cell=5.0))


def test_another_size_is_refused_unless_the_file_may_be_resampled(array):
    small = LATTICE.model_copy(update={"rows": 8})
    message = refused(array(), small)
    assert message.startswith("is 9 rows of 12 cells; allowed: the lattice's 8 rows of 12 cells")


def test_an_elevation_model_is_resampled_at_its_own_scale_from_its_south_west_corner(model):
    slope = np.broadcast_to(np.arange(COLUMNS) * 2.0 + 1.0, (ROWS, COLUMNS)).copy()
    fine = Lattice(rows=10, columns=16, cell_size=1.0)
    read = elevation(model(slope), fine, resample=True)
    np.testing.assert_allclose(read[:, 1:], np.broadcast_to(fine.x[1:], (10, 15)))


def test_an_elevation_model_smaller_than_the_field_is_refused_even_when_resampled(model):
    wide = Lattice(rows=ROWS, columns=50, cell_size=1.0)
    assert "covers 24 × 18 m; allowed: at least the field, 50 × 9 m" in refused(model(), wide, resample=True)


def test_an_array_is_stretched_over_the_field_when_resampled(array):
    twice = Lattice(rows=2 * ROWS, columns=2 * COLUMNS)
    read = elevation(array(), twice, resample=True)
    coarse = read.reshape(ROWS, 2, COLUMNS, 2).mean(axis=(1, 3))
    np.testing.assert_allclose(coarse[1:-1, 1:-1], HEIGHTS[1:-1, 1:-1])


def test_resampling_to_the_same_size_changes_nothing(array):
    np.testing.assert_allclose(elevation(array(), resample=True), HEIGHTS)


def test_holes_are_refused_with_their_number(model, array):
    holed = HEIGHTS.copy()
    holed[3, 4:7] = -9999.0
    assert refused(model(holed, nodata=-9999.0)).startswith("has 3 of 108 cells without a value")
    holed[3, 4:7] = np.nan
    assert "fill 'interpolate'" in refused(array(holed))


def test_a_hole_in_a_slope_is_filled_with_the_slope(array):
    holed = HEIGHTS.copy()
    holed[3:6, 4:7] = np.nan
    np.testing.assert_allclose(elevation(array(holed), fill="interpolate"), HEIGHTS)


@given(st.integers(0, 2**32), st.floats(0.05, 0.95))
def test_filled_holes_stay_between_the_heights_around_them(seed, share):
    generator = np.random.default_rng(seed)
    heights = generator.normal(size=(7, 9))
    holes = generator.random(heights.shape) < share
    holes[2, 3] = False
    whole = filled(np.where(holes, np.nan, heights), holes)
    known = heights[~holes]
    np.testing.assert_array_equal(whole[~holes], known)
    assert whole.min() >= known.min() - 1e-9
    assert whole.max() <= known.max() + 1e-9


@given(st.integers(1, 9), st.integers(8, 15), st.floats(0.2, 3), st.floats(0.2, 3))
def test_a_resampled_surface_stays_between_its_lowest_and_highest_point(rows, columns, step_y, step_x):
    fitted = resampled(HEIGHTS, step_y, step_x, Lattice(rows=rows, columns=columns))
    assert fitted.shape == (rows, columns)
    assert fitted.min() >= HEIGHTS.min() - 1e-9
    assert fitted.max() <= HEIGHTS.max() + 1e-9


@pytest.mark.parametrize("value", [2e5, -2e5, np.inf])
def test_heights_beyond_the_allowed_range_are_refused(array, value):
    heights = HEIGHTS.copy()
    heights[2, 2] = value
    assert "allowed: -100000 to 100000" in refused(array(heights), fill="interpolate", missing=[])


def test_an_image_without_the_heights_of_black_and_white_is_refused(image):
    path = image(np.zeros((ROWS, COLUMNS), np.uint8))
    assert "state lowest and highest" in refused(path, lowest=0.0)


GREYS = (2 * HEIGHTS).astype(np.uint8)


@pytest.mark.parametrize("mode", ["L", "LA", "RGB", "RGBA", "P"])
def test_greys_are_the_same_heights_however_an_image_stores_them(tmp_path, mode):
    """White (255) is 127.5 m high, so that a grey of 2 is 1 m."""
    Image.fromarray(GREYS[::-1]).convert(mode).save(tmp_path / "greys.png")
    path = tmp_path / "greys.png"
    np.testing.assert_allclose(elevation(path, lowest=0.0, highest=127.5), HEIGHTS, atol=1e-9)
    assert not read(path).coloured


def test_an_image_of_two_tones_is_black_and_white(tmp_path):
    Image.fromarray(GREYS > 107).save(tmp_path / "tones.png")
    assert read(tmp_path / "tones.png").full_scale == 255.0
    assert set(read(tmp_path / "tones.png").values.ravel()) == {0, 255}


def test_colours_are_taken_by_their_luminance_which_is_said(image):
    """0.299 R + 0.587 G + 0.114 B (ITU-R BT.601) of pure red is 76, of white 255."""
    path = image(np.full((ROWS, COLUMNS, 3), (255, 0, 0), np.uint8))
    assert (read(path).values == 76).all()
    facts = FileGround(path=str(path), lowest=0.0, highest=1.0).facts(LATTICE)
    assert facts["terrain"] == f"{ROWS} rows of {COLUMNS} cells; colours taken by their luminance"


def test_transparent_pixels_are_refused(image):
    pixels = np.full((ROWS, COLUMNS, 4), 255, np.uint8)
    pixels[0, :2, 3] = 254
    assert "has 2 transparent pixels" in refused(image(pixels), lowest=0.0, highest=1.0)


@pytest.mark.parametrize("heights", [np.zeros(5), np.zeros((2, 2), complex), np.array([["a"]])])
def test_an_array_that_is_no_field_of_numbers_is_refused(array, heights):
    assert "no two-dimensional array of numbers" in refused(array(heights))


@pytest.mark.parametrize("suffix", ["npy", "png", "tif"])
def test_a_damaged_file_is_refused(tmp_path, suffix):
    path = tmp_path / f"damaged.{suffix}"
    path.write_bytes(b"no such thing")
    assert "cannot be read as" in refused(path)


def test_a_file_that_is_missing_or_of_an_unknown_kind_is_refused(tmp_path):
    assert refused(tmp_path / "none.npy") == "no such file"
    assert refused(tmp_path / "a.bmp") == (
        "is of an unknown kind; allowed: .npy, .png, .jpg, .jpeg, .tif, .tiff, .asc, .xyz, .nc, .hgt"
    )


def test_a_missing_extra_is_named(model, monkeypatch):
    path = model()
    monkeypatch.setitem(__import__("sys").modules, "rasterio", None)
    assert "python -m pip install rasterio" in refused(path)


def test_depths_of_sand_are_slabs_or_metres(array):
    level = np.zeros(LATTICE.shape)
    path = str(array(np.full(LATTICE.shape, 4.0)))
    assert set(FileSand(path=path).slabs(LATTICE, level, STREAM).ravel()) == {4}
    assert set(FileSand(path=path, unit="m").slabs(LATTICE, level, STREAM).ravel()) == {6}


def test_depths_below_zero_are_refused(array):
    path = array(-HEIGHTS)
    with pytest.raises(ScenarioError, match=r"sand\.path: .*: has values from -107 to -?0; allowed: 0 to"):
        FileSand(path=str(path)).slabs(LATTICE, np.zeros(LATTICE.shape), STREAM)


def test_a_path_in_a_scenario_file_starts_where_the_file_lies(array, tmp_path, monkeypatch):
    array()
    scenario = {
        "barchan": 5,
        "lattice": {"rows": ROWS, "columns": COLUMNS},
        "ground": {"kind": "file", "path": "heights.npy"},
    }
    (tmp_path / "scenario.json").write_text(json.dumps(scenario))
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    simulation = barchan.Simulation(barchan.load(tmp_path / "scenario.json"))
    np.testing.assert_array_equal(simulation.bed.ground, HEIGHTS)
    with pytest.raises(ScenarioError, match="no such file"):
        barchan.Simulation(barchan.load(scenario))


def test_a_photograph_gives_its_luminance_with_its_upper_edge_in_the_north(tmp_path):
    # Flat halves survive the compression; 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601) of pure green is 150.
    upper, lower = np.full((16, 32, 3), (0, 255, 0)), np.full((16, 32, 3), (0, 0, 0))
    path = tmp_path / "photo.jpg"
    Image.fromarray(np.vstack((upper, lower)).astype(np.uint8)).save(path, quality=95, subsampling=0)
    raster = read(path)
    assert raster.full_scale == 255.0
    np.testing.assert_allclose(raster.values[-8:], 150, atol=2)
    np.testing.assert_allclose(raster.values[:8], 0, atol=2)


@pytest.mark.parametrize("name", ["map.png", "photo.jpg"])
def test_an_image_of_too_many_pixels_is_refused_before_it_is_unpacked(tmp_path, monkeypatch, name):
    monkeypatch.setattr(reading, "MOST_PIXELS", 32 * 16 - 1)
    Image.fromarray(np.zeros((16, 32), np.uint8)).save(tmp_path / name)
    with pytest.raises(UnreadableError, match="has 32 × 16 pixels; allowed"):
        read(tmp_path / name)
