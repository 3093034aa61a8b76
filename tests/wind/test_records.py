"""Wind records are read, or refused with the place that is wrong."""

import gzip
import runpy
import time
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from barchan.errors import RecordError
from barchan.wind.records import RecordFormat, WindRecord, read_record

EXAMPLE = Path(__file__).parents[2] / "examples" / "sample_wind.py"
KNOT = 1852 / 3600


def table(folder, text, name="wind.csv"):
    path = folder / name
    path.write_text(text, "utf-8")
    return path


PLAIN = "time,speed (m/s),direction\n2024-01-01T00:00,5,270\n2024-01-01T01:00,6,360\n2024-01-01T02:00,7,90\n"


def test_a_table_becomes_winds_that_stand_for_an_hour_each(tmp_path):
    record = read_record(table(tmp_path, PLAIN))
    assert record.speed.tolist() == [5, 6, 7]
    assert record.direction.tolist() == [270, 0, 90]
    assert record.time.tolist() == [0, 3600, 7200]
    assert record.duration.tolist() == [3600] * 3
    assert str(record.start) == "2024-01-01T00:00:00"
    assert (record.missing, record.calms, record.gaps, record.remarks) == (0, 0, 0, ())


@pytest.mark.parametrize(
    "heading",
    [
        "Date-Time;FF [kn];DD",
        "timestamp\tsknt\tdrct",
        "valid_time,wind_speed_10m (kt),wind_direction_10m (°)",
        '"datetime","ws (knots)","wd"',
        "# a remark\nstation,Nowhere,12\n\ndate,Wind Speed (kts),Wind Dir",
    ],
)
def test_columns_and_units_are_known_by_their_usual_names(tmp_path, heading):
    mark = max(",;\t", key=heading.splitlines()[-1].count)
    rows = "\n".join(
        mark.join(row) for row in [("2024-01-01 00:00", "10", "10"), ("2024-01-01 03:00", "20", "20")]
    )
    record = read_record(table(tmp_path, f"{heading}\n{rows}\n"))
    np.testing.assert_allclose(record.speed, [10 * KNOT, 20 * KNOT])
    assert record.direction.tolist() == [10, 20]
    assert record.duration.tolist() == [10800, 10800]


@pytest.mark.parametrize(
    ("unit", "metres"), [("m/s", 1.0), ("kn", KNOT), ("km/h", 1 / 3.6), ("mph", 0.44704)]
)
def test_a_unit_may_be_stated_for_a_table_that_does_not(tmp_path, unit, metres):
    path = table(tmp_path, "when,blow,from\n2024-01-01,10,1\n2024-01-02,20,2\n")
    form = RecordFormat(time="when", speed="blow", direction="from", unit=unit)
    np.testing.assert_allclose(read_record(path, form).speed, [10 * metres, 20 * metres])


def test_a_speed_without_a_unit_is_taken_as_metres_a_second_and_said(tmp_path):
    record = read_record(table(tmp_path, "time,ws,wd\n2024-01-01,10,1\n2024-01-02,20,2\n"))
    assert record.speed.tolist() == [10, 20]
    assert record.remarks == ("column 'ws' states no unit; taken as m/s",)


@pytest.mark.parametrize(
    "rows",
    [
        "01.02.2024;00:30;5,5;10\n01.02.2024;01:30;6,5;20\n",
        "01.02.2024;00:30;5.5;10\n01.02.2024;01:30;6.5;20\n",
    ],
)
def test_a_date_and_an_hour_make_a_time_and_commas_may_be_decimal(tmp_path, rows):
    form = RecordFormat(time="date+hour", time_format="%d.%m.%Y %H:%M")
    record = read_record(table(tmp_path, "date;hour;ff (m/s);dd\n" + rows), form)
    assert record.speed.tolist() == [5.5, 6.5]
    assert str(record.start) == "2024-02-01T00:30:00"


@pytest.mark.parametrize(
    ("times", "seconds"),
    [
        (("2024010100", "2024010103"), 10800),
        (("20240101", "20240102"), 86400),
        (("202401010000", "202401010010"), 600),
    ],
)
def test_times_may_be_digits_alone(tmp_path, times, seconds):
    record = read_record(table(tmp_path, f"MESS_DATUM;F;D\n{times[0]};3;10\n{times[1]};4;20\n"))
    assert record.time.tolist() == [0, seconds]


def test_times_may_be_counted(tmp_path):
    record = read_record(table(tmp_path, "time (h),ws (m/s),wd\n5,3,10\n5.5,4,20\n"))
    assert (record.time.tolist(), record.start) == ([0, 1800], None)


def test_a_zone_that_all_times_state_is_turned_to_universal_time(tmp_path):
    text = PLAIN.replace(":00,", ":00+02:00,")
    assert str(read_record(table(tmp_path, text)).start) == "2023-12-31T22:00:00"


MISSING = (
    "time,speed (m/s),direction\n2024-01-01T00:00,,270\n2024-01-01T01:00,-999,10\n2024-01-01T02:00,4,NaN\n"
    "2024-01-01T03:00,0,\n2024-01-01T04:00,4,VRB\n2024-01-01T05:00,4,990\n2024-01-01T06:00,4,180\n"
    "2024-01-01T07:00,0.0,999\n"
)


def test_missing_values_are_left_out_and_calms_need_no_direction(tmp_path):
    record = read_record(table(tmp_path, MISSING))
    assert record.speed.tolist() == [4, 0, 4, 4, 4, 0]
    assert record.without_direction.tolist() == [True, False, True, True, False, False]
    assert record.direction[~record.without_direction].tolist() == [0, 180, 0]
    assert (record.missing, record.calms) == (2, 2)
    assert record.seconds == 6 * 3600


def test_what_stands_for_missing_may_be_stated(tmp_path):
    path = table(tmp_path, PLAIN.replace(",6,", ",77.7,"))
    assert read_record(path, RecordFormat(missing=[77.7])).speed.tolist() == [5, 7]


def test_a_row_stands_until_the_next_one_but_not_across_a_gap(tmp_path):
    hours = [0, 1, 2, 4, 5, 6, 30, 31]
    rows = "".join(f"{hour},5,270\n" for hour in hours)
    record = read_record(table(tmp_path, "time (h),ws (m/s),wd\n" + rows))
    assert (record.duration / 3600).tolist() == [1, 1, 2, 1, 1, 1, 1, 1]
    assert record.gaps == 1
    assert "gaps: 1;" in record.remarks[0]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is empty"),
        ("time,speed (m/s),direction\n", "holds 0 winds"),
        (PLAIN.rsplit("\n", 3)[0], "holds 1 wind; allowed: two or more"),
        (
            PLAIN.replace("T02:00", "T02:00+01:00"),
            "row 4, column 'time': .* states the zone [+]01:00 unlike the rows",
        ),
        (PLAIN.replace("T02:00", "T02:00Z"), "row 4, column 'time'"),
        (PLAIN.replace("2024-01-01T01:00", "noon"), "row 3, column 'time': is 'noon'; allowed: .*ISO 8601"),
        (PLAIN.replace("2024-01-01T01:00", ""), "row 3, column 'time': is empty"),
        (
            PLAIN.replace(",90", ",400"),
            "row 4, column 'direction': is 400; allowed: directions from 0 to 360",
        ),
        (PLAIN.replace(",90", ",-10"), "row 4, column 'direction': is -10"),
        (
            PLAIN.replace(",6,", ",-6,"),
            r"row 3, column 'speed \(m/s\)': is -6; allowed: speeds from 0 to 150 m/s",
        ),
        (PLAIN.replace(",6,", ",strong,"), r"row 3, column 'speed \(m/s\)': is 'strong'; allowed: numbers"),
        (PLAIN.replace(",6,", ",8888,"), "row 3, .* is 8888; allowed: speeds"),
        ("\n\n" + PLAIN.replace(",6,", ",6,1,"), "Expected 3 fields in row 5, saw 4"),
        (PLAIN.replace(",5,", ",5,1,").replace(",6,", ",6,1,"), "rows with more values than the heading"),
        (
            PLAIN.replace("2024-01-01T01:00", "7").replace("time", "time (h)"),
            r"column 'time \(h\)': is '2024",
        ),
        (PLAIN.replace("direction", "bearing"), "no column for the direction; the columns are time"),
        (
            PLAIN.replace("(m/s)", "(furlongs)"),
            "is in 'furlongs'; allowed: m/s, 0.1 m/s, cm/s, kn, km/h, mph, ft/s",
        ),
        (
            PLAIN.replace(",5,", ",,").replace(",6,", ",,").replace(",7,", ",,"),
            "holds no wind; all of 3 rows",
        ),
    ],
)
def test_mistakes_are_told_with_row_and_column(tmp_path, text, said):
    with pytest.raises(RecordError, match=said) as raised:
        read_record(table(tmp_path, text))
    assert "wind.csv" in str(raised.value)


def test_a_format_of_times_that_is_none_is_refused(tmp_path):
    with pytest.raises(RecordError, match="time_format: 'Q' is a bad directive"):
        read_record(table(tmp_path, PLAIN), RecordFormat(time_format="%Q"))


def test_a_mistake_in_each_column_is_told_at_once(tmp_path):
    wrong = PLAIN.replace(",6,", ",-6,").replace(",90", ",400")
    with pytest.raises(RecordError, match="2 problems"):
        read_record(table(tmp_path, wrong))


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("none.csv", "no such file"),
        ("wind.grib", "is GRIB; convert it to NetCDF"),
        ("broken.nc", "cannot be read"),
    ],
)
def test_files_that_are_none_are_refused(tmp_path, name, said):
    if name == "broken.nc":
        (tmp_path / name).write_bytes(b"no NetCDF")
    if name == "wind.grib":
        (tmp_path / name).write_bytes(b"GRIB\x00\x01")
    with pytest.raises(RecordError, match=said):
        read_record(tmp_path / name)


HOURS = np.datetime64("2020-01-01T00") + np.arange(4) * np.timedelta64(1, "h")


def reanalysis(**changes):
    """What ERA5 gives for a box of two by two points: winds from the west, south-west, south and calm."""
    east, north = np.array([8.0, 5.0, 0.0, 0.0]), np.array([0.0, 5.0, 4.0, 0.0])
    offset = np.arange(4.0).reshape(1, 2, 2)
    dims = ("valid_time", "latitude", "longitude")
    attributes = {"units": "m s**-1"} | changes
    return xr.Dataset(
        {
            "u10": (dims, east[:, None, None] + 0 * offset, attributes),
            "v10": (dims, north[:, None, None] + offset, attributes),
        },
        {"valid_time": HOURS, "latitude": [30.0, 29.75], "longitude": [359.75, 0.0]},
    )


def test_a_point_of_a_reanalysis_is_read(tmp_path):
    reanalysis().to_netcdf(tmp_path / "era5.nc", engine="h5netcdf")
    record = read_record(tmp_path / "era5.nc", RecordFormat(latitude=30.1, longitude=-0.3))
    np.testing.assert_allclose(record.speed, [8, 50**0.5, 4, 0])
    np.testing.assert_allclose(record.direction, [270, 225, 180, 0])
    assert (record.calms, record.missing, str(record.start)) == (1, 0, "2020-01-01T00:00:00")


@pytest.mark.parametrize("engine", ["h5netcdf", "scipy"])
def test_speed_and_direction_are_read_by_their_standard_names(tmp_path, engine):
    xr.Dataset(
        {
            "blow": ("time", [10.0, np.nan], {"standard_name": "wind_speed", "units": "knots"}),
            "bearing": ("time", [90.0, 80.0], {"standard_name": "wind_from_direction", "units": "degree"}),
        },
        {"time": HOURS[:2]},
    ).to_netcdf(tmp_path / "wind.nc", engine=engine)
    record = read_record(tmp_path / "wind.nc")
    assert record.speed.tolist() == [10 * KNOT]
    assert record.missing == 1


@pytest.mark.parametrize(
    ("dataset", "said"),
    [
        (reanalysis(), r"u10: has more than one point: latitude \(2\), longitude \(2\); state latitude"),
        (reanalysis(units="bananas"), "is in 'bananas'"),
        (reanalysis().drop_vars("u10"), "no variable for the eastward wind; the variables are v10"),
        (reanalysis().drop_vars("valid_time"), "no dimension of times"),
    ],
)
def test_mistakes_in_grids_are_told(tmp_path, dataset, said):
    dataset.to_netcdf(tmp_path / "grid.nc")
    with pytest.raises(RecordError, match=said):
        read_record(tmp_path / "grid.nc")


def test_the_sample_is_what_its_generator_makes():
    made = runpy.run_path(str(EXAMPLE))["sample"]()
    shipped = (files("barchan.wind.records") / "sample.csv.gz").read_bytes()
    assert gzip.decompress(shipped).decode("utf-8") == made
    assert len(shipped) < 200_000


def test_the_sample_has_calms_missing_hours_and_two_seasons():
    record = read_record("sample")
    assert isinstance(record, WindRecord)
    assert 100 < record.calms < 2000
    assert 300 < record.missing < 1000
    july = (record.time / 86400 % 365 // 30).astype(int) == 6
    january = record.time / 86400 % 365 < 30
    assert abs(np.median(record.direction[july & (record.direction > 90)]) - 340) < 15
    assert abs(np.median(record.direction[january]) - 235) < 20


def test_forty_years_of_hours_are_read_in_seconds(tmp_path):
    hours = np.datetime64("1980-01-01T00:00") + np.arange(350_000) * np.timedelta64(1, "h")
    lines = [f"{hour},{k % 17}.5,{k % 360}" for k, hour in enumerate(hours.astype(str))]
    path = table(tmp_path, "time,speed (m/s),direction\n" + "\n".join(lines) + "\n")
    read_record("sample")
    began = time.process_time()
    assert len(read_record(path)) == 350_000
    assert time.process_time() - began < 5.0
