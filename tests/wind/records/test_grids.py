"""NetCDF variables are read for what their attributes say, at the point that is asked for, or refused."""

import numpy as np
import pytest
import xarray as xr

from barchan.errors import RecordError
from barchan.wind.records import RecordFormat, read_record

HOURS = np.datetime64("2020-01-01T00", "ns") + np.arange(4) * np.timedelta64(1, "h")
WAYS = {"units": "degree", "standard_name": "wind_from_direction"}


def series(folder, coords=None, **variables):
    """A file of series over four hours: each variable is (values, attributes)."""
    arrays = {name: ("time", values, attributes) for name, (values, attributes) in variables.items()}
    xr.Dataset(arrays, {"time": HOURS, **(coords or {})}).to_netcdf(folder / "wind.nc", engine="h5netcdf")
    return folder / "wind.nc"


def box(folder, **extra):
    """A grid of 3 by 3 points whose eastward wind is latitude plus a tenth of the longitude."""
    latitude, longitude = np.array([24.0, 23.75, 23.5]), np.array([15.0, 15.25, 15.5])
    east = np.broadcast_to(latitude[:, None] + longitude / 10 - 15.0, (4, 3, 3)).copy()
    dims = ("time", "latitude", "longitude")
    attributes = {"units": "m s**-1"} | extra
    xr.Dataset(
        {"u10": (dims, east, attributes), "v10": (dims, 0 * east, attributes)},
        {"time": HOURS, "latitude": latitude, "longitude": longitude},
    ).to_netcdf(folder / "box.nc", engine="h5netcdf")
    return folder / "box.nc"


def test_the_point_that_was_read_is_told(tmp_path):
    record = read_record(box(tmp_path), RecordFormat(latitude=23.8, longitude=15.3))
    assert record.place == "23.75°N 15.25°E"
    np.testing.assert_allclose(record.speed, 23.75 + 1.525 - 15.0)


@pytest.mark.parametrize(
    ("latitude", "longitude", "said"),
    [
        (52.0, 15.1, "latitude: is 52, outside the grid; allowed: 23.5 to 24 degrees .steps of 0.25"),
        (23.6, 4.0, "longitude: is 4, outside the grid; allowed: 15 to 15.5 degrees"),
        (15.2, 23.6, "latitude: is 15.2, outside the grid"),
        (24.2, 15.1, "latitude: is 24.2, outside the grid"),
    ],
)
def test_a_point_outside_the_grid_is_refused(tmp_path, latitude, longitude, said):
    with pytest.raises(RecordError, match=said):
        read_record(box(tmp_path), RecordFormat(latitude=latitude, longitude=longitude))


def test_a_point_asked_for_far_from_the_only_one_is_refused(tmp_path):
    where = {"latitude": 23.5, "longitude": 15.5}
    path = series(tmp_path, where, ws=(np.ones(4), {"units": "m/s"}), wd=(np.ones(4), WAYS))
    assert read_record(path, RecordFormat(latitude=23.4, longitude=15.5)).place == "23.5°N 15.5°E"
    with pytest.raises(RecordError, match="latitude: is 40, outside the grid"):
        read_record(path, RecordFormat(latitude=40.0, longitude=15.5))


def test_preliminary_values_of_era5_fill_in_for_final_ones(tmp_path):
    east = np.array([[1.0, np.nan], [2.0, np.nan], [np.nan, 3.0], [np.nan, np.nan]])
    attributes = {"units": "m s**-1"}
    dims = ("time", "expver")
    xr.Dataset(
        {"u10": (dims, east, attributes), "v10": (dims, 0 * east, attributes)},
        {"time": HOURS, "expver": [1, 5]},
    ).to_netcdf(tmp_path / "era5t.nc")
    record = read_record(tmp_path / "era5t.nc")
    assert record.speed.tolist() == [1, 2, 3]
    assert record.missing == 1


def test_a_member_of_an_ensemble_is_asked_for(tmp_path):
    east = np.arange(1.0, 9.0).reshape(4, 2)
    dims = ("time", "number")
    xr.Dataset(
        {"u10": (dims, east, {"units": "m/s"}), "v10": (dims, 0 * east, {"units": "m/s"})},
        {"time": HOURS, "number": [0, 1]},
    ).to_netcdf(tmp_path / "members.nc")
    with pytest.raises(RecordError, match="member: the file holds an ensemble; state one of members 0 to 1"):
        read_record(tmp_path / "members.nc")
    assert read_record(tmp_path / "members.nc", RecordFormat(member=1)).speed.tolist() == [2, 4, 6, 8]
    with pytest.raises(RecordError, match="member: is 7; the file has members 0 to 1"):
        read_record(tmp_path / "members.nc", RecordFormat(member=7))


def test_of_several_levels_the_one_at_ten_metres_is_read(tmp_path):
    speed = np.array([2.0, 10.0, 100.0]) * np.ones((4, 1))
    dims = ("time", "height")
    xr.Dataset(
        {"wind_speed": (dims, speed, {"units": "m/s"}), "wind_direction": (dims, 0 * speed, WAYS)},
        {"time": HOURS, "height": [2.0, 10.0, 100.0]},
    ).to_netcdf(tmp_path / "levels.nc")
    for asked, height in ((None, 10.0), (100.0, 100.0)):
        record = read_record(tmp_path / "levels.nc", RecordFormat(height=asked))
        assert (record.speed.tolist(), record.height) == ([height] * 4, height)


def test_directions_that_the_wind_goes_to_are_turned(tmp_path):
    goes = {"units": "degree", "standard_name": "wind_to_direction"}
    path = series(tmp_path, ws=(np.ones(4), {"units": "m/s"}), wind_direction=([0.0, 90, 180, 359], goes))
    record = read_record(path)
    assert record.direction.tolist() == [180, 270, 0, 179]
    assert "where the wind goes to" in record.remarks[0]
    stated = read_record(path, RecordFormat(convention="from"))
    assert stated.direction.tolist() == [0, 90, 180, 359]


def test_codes_for_missing_values_are_those_of_the_file_s_own_unit(tmp_path):
    path = series(tmp_path, ws=([10.0, 999, 20, 30], {"units": "knots"}), wd=([10.0, 20, -9999, 40], WAYS))
    record = read_record(path)
    np.testing.assert_allclose(record.speed, np.array([10, 20, 30]) * 1852 / 3600)
    assert (record.missing, record.without_direction.tolist()) == (1, [False, True, False])
    path = series(tmp_path, u10=([3.0, 77, 0, 4], {"units": "m/s"}), v10=([4.0, 1, 5, 77], {"units": "m/s"}))
    assert read_record(path, RecordFormat(missing=[77.0])).speed.tolist() == [5, 5]


def test_packed_values_have_the_fill_value_and_the_range_of_their_attributes(tmp_path):
    packed = {"units": "m/s", "scale_factor": 0.1, "add_offset": 5.0, "valid_max": np.int16(200)}
    raw = np.array([10, -32767, 100, 300], np.int16)
    data = xr.Dataset(
        {
            "ws": ("time", raw, packed | {"_FillValue": np.int16(-32767)}),
            "wd": ("time", np.full(4, 90.0), WAYS),
        },
        {"time": HOURS},
    )
    data.to_netcdf(tmp_path / "packed.nc", engine="h5netcdf")
    record = read_record(tmp_path / "packed.nc")
    np.testing.assert_allclose(record.speed, [6.0, 15.0])
    assert record.missing == 2


@pytest.mark.parametrize(
    ("speed", "way", "said"),
    [
        ({"units": "Beaufort"}, WAYS, "is in 'Beaufort'; a class of the Beaufort scale is no speed"),
        ({"units": "m/s"}, {"units": "percent"}, "is in 'percent'; allowed: deg, 10 deg, rad, gon"),
        ({"units": "m/s"}, {"units": "degrees_magnetic"}, "directions from magnetic north"),
    ],
)
def test_units_that_cannot_be_used_are_refused(tmp_path, speed, way, said):
    with pytest.raises(RecordError, match=said):
        read_record(series(tmp_path, wind_speed=(np.ones(4), speed), wind_direction=(np.ones(4), way)))


def test_gusts_and_maxima_are_no_wind(tmp_path):
    path = series(
        tmp_path,
        ws=(np.full(4, 9.0), {"units": "m/s", "cell_methods": "time: maximum"}),
        wind_speed_of_gust=(np.full(4, 9.0), {"units": "m/s", "standard_name": "wind_speed_of_gust"}),
        wspd=(np.full(4, 3.0), {"units": "m/s", "long_name": "10 metre wind speed"}),
        wd=(np.ones(4), WAYS),
    )
    record = read_record(path)
    assert record.speed.tolist() == [3] * 4
    assert record.height == 10.0


def test_components_along_a_grid_of_its_own_are_refused(tmp_path):
    dims = ("time", "y", "x")
    north, east = np.meshgrid([20.0, 21.0], [10.0, 11.0], indexing="ij")
    xr.Dataset(
        {name: (dims, np.ones((4, 2, 2)), {"units": "m/s"}) for name in ("u10", "v10")},
        {"time": HOURS, "latitude": (("y", "x"), north), "longitude": (("y", "x"), east)},
    ).to_netcdf(tmp_path / "turned.nc")
    with pytest.raises(RecordError, match="variable 'u10': is along the columns of a grid"):
        read_record(tmp_path / "turned.nc", RecordFormat(latitude=20.0, longitude=10.0))
