"""A record of the weather alone, without a wind: temperature and snowfall over time, checked and in order."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.durations import durations
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.grids import weather_grid
from barchan.wind.records.headed import headed
from barchan.wind.records.layout import laid_out
from barchan.wind.records.reading import is_grid, refuse_unreadable
from barchan.wind.records.stations import one_place
from barchan.wind.records.tables import all_columns, column_values, words_of
from barchan.wind.records.texts import text_of
from barchan.wind.records.time_columns import time_columns
from barchan.wind.records.times import Dated, Times, seconds
from barchan.wind.records.weather_columns import WeatherColumns, weather_of


@dataclass(frozen=True)
class WeatherRecord:
    """Temperature and snowfall in the order of time, each row with its duration."""

    source: str
    time: NDArray[np.float64]
    """Beginning of each row (s) since ``start``."""
    duration: NDArray[np.float64]
    """How long it stands for (s)."""
    start: np.datetime64 | None
    """Time of the first row, where the file has dates."""
    temperature: NDArray[np.float64] | None
    """°C, NaN where a row states none."""
    snowfall: NDArray[np.float64] | None
    """kg/m²/s, NaN where a row states none."""
    remarks: tuple[str, ...]
    utc: bool = False
    """Whether times are in UTC, as the file or the user states a zone."""


def read_weather(path: Path, form: RecordFormat) -> WeatherRecord:
    """The weather in a file, a table or NetCDF by its content; whatever wind it holds is left alone.

    Raises RecordError, with file, row and column, where it cannot be used.
    """
    refuse_unreadable(path)
    dated, weather = (weather_grid if is_grid(path) else _table)(path, form)
    if weather.temperature is None and weather.snowfall is None:
        why = "; ".join(weather.remarks)
        message = f"holds neither temperature nor snowfall{f': {why}' if why else ''}"
        raise RecordError([Problem("", message)], path.name)
    return _ordered(path.name, dated, weather)


def _table(path: Path, form: RecordFormat) -> tuple[Dated, WeatherColumns]:
    source = path.name
    text = text_of(path, form.sheet)
    layout = headed(text, form, source) or laid_out(text, form, source)
    parts, hint = time_columns(layout.headings, form.time, layout.provider, source)
    table, numbers = one_place(words_of(layout, source), np.asarray(layout.numbers), layout, form, source)
    words = [table[part] for part in parts]
    times = Times(words, "+".join(parts), numbers, form, hint, source, layout.provider.utc)
    dated = seconds(times)
    weather = weather_of(
        all_columns(layout),
        form,
        layout.provider.documented,
        frozenset(parts),
        lambda claim, unit: column_values(table, claim, unit, numbers, form, source)[0],
        dated.seconds,
        numbers,
        source,
    )
    return dated, weather


def _ordered(source: str, dated: Dated, weather: WeatherColumns) -> WeatherRecord:
    """The rows in the order of time, one for each; raises RecordError for fewer than two."""
    time, start, utc = dated
    order = np.argsort(time, kind="stable")
    remarks = list(weather.remarks)
    if (np.diff(time) < 0).any():
        remarks.append("rows were not in the order of time; sorted")
    kept = order[np.append(True, np.diff(time[order]) > 0)]
    if len(kept) < len(order):
        remarks.append(f"rows of a time that was already there: {len(order) - len(kept)} dropped")
    if len(kept) < 2:
        raise RecordError([Problem("", f"holds {len(kept)} times; allowed: two or more")], source)
    first = float(time[kept[0]])
    moved = None if start is None else start + np.timedelta64(round(first), "s")
    ordered = time[kept] - first
    return WeatherRecord(
        source,
        ordered,
        durations(ordered)[1],
        moved,
        None if weather.temperature is None else weather.temperature[kept],
        None if weather.snowfall is None else weather.snowfall[kept],
        tuple(remarks),
        utc,
    )
