"""Tables of any layout are read for what they say, or refused for what is wrong.

Right values are worked out by hand or by ``known.potential`` (numpy).
"""

import gzip

import numpy as np
import openpyxl
import pytest

from barchan.errors import RecordError
from barchan.wind.records import RecordFormat, read_record

PLAIN = "time,speed (m/s),direction\n2024-01-01T00:00,5,270\n2024-01-01T01:00,6,360\n2024-01-01T02:00,7,90\n"


def table(folder, text, name="wind.csv", encoding="utf-8"):
    path = folder / name
    path.write_bytes(text.encode(encoding))
    return path


def is_plain(record):
    return record.speed.tolist() == [5, 6, 7] and record.direction.tolist() == [270, 0, 90]


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-8-sig", "latin-1"])
@pytest.mark.parametrize("name", ["wind.dat", "wind.txt", "wind", "wind.psv"])
def test_a_table_is_known_by_its_content(tmp_path, encoding, name):
    assert is_plain(read_record(table(tmp_path, PLAIN, name, encoding)))


@pytest.mark.parametrize("mark", [";", "\t", "|", "   "])
def test_columns_may_be_parted_in_several_ways(tmp_path, mark):
    text = PLAIN.replace("speed (m/s)", "speed").replace(",", mark)
    assert is_plain(read_record(table(tmp_path, text), RecordFormat(unit="m/s")))


def test_a_packed_table_without_a_suffix_is_read(tmp_path):
    path = tmp_path / "724940-23234-2024.gz"
    path.write_bytes(gzip.compress(PLAIN.encode()))
    assert is_plain(read_record(path))


@pytest.mark.parametrize(
    "heading",
    [
        "Date and Time", "Date & Time", "Station time", "Local time", "time_local", "valid_time", "Zeit",
        "Station Date/Time", "Datum und Uhrzeit", "Fecha y hora", "Measurement Timestamp", "Observation date",
    ],
)  # fmt: skip
def test_headings_that_say_a_time_in_more_words_are_the_time(tmp_path, heading):
    assert is_plain(read_record(table(tmp_path, PLAIN.replace("time", heading, 1))))


def test_a_date_and_a_time_of_a_station_are_joined(tmp_path):
    text = PLAIN.replace("time", "Station date,Station time", 1).replace("T", ",")
    assert is_plain(read_record(table(tmp_path, text)))


@pytest.mark.parametrize("heading", ["Time zone", "Sunset", "Start time", "Time quality flag"])
def test_what_may_be_no_time_is_asked_for(tmp_path, heading):
    with pytest.raises(RecordError, match="no column for the time"):
        read_record(table(tmp_path, PLAIN.replace("time", heading, 1)))


def test_of_two_times_alike_one_is_asked_for(tmp_path):
    text = PLAIN.replace("time", "Station time,Logger time", 1).replace("2024", "2024-01-01,2024")
    with pytest.raises(RecordError, match="several columns may be the time: Station time, Logger time"):
        read_record(table(tmp_path, text))


def workbook(folder):
    book = openpyxl.Workbook()
    book.active.title = "remarks"
    book.active.append(["nothing here"])
    sheet = book.create_sheet("winds")
    for row in (["time", "speed (m/s)", "direction"], *_dated()):
        sheet.append(row)
    path = folder / "wind.xlsx"
    book.save(path)
    return path


def _dated():
    hours = (np.datetime64("2024-01-01T00") + np.arange(3)).astype("datetime64[s]").astype(object)
    return [[hour, speed, way] for hour, speed, way in zip(hours, (5, 6, 7), (270, 360, 90), strict=True)]


def test_a_sheet_of_a_workbook_is_read(tmp_path):
    path = workbook(tmp_path)
    assert is_plain(read_record(path, RecordFormat(sheet="winds")))
    with pytest.raises(RecordError, match="sheet: is 'wind'; the sheets are remarks, winds"):
        read_record(path, RecordFormat(sheet="wind"))


def test_a_sheet_of_a_table_of_text_is_refused(tmp_path):
    with pytest.raises(RecordError, match="the file is no spreadsheet"):
        read_record(table(tmp_path, PLAIN), RecordFormat(sheet="winds"))


def test_rows_may_be_passed_over(tmp_path):
    text = "time,speed (kn),direction\nstation,of,old\n" + PLAIN
    assert is_plain(read_record(table(tmp_path, text), RecordFormat(skip_rows=2)))


def test_columns_without_a_heading_are_stated_by_number(tmp_path):
    path = table(tmp_path, "0;5;270;1\n1;6;360;1\n2;7;90;1\n")
    with pytest.raises(RecordError, match="has no heading; state its 4 columns by number"):
        read_record(path)
    form = RecordFormat(time="1", speed="2", direction="3", time_format="h", unit="m/s")
    record = read_record(path, form)
    assert is_plain(record)
    assert record.time.tolist() == [0, 3600, 7200]


@pytest.mark.parametrize("order", [[2, 1, 0], [1, 2, 0]])
def test_rows_may_be_in_any_order(tmp_path, order):
    head, *rows = PLAIN.splitlines()
    record = read_record(table(tmp_path, "\n".join([head, *(rows[k] for k in order)])))
    assert is_plain(record)
    assert str(record.start) == "2024-01-01T00:00:00"
    assert "rows were not in the order of time; sorted" in record.remarks


def test_rows_that_are_there_twice_are_dropped_and_counted(tmp_path):
    head, *rows = PLAIN.splitlines()
    record = read_record(table(tmp_path, "\n".join([head, rows[0], rows[0], rows[1], rows[2], rows[2]])))
    assert is_plain(record)
    assert record.duplicates == 2
    assert "of several rows of one time the first with a wind is kept: 2 dropped" in record.remarks


def test_other_winds_for_many_times_are_refused(tmp_path):
    rows = [f"2024-01-01T{hour:02}:00,{speed},270" for hour in range(9) for speed in (5, 9)]
    with pytest.raises(RecordError, match=r"row 3: states another wind for the time of row 2 .9 such rows"):
        read_record(table(tmp_path, "time,speed (m/s),direction\n" + "\n".join(rows)))


def test_one_of_several_stations_is_asked_for(tmp_path):
    rows = [f"{name},2024-01-01T{hour:02}:00,{speed},270" for hour in range(3) for name, speed in STATIONS]
    path = table(tmp_path, "station,time,speed (m/s),direction\n" + "\n".join(rows))
    with pytest.raises(RecordError, match="station: the table holds several; state one of 240, 269"):
        read_record(path)
    assert read_record(path, RecordFormat(station="269")).speed.tolist() == [9, 9, 9]
    with pytest.raises(RecordError, match="station: is '1'; the table has 240, 269"):
        read_record(path, RecordFormat(station="1"))


STATIONS = (("240", 5), ("269", 9))


def test_one_of_several_points_is_asked_for(tmp_path):
    rows = [f"2024-01-01T{h:02}:00,{u},0,{lat},15" for h in range(3) for u, lat in ((5, 20), (9, 21))]
    path = table(tmp_path, "time,u10,v10,latitude,longitude\n" + "\n".join(rows))
    with pytest.raises(RecordError, match="holds 2 points; state latitude and longitude"):
        read_record(path)
    assert read_record(path, RecordFormat(latitude=21.1, longitude=15.0)).speed.tolist() == [9, 9, 9]
    with pytest.raises(RecordError, match="the nearest point of the table is 21, 15"):
        read_record(path, RecordFormat(latitude=51.1, longitude=15.0))


@pytest.mark.parametrize(
    ("words", "degrees"),
    [
        (["N", "WSW", "nne", "North-West", "S"], [0, 247.5, 22.5, 315, 180]),
        (["360", "E", "45", "W", "10"], [0, 90, 45, 270, 10]),
    ],
)
def test_points_of_the_compass_are_directions(tmp_path, words, degrees):
    rows = [f"2024-01-01T{k:02}:00,5,{word}" for k, word in enumerate(words)]
    record = read_record(table(tmp_path, "time,speed (m/s),direction\n" + "\n".join(rows)))
    assert record.direction.tolist() == degrees


def test_a_word_that_is_no_point_of_the_compass_is_refused(tmp_path):
    with pytest.raises(RecordError, match="is 'ONO'; allowed: numbers, points of the compass"):
        read_record(table(tmp_path, PLAIN.replace(",90", ",ONO")))


def test_calm_in_words_is_a_calm_and_variable_winds_have_no_direction(tmp_path):
    rows = ["00:00,Calm,N", "01:00,,Calm", "02:00,0,C", "03:00,4,VRB", "04:00,4,90"]
    text = "time,speed (m/s),direction\n" + "\n".join(f"2024-01-01T{row}" for row in rows)
    record = read_record(table(tmp_path, text))
    assert record.speed.tolist() == [0, 0, 0, 4, 4]
    assert (record.calms, record.missing) == (3, 0)
    assert record.without_direction.tolist() == [False, False, False, True, False]


@pytest.mark.parametrize(
    ("heading", "value", "degrees"),
    [
        ("direction (rad)", "1.5707963267948966", 90.0),
        ("wind_dir (10s deg)", "9", 90.0),
        ("wind direction [gon]", "100", 90.0),
        ("Wind Direction, deg", "90", 90.0),
        ("WindDir_deg", "90", 90.0),
        ("wind_to_direction", "90", 270.0),
        ("wind direction (to)", "90", 270.0),
        ("wind direction (blowing towards, degrees)", "90", 270.0),
        ("wind_from_direction", "90", 90.0),
        ("Wind direction in degrees true", "90", 90.0),
    ],
)
def test_unit_and_convention_of_directions_are_read_from_the_heading(tmp_path, heading, value, degrees):
    text = f"time;speed (m/s);{heading}\n2024-01-01;5;{value}\n2024-01-02;6;{value}\n"
    np.testing.assert_allclose(read_record(table(tmp_path, text)).direction, degrees)


@pytest.mark.parametrize(
    ("heading", "said"),
    [
        ("direction (furlongs)", "is in 'furlongs'; allowed: deg, 10 deg, rad, gon"),
        ("direction (degrees magnetic)", "directions from magnetic north"),
        ("direction (degrees counterclockwise from east)", "angles counted from east"),
    ],
)
def test_a_unit_of_directions_that_cannot_be_used_is_refused(tmp_path, heading, said):
    with pytest.raises(RecordError, match=said):
        read_record(table(tmp_path, PLAIN.replace("direction", heading)))
    form = RecordFormat(direction_unit="deg")
    assert is_plain(read_record(table(tmp_path, PLAIN.replace("direction", heading)), form))


@pytest.mark.parametrize(
    ("heading", "metres"),
    [
        ("speed (km/h)", 1 / 3.6),
        ("Wind speed in knots", 1852 / 3600),
        ("Wind Speed, mph (LGR S/N: 9)", 0.44704),
        ("ws_ms", 1.0),
        ("WS_kmh_Avg", 1 / 3.6),
        ("windspeedKmh", 1 / 3.6),
        ("FF [0.1 m/s]", 0.1),
        ("wind speed (meters per second)", 1.0),
        ("ws [m s⁻¹]", 1.0),
        ("Wind speed (10 m, ft/s)", 0.3048),
    ],
)
def test_the_unit_of_speeds_is_read_from_the_heading(tmp_path, heading, metres):
    text = f"time;{heading};direction\n2024-01-01;10;90\n2024-01-02;20;90\n"
    record = read_record(table(tmp_path, text))
    np.testing.assert_allclose(record.speed, [10 * metres, 20 * metres])
    assert not record.remarks


def test_the_scale_of_beaufort_is_no_unit(tmp_path):
    with pytest.raises(RecordError, match="is in 'Bft'; a class of the Beaufort scale is no speed"):
        read_record(table(tmp_path, PLAIN.replace("m/s", "Bft")))


def test_a_stated_unit_holds_against_the_file_and_that_is_said(tmp_path):
    record = read_record(table(tmp_path, PLAIN), RecordFormat(unit="km/h"))
    np.testing.assert_allclose(record.speed, np.array([5, 6, 7]) / 3.6)
    assert record.remarks == ("column 'speed (m/s)' states m/s; taken as km/h, as asked for",)


HEIGHTS = (
    "time,ws_2m (m/s),gust_10m (m/s),ws_10m (m/s),ws_50m (m/s),wd_10m,wd_50m\n"
    "2024-01-01,3,99,5,8,270,280\n2024-01-02,4,99,6,9,270,280\n"
)


@pytest.mark.parametrize(
    ("height", "speeds", "ways"), [(None, [5, 6], 270), (10.0, [5, 6], 270), (50.0, [8, 9], 280)]
)
def test_of_several_heights_one_is_read_with_its_own_direction(tmp_path, height, speeds, ways):
    record = read_record(table(tmp_path, HEIGHTS), RecordFormat(height=height))
    assert record.speed.tolist() == speeds
    assert record.direction.tolist() == [ways] * 2
    assert record.height == (height or 10.0)
    assert "not from 'ws_2m (m/s)' at 2 m" in record.remarks[0]


def test_a_height_that_the_file_has_not_is_refused(tmp_path):
    with pytest.raises(RecordError, match="height: is 80 m; the file has winds at 2, 10, 50 m"):
        read_record(table(tmp_path, HEIGHTS), RecordFormat(height=80.0))


def test_the_height_goes_with_the_speed_where_the_direction_has_another(tmp_path):
    text = "time,ws_2m (m/s),wd_10m\n2024-01-01,3,270\n2024-01-02,4,270\n"
    record = read_record(table(tmp_path, text))
    assert record.height == 2.0
    assert "the direction 'wd_10m' at 10 m is taken with the speed 'ws_2m (m/s)' at 2 m" in record.remarks[0]


def test_a_column_that_is_given_to_the_time_is_not_guessed_for_the_direction(tmp_path):
    text = "YYYY,MM,DD,HH,speed (m/s)\n2024,1,2,0,5\n2024,1,2,1,6\n"
    with pytest.raises(RecordError, match="no column for the direction"):
        read_record(table(tmp_path, text), RecordFormat(time="YYYY+MM+DD+HH", time_format="%Y %m %d %H"))


@pytest.mark.parametrize(
    ("times", "form", "start"),
    [
        (["20240101 23", "20240101 24", "20240102 1"], "%Y%m%d %H", "2024-01-01T23"),
        (["2024-01-01T23:00", "2024-01-01T24:00", "2024-01-02T01:00"], None, "2024-01-01T23"),
        (["2024010123", "2024010124", "2024010201"], None, "2024-01-01T23"),
        (["31.12.2023 23:00", "31.12.2023 24:00", "01.01.2024 01:00"], None, "2023-12-31T23"),
        (["12/31/2023 23:00", "01/01/2024 00:00", "01/01/2024 01:00"], None, "2023-12-31T23"),
        (["2024-01-24 23:00:00", "2024-01-25 00:00:00", "2024-01-25 01:00:00"], None, "2024-01-24T23"),
    ],
)
def test_the_hour_24_is_the_first_of_the_next_day(tmp_path, times, form, start):
    rows = "\n".join(f"{time};5;270" for time in times)
    path = table(tmp_path, f"time;speed (m/s);direction\n{rows}")
    record = read_record(path, RecordFormat(time_format=form))
    assert record.time.tolist() == [0, 3600, 7200]
    assert record.start == np.datetime64(start)


def test_days_that_may_be_months_are_refused(tmp_path):
    text = "time,speed (m/s),direction\n01/02/2024 00:00,5,270\n01/02/2024 01:00,6,270\n"
    with pytest.raises(RecordError, match=r"day or month first\? State time_format, '%d/%m/%Y %H:%M' or"):
        read_record(table(tmp_path, text))


@pytest.mark.parametrize("columns", ["date,hour", "year,month,day,hour"])
def test_date_and_hour_may_be_in_columns_of_their_own(tmp_path, columns):
    date = "2024-03-01" if "date" in columns else "2024,3,1"
    text = f"{columns},speed (m/s),direction\n{date},5,5,270\n{date},7,6,270\n"
    record = read_record(table(tmp_path, text))
    assert record.time.tolist() == [0, 7200]
    assert str(record.start) == "2024-03-01T05:00:00"


def test_offsets_that_change_with_summer_time_are_known_moments(tmp_path):
    times = ["2024-03-31T01:00+01:00", "2024-03-31T03:00+02:00", "2024-03-31T04:00+02:00"]
    text = "time,speed (m/s),direction\n" + "\n".join(f"{time},5,270" for time in times)
    record = read_record(table(tmp_path, text))
    assert record.time.tolist() == [0, 3600, 7200]
    assert str(record.start) == "2024-03-31T00:00:00"


def test_a_row_of_units_below_the_heading_is_read(tmp_path):
    text = "time;ws;wd\n;km/h;deg\n2024-01-01;36;90\n;;\n2024-01-02;18;90\n"
    record = read_record(table(tmp_path, text))
    np.testing.assert_allclose(record.speed, [10, 5])
    assert not record.remarks


SENSORS = "time,WS2 (m/s),WS1 (m/s),WD1,WD2\n2024-01-01T00:00,9,5,270,90\n2024-01-01T01:00,9,6,280,100\n"


def test_a_speed_goes_with_the_direction_of_its_own_sensor(tmp_path):
    """WS2 blows from 90 and 100 degrees, WS1 from 270 and 280."""
    record = read_record(table(tmp_path, SENSORS))
    assert (record.speed.tolist(), record.direction.tolist()) == ([9, 9], [90, 100])
    assert "not from 'WS1 (m/s)', 'WD1'" in " ".join(record.remarks)
    chosen = read_record(table(tmp_path, SENSORS), RecordFormat(speed="WS1 (m/s)"))
    assert (chosen.speed.tolist(), chosen.direction.tolist()) == ([5, 6], [270, 280])


def test_a_direction_of_another_sensor_is_taken_with_a_word_only(tmp_path):
    form = RecordFormat(speed="WS1 (m/s)", direction="WD2")
    assert "which has none of its own" in read_record(table(tmp_path, SENSORS), form).remarks[0]


def commas(folder, *speeds):
    rows = "".join(f"2024-01-01T{n:02d}:00;{speed};270\n" for n, speed in enumerate(speeds))
    return table(folder, "time;wind_speed (cm/s);wd\n" + rows)


def test_a_comma_that_may_part_thousands_is_refused(tmp_path):
    with pytest.raises(RecordError, match=r"row 3, .*is '1,234', whose comma may part"):
        read_record(commas(tmp_path, "940", "1,234", "310"))


@pytest.mark.parametrize(
    ("speeds", "right"),
    [
        (("940,5", "1,234", "310"), [9.405, 0.01234, 3.1]),
        (("0,125", "1,234", "3"), [0.00125, 0.01234, 0.03]),
        (("940,125", "123,250"), [9.40125, 1.2325]),
        (("940,125", "-999", "123,250"), [9.40125, 1.2325]),
    ],
)
def test_commas_that_can_only_part_decimals_are_read_so(tmp_path, speeds, right):
    assert read_record(commas(tmp_path, *speeds)).speed.tolist() == pytest.approx(right)
