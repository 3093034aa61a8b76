"""Zones of times: two records are joined in one of them, or not at all."""

import numpy as np
import pytest

from barchan.errors import RecordError
from barchan.wind.records import RecordFormat, read_record
from barchan.wind.records.joining import with_weather
from barchan.wind.records.weather_record import read_weather
from barchan.wind.records.writing import write_record
from tests.wind.records.weather_file import SMET

ZONED = SMET.replace("[DATA]", "tz = 1\n[DATA]")


def winds(folder, zone="", heading="time", count=9):
    rows = [f"2024-01-01T{k:02d}:00{zone},8,270" for k in range(count)]
    (folder / "wind.csv").write_text("\n".join([f"{heading},speed (m/s),direction", *rows]) + "\n")
    return folder / "wind.csv"


def snow(folder, text=ZONED):
    (folder / "snow.smet").write_text(text)
    return folder / "snow.smet"


def test_a_stated_zone_turns_times_to_utc(tmp_path):
    record = read_record(winds(tmp_path), RecordFormat(time_zone="+01:00"))
    assert (str(record.start), record.utc) == ("2023-12-31T23:00:00", True)
    assert str(read_record(winds(tmp_path), RecordFormat(time_zone="-03:30")).start) == "2024-01-01T03:30:00"


@pytest.mark.parametrize(
    ("heading", "start"),
    [
        ("DateTime (UTC+1)", "2023-12-31T23:00:00"),
        ("Date and Time (UTC-03:30)", "2024-01-01T03:30:00"),
        ("time GMT+0530", "2023-12-31T18:30:00"),
        ("Station time (UTC)", "2024-01-01T00:00:00"),
    ],
)
def test_a_zone_in_the_heading_turns_times_to_utc(tmp_path, heading, start):
    record = read_record(winds(tmp_path, heading=heading))
    assert (str(record.start), record.utc) == (start, True)


@pytest.mark.parametrize(
    ("zone", "heading", "utc"), [("", "time", False), ("Z", "time", True), ("", "time_utc", True)]
)
def test_a_zone_is_known_by_times_or_heading(tmp_path, zone, heading, utc):
    record = read_record(winds(tmp_path, zone, heading))
    assert (str(record.start), record.utc) == ("2024-01-01T00:00:00", utc)


def test_a_zone_beside_that_of_the_file_is_refused(tmp_path):
    path = winds(tmp_path, "+01:00")
    with pytest.raises(RecordError, match=r"row 2.*states a zone .*time_zone is \+02:00"):
        read_record(path, RecordFormat(time_zone="+02:00"))
    with pytest.raises(ValueError, match="time_zone"):
        RecordFormat(time_zone="CET")


def test_records_with_and_without_a_zone_are_not_joined(tmp_path):
    said = r"snow\.smet state their zone.*those of wind\.csv do not.*--time-zone=\+01:00"
    with pytest.raises(RecordError, match=said):
        with_weather(read_record(winds(tmp_path)), read_weather(snow(tmp_path), RecordFormat()))
    said = r"wind\.csv state their zone.*those of snow\.smet do not.*--weather-time-zone=\+01:00"
    with pytest.raises(RecordError, match=said):
        with_weather(read_record(winds(tmp_path, "Z")), read_weather(snow(tmp_path, SMET), RecordFormat()))


def test_stated_zones_join_the_rows_of_one_moment(tmp_path):
    """6 mm from 0 to 3 h and 3 mm from 3 to 6 h of UTC+1, beside winds that are counted in UTC+1 too."""
    record = read_record(winds(tmp_path), RecordFormat(time_zone="+01:00"))
    found = with_weather(record, read_weather(snow(tmp_path), RecordFormat()))
    np.testing.assert_allclose(found.snowfall * 3600, [2, 2, 2, 1, 1, 1, 0, 0, 0], atol=1e-12)
    utc = SMET.replace("[DATA]", "tz = 0\n[DATA]")
    later = with_weather(record, read_weather(snow(tmp_path, utc), RecordFormat()))
    np.testing.assert_allclose(later.snowfall[:5] * 3600, [0, 2, 2, 2, 1], atol=1e-12)


def test_a_written_record_states_its_zone(tmp_path):
    record = read_record(winds(tmp_path), RecordFormat(time_zone="+01:00"))
    write_record(record, tmp_path / "again.csv")
    again = read_record(tmp_path / "again.csv")
    assert (again.start, again.utc) == (record.start, True)
    write_record(read_record(winds(tmp_path)), tmp_path / "local.csv")
    assert not read_record(tmp_path / "local.csv").utc
