"""Two records joined in time: the wind of one, and the temperature and snowfall of another."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.gaps import all_rows, bridged, filled, holes, joined_rows
from barchan.wind.records.record import WindlessRows, WindRecord
from barchan.wind.records.weather_record import WeatherRecord

DAY = 86_400.0
"""A day (s)."""


def with_weather(record: WindRecord, weather: WeatherRecord) -> WindRecord:
    """A wind record with the weather of another one, and without gaps, for snow falls and ages in them too.

    Each row has the mean temperature and the mean snowfall of its time, so that masses are kept however the
    intervals of both differ. Gaps of the wind are cut where the weather changes. What the weather record
    lacks, temperature or snowfall, is the wind record's own. Where it ends or has a gap no snow falls, and
    its temperature goes on straight over three hours at most. Raises RecordError where the two share no
    time, or one states its time zone and the other does not.
    """
    shift = _shift(record, weather)
    rows = joined_rows(all_rows(record), _cut(holes(record), weather.time + shift))
    begin, end = rows.time, rows.time + rows.duration
    shared = _integral(weather, np.ones(len(weather.time)), begin - shift, end - shift)
    if not (shared > 0.0).any():
        message = f"ends before the wind of {record.source} begins, or begins after its end"
        raise RecordError([Problem("", message)], weather.source)
    temperature, snowfall = rows.temperature, rows.snowfall
    if weather.temperature is not None:
        means = _means(weather, weather.temperature, begin - shift, end - shift)
        temperature = bridged(means, (begin + end) / 2)
    if weather.snowfall is not None:
        known = np.where(np.isnan(weather.snowfall), 0.0, weather.snowfall)
        snowfall = _integral(weather, known, begin - shift, end - shift) / rows.duration
    rows = replace(rows, temperature=temperature, snowfall=snowfall)
    told = _told(record, weather, float((rows.duration - shared).sum()) / DAY)
    return replace(filled(rows, ~np.isnan(rows.speed)), remarks=(*record.remarks, *weather.remarks, *told))


def _told(record: WindRecord, weather: WeatherRecord, outside: float) -> list[str]:
    parts = ("temperature", weather.temperature), ("snowfall", weather.snowfall)
    taken = " and ".join(name for name, values in parts if values is not None)
    zone = (
        "both are in UTC" if record.utc else "neither states a time zone, so that both are taken to be in one"
    )
    said = [f"{taken}: from {weather.source}, joined in time; {zone}"]
    if outside > 1e-6:
        said.append(f"{outside:.3g} days of the wind of {record.source} have no weather in {weather.source}")
    return said


def _shift(record: WindRecord, weather: WeatherRecord) -> float:
    """Time (s) from the first row of the wind to the first row of the weather."""
    if (record.start is None) != (weather.start is None):
        dated = weather.source if record.start is None else record.source
        message = f"and {record.source} must both have dates, or both count their times; {dated} has dates"
        raise RecordError([Problem("", message)], weather.source)
    if record.start is None or weather.start is None:
        return 0.0
    if record.utc != weather.utc:
        raise RecordError([Problem("time_zone", _zones(record, weather))], weather.source)
    return float((weather.start - record.start) / np.timedelta64(1, "s"))


def _zones(record: WindRecord, weather: WeatherRecord) -> str:
    """That one of two records states its zone alone, and where to state the other's."""
    one, other = (record.source, weather.source) if record.utc else (weather.source, record.source)
    option, key = (
        ("weather-time-zone", "wind.weather.columns") if record.utc else ("time-zone", "wind.columns")
    )
    return (
        f"times of {one} state their zone (and are read in UTC), those of {other} do not; state the zone of "
        f"{other}, as --{option}=+01:00 (in a scenario {key}.time_zone)"
    )


def _cut(gaps: WindlessRows, edges: NDArray[np.float64]) -> WindlessRows:
    """Gaps cut at the edges (s) that lie in them."""
    begins, ends = [], []
    for begin, duration in zip(gaps.time.tolist(), gaps.duration.tolist(), strict=True):
        inside = edges[(edges > begin) & (edges < begin + duration)].tolist()
        begins += [begin, *inside]
        ends += [*inside, begin + duration]
    time = np.array(begins)
    unknown = np.full(len(time), np.nan)
    return WindlessRows(time, np.array(ends) - time, unknown, np.zeros(len(time)))


def _integral(
    weather: WeatherRecord, values: NDArray[np.float64], begin: NDArray[np.float64], end: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The values of the weather's rows times the time (s) that they last between two moments."""
    moments = np.stack([weather.time, weather.time + weather.duration], axis=1).ravel()
    sums = np.repeat(np.append(0.0, np.cumsum(values * weather.duration)), 2)[1:-1]
    found: NDArray[np.float64] = np.interp(end, moments, sums) - np.interp(begin, moments, sums)
    return found


def _means(
    weather: WeatherRecord, values: NDArray[np.float64], begin: NDArray[np.float64], end: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Means over the time for which values are known; NaN where none is."""
    known = ~np.isnan(values)
    sums = _integral(weather, np.where(known, values, 0.0), begin, end)
    lasting = _integral(weather, known.astype(np.float64), begin, end)
    enough = lasting > 1e-6
    return np.where(enough, sums / np.where(enough, lasting, 1.0), np.nan)
