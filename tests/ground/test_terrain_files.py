"""Elevation models in the formats that people have: every layout gives the same heights, at the right place.

All files hold the same tilted plane, written by hand (text) or by the library of the format, so that the
right heights follow from the coordinates alone: z = 100 + 0.01 (x - 500000) + 0.1 (y - 4000000).
"""

import numpy as np
import pytest
import xarray as xr

from barchan.errors import ScenarioError
from barchan.ground.surface import FileGround
from barchan.lattice import Lattice
from barchan.streams import Stream

ROWS, COLUMNS, CELL = 9, 12, 2.0
WEST, SOUTH = 500_000.0, 4_000_000.0
LATTICE = Lattice(rows=ROWS, columns=COLUMNS, cell_size=CELL)
X = WEST + CELL * (np.arange(COLUMNS) + 0.5)
Y = SOUTH + CELL * (np.arange(ROWS) + 0.5)


def plane(x, y):
    return 100.0 + 0.01 * (x - WEST) + 0.1 * (y - SOUTH)


PLANE = plane(X[None, :], Y[:, None])


def elevation(path, lattice=LATTICE, **more):
    return FileGround(path=str(path), **more).elevation(lattice, Stream(1, "ground"))


def refused(path, lattice=LATTICE, **more):
    with pytest.raises(ScenarioError) as caught:
        elevation(path, lattice, **more)
    (problem,) = caught.value.problems
    assert problem.key == "ground.path"
    return problem.message.partition(": ")[2]


def ascii_grid(path, heading, values=PLANE, mark=" "):
    lines = [mark.join(f"{v:.4f}" for v in row) for row in values[::-1]]
    path.write_text("\n".join([*heading, *lines]) + "\n")
    return path


HEADINGS = {
    "corner": ["ncols 12", "nrows 9", "xllcorner 500000", "yllcorner 4000000", "cellsize 2"],
    "centre": ["NCOLS 12", "NROWS 9", "XLLCENTER 500001.0", "YLLCENTER 4000001.0", "CELLSIZE 2.0"],
    "sides": ["ncols 12", "nrows 9", "xllcorner 5e5", "yllcorner 4e6", "dx 2", "dy 2", "NODATA_value -9999"],
}


@pytest.mark.parametrize("heading", HEADINGS)
def test_an_ascii_grid_is_read_from_the_north_with_its_corner(tmp_path, heading):
    path = ascii_grid(tmp_path / "dem.asc", HEADINGS[heading])
    np.testing.assert_allclose(elevation(path), PLANE, atol=1e-4)
    place = FileGround(path=str(path)).georeference()
    assert (place.west, place.south, place.crs) == (WEST, SOUTH, None)


def test_an_ascii_grid_needs_no_rasterio(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "rasterio", None)
    path = ascii_grid(tmp_path / "dem.asc", HEADINGS["corner"])
    np.testing.assert_allclose(elevation(path), PLANE, atol=1e-4)


def test_a_reference_system_beside_an_ascii_grid_counts(tmp_path):
    crs = pytest.importorskip("rasterio.crs").CRS
    path = ascii_grid(tmp_path / "dem.asc", HEADINGS["corner"])
    (tmp_path / "dem.prj").write_text(crs.from_epsg(32633).to_wkt(version="WKT1_ESRI"))
    assert FileGround(path=str(path)).georeference().crs == "EPSG:32633"
    (tmp_path / "dem.prj").write_text(crs.from_epsg(3857).to_wkt())
    assert "is in EPSG:3857" in refused(path)


def test_declared_voids_of_an_ascii_grid_are_holes(tmp_path):
    holed = PLANE.copy()
    holed[3:5, 4:7] = -9999
    path = ascii_grid(tmp_path / "dem.asc", HEADINGS["sides"], holed)
    assert refused(path).startswith("has 6 of 108 cells without a value")
    np.testing.assert_allclose(elevation(path, fill="interpolate"), PLANE, atol=1e-4)


def test_an_ascii_grid_may_have_decimal_commas_and_lines_of_any_length(tmp_path):
    text = " ".join(f"{v:.4f}".replace(".", ",") for v in PLANE[::-1].ravel())
    path = tmp_path / "dem.asc"
    path.write_text("\r\n".join([*HEADINGS["corner"], text.replace(" ", "\r\n", 5)]))
    np.testing.assert_allclose(elevation(path), PLANE, atol=1e-4)


def test_an_ascii_grid_that_was_cut_off_is_refused(tmp_path):
    path = ascii_grid(tmp_path / "dem.asc", HEADINGS["corner"], PLANE[:-1])
    assert refused(path) == "has 96 values; allowed: 9 rows of 12, as its heading says"
    path.write_text("north: 1\nsouth: 0\n")
    assert "has no ncols and no nrows in its heading" in refused(path)
    path.write_text("\n".join([*HEADINGS["corner"], "1 2 x"]))
    assert "words that are no numbers" in refused(path)


@pytest.mark.parametrize("order", ["north first", "south first", "by columns", "random"])
@pytest.mark.parametrize("mark", [" ", ",", ";"])
def test_points_of_a_grid_may_stand_in_any_order(tmp_path, order, mark):
    points = [(x, y, plane(x, y)) for y in (Y if order == "south first" else Y[::-1]) for x in X]
    if order == "by columns":
        points.sort()
    if order == "random":
        np.random.default_rng(2).shuffle(points)
    rows = [mark.join(f"{v:.4f}" for v in point) for point in points]
    path = tmp_path / "dem.xyz"
    path.write_text("\n".join(["x,y,z".replace(",", mark), *rows] if mark == "," else rows))
    decimal = path.read_text().replace(".", ",") if mark == ";" else path.read_text()
    path.write_text(decimal)
    np.testing.assert_allclose(elevation(path), PLANE, atol=1e-3)
    place = FileGround(path=str(path)).georeference()
    assert (place.west, place.south) == (WEST, SOUTH)


def test_points_that_are_missing_leave_holes_and_scattered_points_are_refused(tmp_path):
    points = np.array([(x, y, plane(x, y)) for y in Y for x in X])
    np.savetxt(tmp_path / "dem.xyz", np.delete(points, [40, 41, 53], axis=0), fmt="%.4f")
    assert refused(tmp_path / "dem.xyz").startswith("has 3 of 108 cells without a value")
    np.testing.assert_allclose(elevation(tmp_path / "dem.xyz", fill="interpolate"), PLANE, atol=1e-3)
    scattered = points + np.random.default_rng(3).uniform(0, 1, points.shape)
    np.savetxt(tmp_path / "cloud.xyz", scattered)
    message = refused(tmp_path / "cloud.xyz")
    assert "no grid" in message or "not evenly spaced" in message
    np.savetxt(tmp_path / "twice.xyz", np.vstack([points, points[:2]]))
    assert refused(tmp_path / "twice.xyz").startswith("has 2 points in cells that have one already")


def grid(**attributes):
    return xr.Dataset(
        {"z": (("y", "x"), PLANE, attributes)},
        {"x": ("x", X, {"units": "m"}), "y": ("y", Y, {"units": "m"})},
    )


@pytest.mark.parametrize("engine", ["h5netcdf", "scipy"])
@pytest.mark.parametrize("layout", ["south first", "north first", "x first", "east first", "one layer"])
def test_a_netcdf_grid_is_turned_by_its_coordinates(tmp_path, engine, layout):
    data = grid(units="m", standard_name="surface_altitude")
    data = {
        "south first": data,
        "north first": data.isel(y=slice(None, None, -1)),
        "x first": data.transpose("x", "y"),
        "east first": data.isel(x=slice(None, None, -1)),
        "one layer": data.expand_dims("time"),
    }[layout]
    data.to_netcdf(tmp_path / "dem.nc", engine=engine)
    np.testing.assert_allclose(elevation(tmp_path / "dem.nc"), PLANE)
    place = FileGround(path=str(tmp_path / "dem.nc")).georeference()
    assert (place.west, place.south) == (WEST, SOUTH)


def test_packed_values_units_and_valid_ranges_of_a_netcdf_grid_count(tmp_path):
    packed = np.rint((PLANE * 100 - 10_000) / 0.5).astype(np.int16)
    packed[2, 3], packed[6, 6] = -32768, 30_000
    data = grid()
    data["z"] = (("y", "x"), packed)
    data["z"].attrs = {
        "units": "cm",
        "scale_factor": 0.5,
        "add_offset": 10_000.0,
        "missing_value": np.int16(-32768),
        "valid_max": np.int16(20_000),
    }
    data.to_netcdf(tmp_path / "dem.nc")
    assert refused(tmp_path / "dem.nc").startswith("has 2 of 108 cells without a value")
    np.testing.assert_allclose(elevation(tmp_path / "dem.nc", fill="interpolate"), PLANE, atol=0.0026)


def test_a_netcdf_file_of_several_grids_asks_which(tmp_path):
    data = grid().assign(slope=grid()["z"] * 0.0 + 7.0)
    data.to_netcdf(tmp_path / "dem.nc")
    assert refused(tmp_path / "dem.nc") == "has several grids; state variable, one of: z, slope"
    np.testing.assert_allclose(elevation(tmp_path / "dem.nc", variable="z"), PLANE)
    assert "allowed as variable: z, slope" in refused(tmp_path / "dem.nc", variable="height")
    data["z"].attrs["standard_name"] = "surface_altitude"
    data.to_netcdf(tmp_path / "named.nc")
    np.testing.assert_allclose(elevation(tmp_path / "named.nc"), PLANE)


def test_a_netcdf_grid_that_cannot_be_used_is_refused_with_the_reason(tmp_path):
    data = grid(units="hPa")
    data.to_netcdf(tmp_path / "unit.nc")
    assert "states its heights in 'hPa'; allowed: m, km" in refused(tmp_path / "unit.nc")
    bent = grid().assign_coords(x=("x", X + np.linspace(0, 3, COLUMNS) ** 2, {"units": "m"}))
    bent.to_netcdf(tmp_path / "bent.nc")
    assert "has x that are not evenly spaced" in refused(tmp_path / "bent.nc")
    xr.concat([grid(), grid()], "time").to_netcdf(tmp_path / "twice.nc")
    assert "has the dimension time of 2 in z" in refused(tmp_path / "twice.nc")


def test_coordinates_in_kilometres_become_metres(tmp_path):
    data = grid().assign_coords(x=("x", X / 1e3, {"units": "km"}), y=("y", Y / 1e3, {"units": "km"}))
    data.to_netcdf(tmp_path / "dem.nc")
    np.testing.assert_allclose(elevation(tmp_path / "dem.nc"), PLANE)


def test_a_netcdf_grid_of_longitudes_is_refused_with_the_true_size_of_its_cells(tmp_path):
    """A degree at 45° is 78 847 m of the parallel and 111 132 m of the meridian (WGS 84)."""
    pytest.importorskip("rasterio")
    data = grid().rename(x="lon", y="lat")
    lon, lat = 10 + np.arange(COLUMNS) / 1200, 45 + np.arange(ROWS) / 1200
    data = data.assign_coords(lon=("lon", lon), lat=("lat", lat))
    data.to_netcdf(tmp_path / "dem.nc")
    assert "65.7 m from west to east and 92.6 m from south to north" in refused(tmp_path / "dem.nc")
