"""Temperature and snowfall of records: columns, units, formats, gaps, and what cannot be."""

import numpy as np
import pytest
import xarray as xr

from barchan.errors import RecordError
from barchan.wind import Recorded, Storms
from barchan.wind.records import RecordFormat, read_record
from barchan.wind.records.gaps import with_gaps
from barchan.wind.records.writing import write_record
from tests.wind.blown import segments

HOURS = [f"2024-01-01T{hour:02d}:00" for hour in range(24)]


def table(path, heading, rows):
    """A record of hourly rows: 8 m/s from the west, and further columns."""
    lines = [f"time,speed (m/s),direction,{heading}"]
    lines += [f"{time},8,270,{row}" for time, row in zip(HOURS, rows, strict=False)]
    path.write_text("\n".join(lines) + "\n", "utf-8")
    return path


@pytest.fixture
def path(tmp_path):
    return tmp_path / "snow.csv"


@pytest.mark.parametrize(
    ("heading", "value"),
    [
        ("temperature (°C)", -8.5),
        ("ta (K)", 264.65),
        ("air_temp", -8.5),
        ("t2m (K)", 264.65),
        ("TAIR", 264.65),
        ("Temperature (°F)", 16.7),
    ],
)
def test_a_temperature_is_in_celsius_whatever_its_unit(path, heading, value):
    """264.65 K and 16.7 °F are -8.5 °C; without a unit numbers above 150 are K."""
    found = read_record(table(path, heading, [value] * 3))
    np.testing.assert_allclose(found.temperature, -8.5, atol=1e-9)
    assert any(remark.startswith("temperature is read from") for remark in found.remarks)


@pytest.mark.parametrize(
    ("heading", "value"),
    [("snowfall (kg/m²/s)", 1 / 3600), ("snowfall (mm/h)", 1.0), ("Snowf (kg m-2 s-1)", 1 / 3600)],
)
def test_a_rate_of_snowfall_holds_for_its_row(path, heading, value):
    found = read_record(table(path, heading, [0.0, value, 0.0]))
    np.testing.assert_allclose(found.snowfall * 3600, [0.0, 1.0, 0.0], atol=1e-9)


def test_an_amount_fell_in_the_time_of_the_row_before(path):
    """2 mm reported at 02:00 fell from 01:00 on: the row of 01:00 snows at 2 kg/m² an hour."""
    found = read_record(table(path, "snowfall (mm)", [5.0, 0.0, 2.0, 0.0]))
    np.testing.assert_allclose(found.snowfall * 3600, [0.0, 2.0, 0.0, np.nan], atol=1e-9)


def test_precipitation_is_snow_in_the_cold_rain_in_the_warm_and_both_between(path):
    rows = ["-3,1.0", "0.5,1.0", "1.0,1.0", "4.0,1.0"]
    found = read_record(table(path, "temperature (°C),precipitation (mm/h)", rows))
    np.testing.assert_allclose(found.snowfall * 3600, [1.0, 0.75, 0.5, 0.0], atol=1e-9)


def test_a_temperature_missing_for_an_hour_is_between_its_neighbours_and_for_long_it_is_unknown(path):
    values = ["-2", "", "-4", *[""] * 4, "-9"]
    found = read_record(table(path, "temperature (°C)", values)).temperature
    np.testing.assert_allclose(found[:3], [-2, -3, -4])
    assert np.isnan(found[3:7]).all()


def test_time_passes_in_a_gap_without_wind_and_snow(path):
    lines = ["time,speed (m/s),direction,temperature (°C),snowfall (mm/h)"]
    lines += [
        f"2024-01-0{1 + (h >= 24)}T{h % 24:02d}:00,8,270,{-2 - h / 10:g},1" for h in (0, 1, 2, 3, 13, 14)
    ]
    path.write_text("\n".join(lines))
    found = with_gaps(read_record(path))
    assert found.duration.tolist() == [3600.0] * 4 + [9 * 3600.0] + [3600.0] * 2
    assert (found.speed[4], found.snowfall[4]) == (0.0, 0.0)
    assert found.temperature[4] == pytest.approx(-2.3 - 5 / 10)  # 8:30, between 3:30 and 13:30
    blown = segments(Recorded(kind="record", path=str(path), repeat=False), 0, 15, step_seconds=3600.0)
    assert sum(s.weather.snowfall * s.steps for s in blown) * 3600 == pytest.approx(6.0, rel=1e-6)


def test_snow_of_rows_without_a_wind_falls_and_the_wind_before_goes_on_for_three_hours(path):
    """Two hours without a wind, then five: the first keep 6 m/s, the second are calm; all snow falls."""
    winds = ["6,270"] + [","] * 2 + ["9,180"] * 2 + [","] * 5 + ["4,90"] * 2
    lines = ["time,speed (m/s),direction,snowfall (mm/h)"]
    lines += [f"{time},{wind},1" for time, wind in zip(HOURS, winds, strict=False)]
    path.write_text("\n".join(lines))
    record = read_record(path)
    assert (len(record), record.missing) == (5, 7)
    found = with_gaps(record)
    assert found.speed.tolist() == [6.0] * 3 + [9.0] * 2 + [0.0] * 5 + [4.0] * 2
    assert (found.snowfall * found.duration).sum() == pytest.approx(12.0)


def test_storms_are_read_with_the_weather_that_was_written(path):
    record = Storms(kind="storms", days=5.0, quiet_days=1.0).record(1)
    write_record(record, path)
    found = read_record(path)
    np.testing.assert_array_equal(found.temperature, record.temperature)
    np.testing.assert_allclose(found.snowfall, record.snowfall, rtol=1e-15)


SMET = """SMET 1.1 ASCII
[HEADER]
station_id = TEST
nodata = -999
tz = 1
fields = timestamp TA VW DW PSUM HS
units_multiplier = 1 1 1 1 1 0.01
units_offset = 0 273.15 0 0 0 0
[DATA]
2024-01-01T01:00 -8.0 9.5 250 0.0 35
2024-01-01T02:00 -9.0 -999 250 1.5 36
2024-01-01T03:00 -999 7.5 260 2.0 38
2024-01-01T04:00 -10.0 6.0 265 0.0 38
"""


def test_smet_is_read_by_its_header(tmp_path):
    """The zone is one hour east of UTC; the second row has no wind but 2.0 mm, the third no temperature."""
    (tmp_path / "test.smet").write_text(SMET)
    found = read_record(tmp_path / "test.smet", RecordFormat(height=7.0))
    assert found.format == "SMET"
    assert str(found.start) == "2024-01-01T00:00:00"
    assert found.speed.tolist() == [9.5, 7.5, 6.0]
    np.testing.assert_allclose(found.temperature, [-8.0, -9.5, -10.0])
    np.testing.assert_allclose(found.snowfall * 3600, [1.5, 0.0, np.nan])
    np.testing.assert_allclose(with_gaps(found).snowfall[1] * 3600, 2.0)
    assert found.height == 7.0


NEAD = """# NEAD 1.0 UTF-8
# [METADATA]
# station_id = swisscamp
# nodata = -999
# field_delimiter = ,
# [FIELDS]
# fields = timestamp,TA1,VW1,DW1
# add_value = 0,0,0,0
# scale_factor = 1,1,1,1
# [DATA]
2024-01-01T00:00:00+00:00,-21.5,11.0,120
2024-01-01T01:00:00+00:00,-22.5,12.0,125
"""


def test_nead_is_read_by_its_header(tmp_path):
    (tmp_path / "swisscamp.csv").write_text(NEAD)
    found = read_record(tmp_path / "swisscamp.csv")
    assert (found.format, found.speed.tolist()) == ("NEAD", [11.0, 12.0])
    np.testing.assert_allclose(found.temperature, [-21.5, -22.5])


def test_promice_is_known_by_its_columns(path):
    path.write_text(
        "time,p_u,t_u,rh_u,wspd_u,wdir_u,z_boom_u\n"
        "2024-01-01 00:00:00,800,-25.5,70,6.5,130,2.4\n2024-01-01 01:00:00,800,-26.5,70,7.5,131,2.4\n"
    )
    found = read_record(path)
    assert found.format.startswith("PROMICE")
    np.testing.assert_allclose(found.temperature, [-25.5, -26.5])
    assert any("z_boom_u" in remark for remark in found.remarks)


ERA5 = {"u10": "m s**-1", "v10": "m s**-1", "t2m": "K", "sf": "m of water equivalent", "tp": "m"}
MERRA2 = {"U10M": "m s-1", "V10M": "m s-1", "T2M": "K", "PRECSNO": "kg m-2 s-1"}


@pytest.mark.parametrize(("units", "fall"), [(ERA5, 1e-3), (MERRA2, 1e-3 / 3.6)], ids=["ERA5", "MERRA-2"])
def test_reanalyses_bring_temperature_and_snowfall(tmp_path, units, fall):
    """A millimetre of water an hour, 1/3600 kg/m²/s: 1 mm accumulated in the hour before, or a rate."""
    time = np.datetime64("2024-01-01T00", "ns") + np.arange(4).astype("timedelta64[h]")
    values = {"u": 3.0, "v": -4.0, "t": 263.15, "s": fall, "p": fall}
    fields = {
        name: ("time", np.full(4, values[name[0].lower() if name[0] != "P" else "s"]), {"units": unit})
        for name, unit in units.items()
    }
    if "tp" in fields:
        fields["tp"] = ("time", np.full(4, fall), {"units": "m"})
    xr.Dataset(fields, coords={"time": time}).to_netcdf(tmp_path / "point.nc", engine="h5netcdf")
    found = read_record(tmp_path / "point.nc")
    np.testing.assert_allclose(found.speed, 5.0)
    np.testing.assert_allclose(found.temperature, -10.0)
    np.testing.assert_allclose(found.snowfall[:-1] * 3600, 1.0)


@pytest.mark.parametrize(
    ("heading", "rows", "form", "said"),
    [
        ("T (°C)", ["-5", "75"], {"temperature": "T (°C)"}, r"row 3, column 'T .*': is 75 °C; allowed: -90"),
        ("fall (mm/h)", ["-1", "0"], {"snowfall": "fall (mm/h)"}, r"row 2, .*: is -1 mm/h; allowed: 0"),
        ("fall (mm/h)", ["0", "31"], {"snowfall": "fall (mm/h)"}, r"row 3, .*: is 31 mm/h; allowed: 0 to 30"),
        ("fall", ["0", "1"], {"snowfall": "fall"}, r"column 'fall': states no unit; name one"),
        ("fall (inch)", ["0", "1"], {"snowfall": "fall (inch)"}, r"is in 'inch'; inches of water"),
        ("rain (mm/h)", ["0", "1"], {"precipitation": "rain (mm/h)"}, r"is no temperature to tell snow from"),
        ("x", ["0", "1"], {"temperature": "tt"}, r"temperature: no column 'tt'; the columns are time, speed"),
        (
            "t (°C),a (mm/h),b (mm/h)",
            ["-5,0,0", "-5,1,1"],
            {"temperature": "t (°C)", "snowfall": "a (mm/h)", "precipitation": "b (mm/h)"},
            r"precipitation: is 'b \(mm/h\)', and snowfall is 'a \(mm/h\)'; allowed: one of them",
        ),
    ],
)  # fmt: skip
def test_a_stated_column_that_cannot_be_is_refused(path, heading, rows, form, said):
    with pytest.raises(RecordError, match=said):
        read_record(table(path, heading, rows), RecordFormat(**form))


def test_a_column_that_is_only_guessed_is_left_out_and_the_wind_is_read(path):
    found = read_record(table(path, "temperature (°C)", ["-5", "75"]))
    assert found.temperature is None
    assert any("temperature is not read from" in remark and "75 °C" in remark for remark in found.remarks)


def test_a_jump_within_an_hour_is_remarked_on(path):
    found = read_record(table(path, "temperature (°C)", ["-5", "-50", "-5"]))
    assert any("are K and °C mixed" in remark for remark in found.remarks)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("[DATA]\n", ""), r"is SMET, but has no \[DATA\]"),
        (("nodata = -999\n", ""), "its header states no nodata"),
        (("-8.0 9.5 250 0.0 35", "-8.0 9.5 250"), "row 10: has 4 values; allowed: 6"),
        (("units_offset = 0 273.15", "units_offset = 273.15"), "units_offset: has 5 values; allowed: 6"),
        (("tz = 1", "tz = CET"), "tz: is 'CET'; allowed: hours east of UTC"),
        (("SMET 1.1 ASCII", "SMET 1.1 BINARY"), "is binary SMET"),
        (("fields = timestamp TA VW", "fields = timestamp TA XX"), "speed: no column for the speed"),
    ],
)
def test_an_incomplete_smet_file_is_refused(tmp_path, change, said):
    (tmp_path / "bad.smet").write_text(SMET.replace(*change))
    with pytest.raises(RecordError, match=said):
        read_record(tmp_path / "bad.smet")
