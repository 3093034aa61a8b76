"""Maps whose metres are not those on the ground are refused, with the true size of a cell.

True sizes come from the sphere (Web Mercator: the cosine of the latitude), from the length of a degree on
the ellipsoid by its usual series, and from the geometry of the polar plane.
"""

import math
import re

import numpy as np
import pytest

import barchan
from barchan.errors import ScenarioError
from barchan.ground.surface import FileGround
from barchan.lattice import Lattice
from barchan.streams import Stream

rasterio = pytest.importorskip("rasterio")

ROWS, COLUMNS = 10, 16
HEIGHTS = np.arange(ROWS * COLUMNS, dtype=np.float64).reshape(ROWS, COLUMNS) / 10


@pytest.fixture
def model(tmp_path):
    def write(crs, west, south, width, height=None, upward=False, **profile):
        height = height or width
        transform = (width, 0, west, 0, -height, south + ROWS * height)
        if upward:
            transform = (width, 0, west, 0, height, south)
        path = tmp_path / "dem.tif"
        shape = {"height": ROWS, "width": COLUMNS, "count": 1, "dtype": "float64", **profile}
        place = rasterio.transform.Affine(*transform)
        with rasterio.open(path, "w", driver="GTiff", crs=crs, transform=place, **shape) as target:
            target.write(HEIGHTS if upward else HEIGHTS[::-1], 1)
        return path

    return write


def ground(path, **more):
    return FileGround(path=str(path), **more)


def lattice(cell):
    return Lattice(rows=ROWS, columns=COLUMNS, cell_size=cell)


def refused(path, cell=2.0, **more):
    with pytest.raises(ScenarioError) as caught:
        ground(path, **more).elevation(lattice(cell), Stream(1, "ground"))
    (problem,) = caught.value.problems
    return problem.message.partition(": ")[2]


@pytest.mark.parametrize(("latitude", "zone"), [(33.8, "32631"), (-50.0, "32731"), (65.0, "32631")])
def test_web_mercator_is_refused_and_a_cell_is_shorter_by_the_cosine_of_the_latitude(model, latitude, zone):
    north = 6_378_137.0 * math.log(math.tan(math.radians(45 + latitude / 2)))
    message = refused(model("EPSG:3857", 400_000.0, north, 10.0), 10.0)
    width = float(re.search(r"cells of 10 m are ([\d.]+) m", message)[1])
    assert width == pytest.approx(10 * math.cos(math.radians(latitude)), rel=0.005)
    assert f"EPSG:{zone} (UTM zone 31" in message


def test_web_mercator_on_the_equator_keeps_lengths_but_for_the_flattening(model):
    """There the ellipsoid's meridian is curved by 1/(1 - e²) more than its equator: 0.67 %."""
    path = model("EPSG:3857", 400_000.0, 0.0, 10.0)
    ground(path).elevation(lattice(10.0), Stream(1, "ground"))
    (remark,) = ground(path).remarks(lattice(10.0))
    assert "10 m from west to east and 9.93 m from south to north" in remark


def test_degrees_are_refused_with_the_true_size_of_a_cell(model):
    latitude = 33.5
    path = model("EPSG:4326", -117.0, latitude, 1 / 3600)
    phi = math.radians(latitude + ROWS / 7200)
    east = 111_412.84 * math.cos(phi) - 93.5 * math.cos(3 * phi) + 0.118 * math.cos(5 * phi)
    north = 111_132.954 - 559.822 * math.cos(2 * phi) + 1.175 * math.cos(4 * phi)
    message = refused(path)
    assert f"{east / 3600:.3g} m from west to east and {north / 3600:.3g} m from south to north" in message
    assert "EPSG:32611 (UTM zone 11N)" in message


def test_a_tile_of_srtm_heights_is_in_degrees(tmp_path):
    path = tmp_path / "N33W117.hgt"
    np.full((1201, 1201), 7, ">i2").tofile(path)
    assert "77.4 m from west to east and 92.4 m from south to north" in refused(path)


def test_feet_are_refused_with_the_true_size_of_a_cell(model):
    message = refused(model("EPSG:2272", 2_700_000.0, 250_000.0, 3.0))
    assert "in units of 0.304801 m (US survey foot): its cells of 3 are 0.914 m" in message


def test_a_polar_map_is_taken_and_its_north_is_told(model):
    """45° east of its central meridian (45° W) the map's north is turned by 45° from the meridian there."""
    distance = 2_000_000.0
    west, south = distance * math.sin(math.radians(45)), -distance * math.cos(math.radians(45))
    path = model("EPSG:3413", west, south, 10.0)
    (remark,) = [r for r in ground(path).remarks(lattice(10.0)) if "true north" in r]
    assert "lies 45.0° east of true north" in remark


def test_a_map_true_to_scale_has_no_remark(model):
    assert ground(model("EPSG:32633", 500_000.0, 4_000_000.0, 2.0)).remarks(lattice(2.0)) == []


def test_a_file_without_reference_system_is_asked_about(model):
    path = model(None, 500_000.0, 4_000_000.0, 2.0)
    assert "stated by the file or by crs, for instance 'EPSG:32633', or crs 'metres'" in refused(path)
    stated = ground(path, crs="EPSG:32633")
    np.testing.assert_allclose(stated.elevation(lattice(2.0), Stream(1, "ground")), HEIGHTS)
    assert stated.georeference().crs == "EPSG:32633"
    assert ground(path, crs="metres").georeference().crs is None
    assert "EPSG:3857, whose lengths" in refused(path, crs="EPSG:3857")
    assert "is in 'EPSG:1', which is no known" in refused(path, crs="EPSG:1")
    own = model("EPSG:32632", 500_000.0, 4_000_000.0, 2.0)
    assert refused(own, crs="EPSG:32633") == "is in EPSG:32632 by itself, not in EPSG:32633; leave crs out"


def test_text_in_degrees_is_asked_about(tmp_path):
    head = "ncols 16\nnrows 10\nxllcorner 14.2\nyllcorner 40.1\ncellsize 0.000277777778\n"
    rows = "\n".join(" ".join(map(str, row)) for row in HEIGHTS[::-1])
    (tmp_path / "dem.asc").write_text(head + rows)
    message = refused(tmp_path / "dem.asc")
    assert "look like degrees; state crs 'metres'" in message
    assert "EPSG:32633 (UTM zone 33N)" in message


def test_a_raster_that_begins_in_the_south_lies_where_it_lies(model):
    down = ground(model("EPSG:32633", 500_000.0, 4_000_000.0, 2.0))
    first = down.georeference(), down.elevation(lattice(2.0), Stream(1, "ground"))
    up = ground(model("EPSG:32633", 500_000.0, 4_000_000.0, 2.0, upward=True))
    assert up.georeference() == first[0]
    np.testing.assert_array_equal(up.elevation(lattice(2.0), Stream(1, "ground")), first[1])
    assert (first[0].west, first[0].south) == (500_000.0, 4_000_000.0)


def test_cells_that_are_almost_square_are_taken_as_squares_and_told(model):
    path = model("EPSG:32633", 500_000.0, 4_000_000.0, 2.0, 2.00001)
    np.testing.assert_array_equal(ground(path).elevation(lattice(2.0), Stream(1, "ground")), HEIGHTS)
    (remark,) = ground(path).remarks(lattice(2.0))
    assert remark == "cells of the terrain are 2 × 2.00001 m, and taken as squares of 2 m"


def test_cells_beyond_the_tolerance_are_only_taken_when_resampled(model):
    path = model("EPSG:32633", 500_000.0, 4_000_000.0, 2.0, 2.01)
    assert refused(path).startswith(
        "has cells of 2 × 2.01 m; allowed: 2 m as lattice.cell_size (within 0.1 %"
    )
    read = ground(path, resample=True).elevation(lattice(2.0), Stream(1, "ground"))
    centres = (np.arange(ROWS) + 0.5) * 2.0 / 2.01 - 0.5
    np.testing.assert_allclose(read[1:], HEIGHTS[0] + 1.6 * centres[1:, None])


def test_heights_in_feet_become_metres(model):
    path = model("EPSG:32633", 500_000.0, 4_000_000.0, 2.0)
    with rasterio.open(path, "r+") as target:
        target.units = ("ft",)
    read = ground(path).elevation(lattice(2.0), Stream(1, "ground"))
    np.testing.assert_allclose(read, 0.3048 * HEIGHTS)
    assert "heights in ft taken to metres" in ground(path).facts(lattice(2.0))["terrain"]


def test_frames_lie_where_the_terrain_lies(model, tmp_path):
    path = model("EPSG:32633", 500_000.0, 4_000_000.0, 2.0, upward=True)
    data = {"barchan": 5, "lattice": "from ground", "ground": {"kind": "file", "path": str(path)}}
    scenario = barchan.load(data, run__steps=2, run__save_every=1, run__seed=1)
    assert scenario.lattice.shape == (ROWS, COLUMNS)
    barchan.run(barchan.Simulation(scenario), tmp_path / "run")
    for frames in (barchan.simulate(scenario), barchan.open_run(tmp_path / "run")):
        np.testing.assert_allclose(frames["x"], 500_001.0 + 2.0 * np.arange(COLUMNS))
        np.testing.assert_allclose(frames["y"], 4_000_001.0 + 2.0 * np.arange(ROWS))
        assert frames.attrs["crs"] == "EPSG:32633"
        assert (frames.attrs["west"], frames.attrs["south"]) == (500_000.0, 4_000_000.0)
        frames.isel(step=-1).to_netcdf(tmp_path / "last.nc")
        with rasterio.open(f"netcdf:{tmp_path / 'last.nc'}:elevation") as opened:
            assert opened.crs.to_epsg() == 32633
            assert opened.bounds == (500_000.0, 4_000_000.0, 500_032.0, 4_000_020.0)


def test_frames_over_made_up_ground_are_measured_from_its_edges():
    frames = barchan.simulate(
        barchan.load({"barchan": 5, "lattice": {"rows": 4, "columns": 8}}, run__steps=1, run__seed=1)
    )
    assert (frames["x"].values[0], frames["y"].values[0]) == (0.5, 0.5)
    assert "spatial_ref" not in frames.variables


def test_a_map_of_mars_is_measured_on_mars(model):
    """Equirectangular, true at 20°: at 22° a parallel is shorter by cos 22° / cos 20°, a meridian is not."""
    mars, radius = "+proj=eqc +lat_ts=20 +lon_0=180 +R=3396190 +units=m", 3_396_190.0
    near = ground(model(mars, 0.0, radius * math.radians(22), 2.0))
    (remark,) = near.remarks(lattice(2.0))
    assert "1.97 m from west to east and 2 m from south to north" in remark
    message = refused(model(mars, 0.0, radius * math.radians(50), 2.0))
    assert "1.37 m from west to east" in message
    assert "EPSG" not in message


def test_coordinates_of_a_site_are_taken_as_they_are(model):
    site = 'LOCAL_CS["Site grid",UNIT["metre",1],AXIS["Easting",EAST],AXIS["Northing",NORTH]]'
    assert ground(model(site, 100.0, 200.0, 2.0)).georeference().west == 100.0
    feet = site.replace('"metre",1', '"foot",0.3048')
    assert "in units of 0.3048 m (foot); allowed: metres" in refused(model(feet, 100.0, 200.0, 2.0))


def test_degrees_that_are_called_metres_are_refused(model):
    message = refused(model("EPSG:32633", 14.2, 40.1, 1 / 3600))
    assert message.startswith("is in EPSG:32633, but its cells of 0.000277778 from 14.2 to 14.2044 look like")


def test_a_height_system_in_the_reference_is_no_hindrance(model):
    compound = ground(model("EPSG:25832+5783", 500_000.0, 5_500_000.0, 2.0))
    np.testing.assert_array_equal(compound.elevation(lattice(2.0), Stream(1, "ground")), HEIGHTS)
    for system, foot in (("EPSG:26917+8228", 0.3048), ("EPSG:26917+6360", 1200 / 3937)):
        feet = ground(model(system, 500_000.0, 4_000_000.0, 2.0))
        np.testing.assert_allclose(feet.elevation(lattice(2.0), Stream(1, "ground")), HEIGHTS * foot)


def test_coordinates_that_a_map_does_not_cover_are_refused(model):
    message = refused(model("EPSG:32633", 1e12, 1e12, 2.0))
    assert "coordinates that its reference system does not cover" in message


def test_grads_are_no_degrees(model):
    """0.01 grad are 0.009°; a degree at 45° is 78 847 m of the parallel and 111 132 m of the meridian."""
    message = refused(model("EPSG:4807", 2.0, 50.0, 0.01))
    assert message.startswith("is in grads (EPSG:4807): its cells of 0.01 are 709 m from west to east")
    assert "1e+03 m from south to north" in message
