"""Two records joined in time: wind from one, temperature and snowfall from another."""

import numpy as np
import pytest
import xarray as xr

from barchan.errors import RecordError, ScenarioError
from barchan.wind import Recorded
from barchan.wind.records import RecordFormat, read_record
from barchan.wind.records.joining import with_weather
from barchan.wind.records.summary import weather_facts
from barchan.wind.records.weather_record import read_weather
from tests.wind.blown import segments
from tests.wind.records.weather_file import SMET


def winds(path, hours, start="2024-01-01T00:00"):
    begin = np.datetime64(start)
    rows = [f"{begin + np.timedelta64(round(60 * h), 'm')},8,270" for h in hours]
    path.write_text("\n".join(["time,speed (m/s),direction", *rows]) + "\n")
    return path


@pytest.fixture
def snow(tmp_path):
    path = tmp_path / "snow.smet"
    path.write_text(SMET)
    return path


def joined(wind, snow, **form):
    return with_weather(read_record(wind), read_weather(snow, RecordFormat(**form)))


def test_hours_of_wind_have_the_weather_of_the_three_hours_that_they_lie_in(tmp_path, snow):
    """6 mm reported at 3 h fell at 2 mm/h from 0 to 3 h, 3 mm reported at 6 h at 1 mm/h from then on."""
    found = joined(winds(tmp_path / "wind.csv", range(9)), snow)
    np.testing.assert_allclose(found.snowfall * 3600, [2, 2, 2, 1, 1, 1, 0, 0, 0], atol=1e-12)
    np.testing.assert_allclose(found.temperature, [-10] * 3 + [-16] * 6)
    assert any("joined in time" in remark for remark in found.remarks)


@pytest.mark.parametrize("hours", [(0, 2, 4, 6, 8), (0, 1, 5, 7, 8), (0, 0.5, 1, 1.5, 2, 6, 6.5, 7, 8)])
def test_all_snow_falls_however_the_intervals_differ_and_through_gaps_of_the_wind(tmp_path, snow, hours):
    """9 mm fell within the first six hours."""
    found = joined(winds(tmp_path / "wind.csv", hours), snow)
    assert (found.snowfall * found.duration).sum() == pytest.approx(9.0)
    np.testing.assert_allclose(found.time[1:], (found.time + found.duration)[:-1])


def test_a_row_of_two_hours_has_the_mean_weather_of_its_time(tmp_path, snow):
    """From 2 to 4 h: an hour of -10 °C and 2 mm/h, an hour of -16 °C and 1 mm/h."""
    found = joined(winds(tmp_path / "wind.csv", (0, 2, 4)), snow)
    assert found.temperature[1] == pytest.approx(-13.0)
    assert found.snowfall[1] * 3600 == pytest.approx(1.5)


def test_days_without_weather_are_counted_and_no_snow_falls_in_them(tmp_path, snow):
    found = joined(winds(tmp_path / "wind.csv", range(36)), snow)
    assert any("1 days of the wind of wind.csv have no weather in snow.smet" in r for r in found.remarks)
    assert np.isnan(found.temperature[20])
    assert found.snowfall[20] == 0.0


def test_a_weather_record_may_be_a_point_of_a_grid(tmp_path):
    time = np.datetime64("2024-01-01T00", "ns") + np.arange(4).astype("timedelta64[h]")
    fields = {
        "t2m": ("time", np.full(4, 263.15), {"units": "K"}),
        "PRECSNO": ("time", np.full(4, 1 / 3600), {"units": "kg m-2 s-1"}),
    }
    xr.Dataset(fields, coords={"time": time}).to_netcdf(tmp_path / "point.nc", engine="h5netcdf")
    wind = read_record(winds(tmp_path / "wind.csv", range(4)), RecordFormat(time_zone="UTC"))
    found = with_weather(wind, read_weather(tmp_path / "point.nc", RecordFormat()))
    np.testing.assert_allclose(found.temperature, -10.0)
    np.testing.assert_allclose(found.snowfall * 3600, 1.0)


def test_a_run_has_the_wind_of_one_and_the_weather_of_the_other(tmp_path, snow):
    wind = winds(tmp_path / "wind.csv", range(9))
    recorded = Recorded(kind="record", path=str(wind), weather={"path": str(snow)}, repeat=False)
    blown = segments(recorded, 0, 9, step_seconds=3600.0)
    assert sum(s.weather.snowfall * s.steps for s in blown) * 3600 == pytest.approx(9.0)
    assert blown[0].weather.temperature == -10.0


@pytest.mark.parametrize(
    ("start", "text", "said"),
    [
        ("2023-01-01T00:00", SMET, r"ends before the wind of wind.csv begins, or begins after"),
        ("2024-01-01T00:00", "time,x\n2024-01-01T00:00,1\n2024-01-01T01:00,2\n", "neither temperature nor"),
        ("2024-01-01T00:00", "time (s),ta (K)\n0,263\n3600,264\n", r"must both have dates.*wind.csv has"),
        ("2024-01-01T00:00", "time,ta (°C)\n2024-01-01T00:00,-5\n", r"holds 1 times; allowed: two or more"),
    ],
)
def test_records_that_cannot_be_joined_are_refused(tmp_path, start, text, said):
    path = tmp_path / "snow.smet"
    path.write_text(text)
    with pytest.raises(RecordError, match=said):
        joined(winds(tmp_path / "wind.csv", range(3), start), path)


def test_a_mistake_names_the_key_of_the_file_that_it_is_in(tmp_path, snow):
    wind = winds(tmp_path / "wind.csv", range(3))
    with pytest.raises(ScenarioError, match=r"wind\.weather\.path.*no such file"):
        Recorded(kind="record", path=str(wind), weather={"path": str(tmp_path / "none.csv")}).series()
    with pytest.raises(ScenarioError, match=r"wind\.path.*no such file"):
        Recorded(kind="record", path=str(tmp_path / "none.csv"), weather={"path": str(snow)}).series()


def test_gaps_of_the_wind_are_snowed_on_but_are_no_measured_calms(tmp_path, snow):
    """No row from 3 to 7 h: a calm, in which 3 mm fall until 6 h. Five hours are measured."""
    found = joined(winds(tmp_path / "wind.csv", (0, 1, 2, 7, 8)), snow)
    assert found.seconds == 9 * 3600
    assert (found.measured.seconds, found.measured.calms) == (5 * 3600, 0)
    assert (found.snowfall * found.duration)[found.supposed].sum() == pytest.approx(3.0)


def test_weather_is_summed_over_gaps_and_the_wind_is_that_of_the_measured_hours(tmp_path, snow):
    """9 mm in six hours, 2 an hour at most; temperature lasts 3, 3, 3 hours at -10, -16, -16 °C."""
    facts = weather_facts(joined(winds(tmp_path / "wind.csv", (0, 1, 2, 7, 8)), snow))
    assert facts["snowfall"] == "9 kg/m² in 6 h, at most 2 kg/m² an hour"
    assert facts["temperature"] == "mean -14.0 °C, -16.0 to -10.0 °C"
    assert facts["wind while it snows"] == "mean 8.00 m/s, by the mass that falls"


def test_a_wind_without_weather_has_no_facts_of_it(tmp_path):
    assert weather_facts(read_record(winds(tmp_path / "wind.csv", range(3)))) == {}
