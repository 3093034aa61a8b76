"""A field that looks different from every side comes out of every format as it went in."""

from datetime import datetime

import h5py
import numpy as np
import pytest
import rasterio
import xarray as xr
from rasterio.transform import Affine

from barchan import simulate
from barchan.export import FORMATS, export
from tests.export import readers
from tests.export.scenes import CELL, COLUMNS, ROWS, SLAB, asymmetric, slabs
from tests.tiny import tiny

READERS = {
    "vtkhdf": [readers.vtkhdf],
    "vti": [readers.vti],
    "pvd": [readers.pvd],
    "netcdf": [readers.netcdf, readers.netcdf_by_vtk, readers.netcdf_by_gdal],
    "geotiff": [readers.gdal],
    "asc": [readers.gdal],
    "png16": [readers.png16],
    "r16": [readers.r16],
    "r32": [readers.r32],
    "tiff32": [readers.tiff32],
    "exr": [readers.exr],
    "glb": [readers.y_up],
    "obj": [readers.y_up],
    "ply": [readers.ply],
    "stl": [readers.stl],
}
"""Who reads each format."""

UNREAD = {"measures", "section", "layers", "mp4", "film", "picture", "animation"}
"""Formats that hold no field of heights, or several (see ``test_gltf``)."""

CASES = [(name, reader) for name, found in READERS.items() for reader in found]

X, Y = (np.arange(COLUMNS) + 0.5) * CELL, (np.arange(ROWS) + 0.5) * CELL
"""Centres of the cells: half a cell from the west and the south edge, then a cell further each."""

WEST, SOUTH = 500_000.0, 3_600_000.0


@pytest.fixture(scope="module")
def local():
    return asymmetric()


@pytest.fixture(scope="module")
def timed():
    return asymmetric(clock={"step_seconds": 3600.0})


@pytest.fixture(scope="module")
def on_earth(tmp_path_factory):
    """The field over level ground at 100 m that lies on Earth."""
    path = tmp_path_factory.mktemp("ground") / "ground.tif"
    place = Affine(CELL, 0.0, WEST, 0.0, -CELL, SOUTH + ROWS * CELL)
    with rasterio.open(
        path, "w", driver="GTiff", height=ROWS, width=COLUMNS, count=1, dtype="float32",
        crs="EPSG:32633", transform=place,
    ) as file:  # fmt: skip
        file.write(np.full((ROWS, COLUMNS), 100.0, "f4"), 1)
    return asymmetric(ground={"kind": "file", "path": str(path)})


def suffix(name):
    return next(one.suffixes[0] for one in FORMATS if one.name == name)


def test_every_format_has_a_reader():
    assert {one.name for one in FORMATS} == set(READERS) | UNREAD


@pytest.mark.parametrize(("name", "reader"), CASES, ids=[f"{n} by {r.__name__}" for n, r in CASES])
def test_heights_and_places_come_out_as_they_went_in(local, tmp_path, name, reader):
    path = tmp_path / f"dunes{suffix(name)}"
    export(local, path, format=name)
    x, y, heights = reader(path)
    expected = slabs(10) * SLAB
    step_of_16_bits = np.ptp(expected) / 65535
    if name == "stl":
        expected = expected - expected.min()
    np.testing.assert_allclose(x, X, rtol=1e-6)
    np.testing.assert_allclose(y, Y, rtol=1e-6)
    np.testing.assert_allclose(heights, expected, rtol=1e-6, atol=step_of_16_bits)
    south_west = heights[: ROWS // 2, : COLUMNS // 2]
    assert np.unravel_index(heights.argmax(), heights.shape) == (3, 4)
    assert south_west.max() == heights.max()


@pytest.mark.parametrize("name", ["vtkhdf", "vti", "netcdf", "geotiff", "asc"])
def test_fields_on_earth_keep_their_place(on_earth, tmp_path, name):
    path = tmp_path / f"dunes{suffix(name)}"
    export(on_earth, path, format=name)
    for reader in READERS[name]:
        x, y, heights = reader(path)
        np.testing.assert_allclose(x, WEST + X)
        np.testing.assert_allclose(y, SOUTH + Y)
        np.testing.assert_allclose(heights, 100.0 + slabs(10) * SLAB, rtol=1e-6)


@pytest.mark.parametrize("name", ["netcdf", "geotiff"])
def test_gis_programs_find_the_reference_system(on_earth, tmp_path, name):
    path = tmp_path / f"dunes{suffix(name)}"
    export(on_earth, path, format=name, fields="elevation")
    with rasterio.open(path if name == "geotiff" else f"netcdf:{path}:elevation") as file:
        assert file.crs.to_epsg() == 32633
        assert next(file.sample([(WEST + 4.5 * CELL, SOUTH + 3.5 * CELL)]))[-1] == np.float32(100 + 32 * SLAB)


def test_bands_of_a_geotiff_carry_their_names_and_units(local, tmp_path):
    export(local, tmp_path / "dunes.tif", fields="elevation,sand,slope")
    with rasterio.open(tmp_path / "dunes.tif") as file:
        assert file.descriptions == ("elevation", "sand", "slope")
        assert file.units == ("m", "slabs", "degrees")
        np.testing.assert_array_equal(file.read(2)[::-1], slabs(10))


@pytest.mark.parametrize(
    ("run", "times"),
    [("local", [0.0, 5.0, 10.0]), ("timed", [0.0, 18000.0, 36000.0])],
    ids=["steps", "clock"],
)
def test_paraview_finds_every_frame_at_its_time(request, tmp_path, run, times):
    run = request.getfixturevalue(run)
    export(run, tmp_path / "dunes.vtkhdf")
    export(run, tmp_path / "dunes.nc")
    frames, grids = readers.vtkHDFReader(), readers.vtkNetCDFCFReader()
    for reader, name in ((frames, "dunes.vtkhdf"), (grids, "dunes.nc")):
        reader.SetFileName(str(tmp_path / name))
        if reader is grids:
            reader.UpdateMetaData()
            reader.SetDimensions("(y, x)")
        assert len(readers.vtk_times(reader)) == 3
    assert readers.vtk_times(frames) == times
    for step, time in zip((0, 5, 10), times, strict=True):
        heights = readers.vtkhdf(tmp_path / "dunes.vtkhdf", time)[2]
        np.testing.assert_allclose(heights, slabs(step) * SLAB, rtol=1e-6)


def test_xarray_reads_dates_from_the_epoch_that_was_given(timed, tmp_path):
    export(timed, tmp_path / "dunes.nc", epoch=datetime(2021, 3, 1, 6))
    with xr.open_dataset(tmp_path / "dunes.nc", engine="h5netcdf") as run:
        assert list(run.time.values) == list(
            np.array(["2021-03-01T06:00", "2021-03-01T11:00", "2021-03-01T16:00"], "M8[ns]")
        )


def recorded(folder, hours):
    """The field under a wind that was recorded at these hours of the first of January 2023."""
    path = folder / "wind.csv"
    rows = "".join(f"2023-01-01 {hour:02d}:00,8,270\n" for hour in hours)
    path.write_text(f"time,speed,direction\n{rows}")
    return asymmetric(wind={"kind": "record", "path": str(path)}, clock={"step_seconds": 3600.0})


def test_time_counts_from_the_first_date_of_the_winds_record(tmp_path):
    """Steps of an hour from 01:00 on: the frames at steps 0, 5 and 10 are of 01:00, 06:00 and 11:00."""
    export(recorded(tmp_path, range(1, 13)), tmp_path / "dunes.nc")
    with xr.open_dataset(tmp_path / "dunes.nc", engine="h5netcdf", decode_times=False) as run:
        assert run.time.attrs["units"] == "seconds since 2023-01-01 01:00:00"
        assert run.time.attrs["long_name"] == "time from the beginning of the wind's record"
    with xr.open_dataset(tmp_path / "dunes.nc", engine="h5netcdf") as run:
        assert list(run.time.values) == list(
            np.array(["2023-01-01T01:00", "2023-01-01T06:00", "2023-01-01T11:00"], "M8[ns]")
        )


def test_times_that_a_run_leaves_out_are_told(tmp_path):
    """Rows of 4 to 8 h are absent: the sixth row of the run is that of 11:00, ten hours after the first."""
    export(recorded(tmp_path, [1, 2, 3, *range(9, 20)]), tmp_path / "dunes.nc")
    with xr.open_dataset(tmp_path / "dunes.nc", engine="h5netcdf", decode_times=False) as run:
        assert run.time.attrs["units"] == "seconds since 2023-01-01 01:00:00"
        assert run.time.attrs["long_name"].endswith("times without a known wind are left out")
        assert list(run.time.values) == [0.0, 18_000.0, 36_000.0]


def test_a_start_without_dates_is_said_to_be_arbitrary(timed, tmp_path):
    export(timed, tmp_path / "dunes.nc")
    with xr.open_dataset(tmp_path / "dunes.nc", engine="h5netcdf", decode_times=False) as run:
        assert run.time.attrs["units"] == "seconds since 2000-01-01 00:00:00"
        assert run.time.attrs["long_name"] == "time; its start is arbitrary"


def test_the_datasets_own_netcdf_shows_its_frames_in_time_too(local, tmp_path):
    local.drop_attrs(deep=False).to_netcdf(tmp_path / "run.nc", engine="scipy")
    reader = readers.vtkNetCDFCFReader()
    reader.SetFileName(str(tmp_path / "run.nc"))
    reader.UpdateMetaData()
    reader.SetDimensions("(y, x)")
    assert readers.vtk_times(reader) == [0.0, 5.0, 10.0]


def test_a_raw_map_with_the_south_first_is_the_same_map_turned(local, tmp_path):
    export(local, tmp_path / "north.r32")
    export(local, tmp_path / "south.r32", flip=True)
    north, south = (
        np.fromfile(tmp_path / f"{side}.r32", "<f4").reshape(ROWS, COLUMNS) for side in ("north", "south")
    )
    np.testing.assert_array_equal(north[::-1], south)
    np.testing.assert_allclose(south, slabs(10) * SLAB, rtol=1e-6)


def test_fields_travel_at_the_vertices_of_a_ply_mesh(local, tmp_path):
    export(local, tmp_path / "dunes.ply", fields=["sand"])
    mesh = readers.trimesh.load(tmp_path / "dunes.ply", process=False)
    found = mesh.metadata["_ply_raw"]["vertex"]["data"]["sand"].reshape(ROWS, COLUMNS)
    np.testing.assert_array_equal(found, slabs(10))


def test_normals_stand_upright_on_level_sand_and_lean_away_from_the_hump(local, tmp_path):
    export(local, tmp_path / "dunes.glb")
    normals = readers.normals_of(tmp_path / "dunes.glb").reshape(ROWS, COLUMNS, 3)
    np.testing.assert_allclose(normals[8, 12], (0, 1, 0), atol=1e-6)
    assert normals[3, 6, 0] > 0.5  # east of the hump, towards the east
    assert normals[5, 4, 2] < -0.5  # north of it, towards the north, which is -z


def test_a_solid_holds_the_sand_and_its_base(local, tmp_path):
    """Between centres the surface is two triangles a square: its volume is the mean of their corners."""
    export(local, tmp_path / "dunes.stl", base=1.0)
    heights = slabs(10) * SLAB
    heights = heights - heights.min() + 1.0
    low, right, far, left = heights[:-1, :-1], heights[:-1, 1:], heights[1:, 1:], heights[1:, :-1]
    expected = (((low + right + far) + (low + far + left)) / 6.0 * CELL**2).sum()
    assert readers.trimesh.load(tmp_path / "dunes.stl").volume == pytest.approx(expected, rel=1e-6)


def test_exaggeration_and_scale_change_heights_and_lengths_of_meshes(local, tmp_path):
    export(local, tmp_path / "dunes.glb", exaggerate=3.0, scale=10.0)
    x, _, heights = readers.y_up(tmp_path / "dunes.glb")
    plain = slabs(10) * SLAB
    np.testing.assert_allclose(x, 10.0 * X, rtol=1e-6)
    np.testing.assert_allclose(heights, 10.0 * (plain.min() + 3.0 * (plain - plain.min())), rtol=1e-6)


SNOW = {
    "density": "kg m-3",
    "age": "h",
    "threshold_wind": "m s-1",
    "stress": "1",
    "depth": "m",
    "slope": "degree",
}
"""Fields of snow, and their units as UDUNITS spells them."""


def test_netcdf_tells_true_units_and_its_words_in_utf_8(tmp_path):
    title = "Schneedünen bei −10 °C, wind → east"
    run = simulate(tiny(title=title, model__name="snow", run__steps=2))
    export(run, tmp_path / "snow.nc", fields=list(SNOW))
    with xr.open_dataset(tmp_path / "snow.nc", engine="h5netcdf", decode_timedelta=False) as file:
        assert {name: file[name].attrs["units"] for name in SNOW} == SNOW
        assert file["density"].attrs["unit"] == "kg/m³"
        assert file.attrs["title"] == title
    with h5py.File(tmp_path / "snow.nc") as file:
        told = h5py.check_string_dtype(file["density"].attrs.get_id("unit").dtype)
        assert (told.encoding, told.length) == ("utf-8", len("kg/m³".encode()))
