"""Made-up storms: what falls and blows is what is stated, seed by seed, and is read as it was written."""

import numpy as np
import pytest

import barchan
from barchan.simulation import Simulation
from barchan.wind import Storms
from barchan.wind.records import read_record
from barchan.wind.records.writing import write_record
from barchan.wind.storm_series import storms_of
from tests.tiny import tiny

LONG = Storms(kind="storms", days=3650.0, row_seconds=3600.0)
SHORT = {"kind": "storms", "days": 20.0, "row_seconds": 1800.0, "quiet_days": 1.0}


def test_storms_have_the_stated_distributions():
    """Of some 760 storms in ten years: means of an exponential, a lognormal, a Weibull and a normal one."""
    storms = storms_of(LONG, 3)
    n = len(storms)
    quiet = np.diff([0.0, *(end for s in storms for end in (s.start, s.end))])[:-1:2] / 86_400.0
    assert quiet.mean() == pytest.approx(4.0, abs=4 * 4.0 / n**0.5)
    hours = np.log([s.duration / 3600.0 for s in storms])
    assert hours.mean() == pytest.approx(np.log(18.0), abs=4 * 0.5 / n**0.5)
    assert hours.std() == pytest.approx(0.5, rel=0.1)
    peaks = np.array([s.peak for s in storms]) - 4.0
    assert np.mean((peaks / 11.0) ** 2) == pytest.approx(1.0, abs=4 / n**0.5)
    assert np.mean([s.temperature for s in storms]) == pytest.approx(-8.0, abs=4 * 5.0 / n**0.5)
    snow = np.array([s.snowfall for s in storms]) * 3600.0
    assert (snow.min(), snow.max()) == (pytest.approx(0.5, abs=0.02), pytest.approx(2.0, abs=0.02))


@pytest.mark.extended
def test_snow_falls_in_the_first_part_of_storms_and_none_is_lost_in_rows():
    record = LONG.record(3)
    storms = storms_of(LONG, 3)
    end = record.time[-1] + 3600.0
    fallen = sum(s.snowfall * np.clip(end - s.start, 0.0, 0.6 * s.duration) for s in storms)
    assert (record.snowfall * record.duration).sum() == pytest.approx(fallen, rel=1e-9)


def test_a_storm_peaks_in_its_middle_and_starts_from_the_quiet_wind():
    calm = Storms(kind="storms", days=60.0, row_seconds=60.0, gusts=None)
    record = calm.record(5)
    storm = storms_of(calm, 5)[0]
    inside = (record.time >= storm.start) & (record.time < storm.end)
    assert record.speed[inside].max() == pytest.approx(max(storm.peak, 3.0), rel=1e-3)
    top = record.time[inside][np.argmax(record.speed[inside])]
    assert top == pytest.approx(storm.start + storm.duration / 2, abs=120.0)
    assert record.speed[record.time < storm.start - 60.0] == pytest.approx(3.0)


def test_the_air_cools_by_the_front_and_is_never_above_freezing():
    record = Storms(kind="storms", daily_wave=0.0, warmest=5.0).record(5)
    storm = storms_of(Storms(kind="storms"), 5)[0]
    before, after = np.searchsorted(record.time, (storm.start, storm.end))
    assert record.temperature[before] - record.temperature[after] == pytest.approx(10.0, abs=0.3)
    year = Storms(kind="storms", days=365.0, row_seconds=3600.0, gusts=None)
    assert year.record(3).temperature.max() <= 0.0


def test_another_seed_makes_other_storms_and_the_same_one_the_same():
    one, again, other = (Storms(**SHORT).record(seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.speed, again.speed)
    assert not np.array_equal(one.speed, other.speed)


def test_a_written_record_is_read_as_it_was(tmp_path):
    record = Storms(**SHORT).record(1)
    write_record(record, tmp_path / "storms.csv")
    found = read_record(tmp_path / "storms.csv")
    assert found.start == record.start
    assert found.height == 10.0
    for name in ("time", "duration", "speed", "direction"):
        np.testing.assert_array_equal(getattr(found, name), getattr(record, name))


CLOCK = {"reference_speed": 12.0, "step_seconds": 5000.0}


def test_storms_and_their_weather_drive_a_run_whose_bits_do_not_depend_on_cuts():
    scenario = tiny(wind=SHORT, clock=CLOCK)
    whole, pieces = Simulation(scenario), Simulation(scenario)
    whole.advance(60)
    for steps in (1, 13, 46):
        pieces.advance(steps)
    assert whole.tally.moved > 0
    np.testing.assert_array_equal(whole.bed.sand, pieces.bed.sand)
    segments = [s for together in whole.forcing.segments(0, 345) for s in together]
    fallen = sum(s.weather.snowfall * s.seconds for s in segments)
    record = Storms(**SHORT).record(7)
    within = record.time < 345 * 5000.0
    assert fallen == pytest.approx((record.snowfall * record.duration)[within].sum(), rel=0.01)
    assert min(s.weather.temperature for s in segments) == pytest.approx(record.temperature.min(), abs=0.5)


def test_a_step_with_more_winds_than_blow_keeps_the_mass_of_snow():
    """Three winds stand for the 48 rows of a day; the day's snow is the mean of all of its rows."""
    few = tiny(wind={**SHORT, "winds": 3}, clock={"reference_speed": 12.0, "step_seconds": 86_400.0})
    segments = [s for together in Simulation(few).forcing.segments(0, 20) for s in together]
    fallen = sum(s.weather.snowfall * s.seconds for s in segments)
    record = Storms(**SHORT).record(7)
    assert fallen == pytest.approx((record.snowfall * record.duration).sum(), rel=1e-9)


def test_storms_need_a_clock():
    with pytest.raises(barchan.ScenarioError, match=r"wind\.kind: is storms, whose winds need a clock"):
        tiny(wind=SHORT)
