"""A wind that blows as it was recorded."""

from functools import lru_cache
from pathlib import Path
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.errors import Problem, RecordError, ScenarioError
from barchan.parameters import Parameters, parameter
from barchan.wind.records import SAMPLE, RecordFormat, WindRecord, read_record
from barchan.wind.records.gaps import with_gaps
from barchan.wind.records.joining import with_weather
from barchan.wind.records.weather_record import read_weather
from barchan.wind.series import Series, SeriesWind


class WeatherFile(Parameters):
    """A record whose temperature and snowfall come with the wind of another one."""

    path: str = parameter(unit="-", min_length=1, meaning="The record, a table or NetCDF.")
    columns: RecordFormat = Field(default_factory=RecordFormat, description="How it is written.")


class Recorded(SeriesWind):
    """The winds of a record, one after the other, by the run's clock, with their weather if it has any.

    Temperature and snowfall may come from a second record, joined to the wind in time.
    """

    kind_key: ClassVar[str] = "kind"

    kind: Literal["record"] = parameter("record", unit="-", meaning="Winds as they were recorded.")
    path: str | None = parameter(
        None,
        unit="-",
        min_length=1,
        meaning="The record, a table or NetCDF; by default the made-up one that ships with Barchan.",
    )
    columns: RecordFormat = Field(default_factory=RecordFormat, description="How the record is written.")
    weather: WeatherFile | None = Field(
        default=None,
        description="A second record, from which temperature and snowfall are taken, joined in time.",
    )

    @property
    def record(self) -> WindRecord:
        """The record; raises ScenarioError where it cannot be used."""
        return self.series().record

    def series(self, _seed: int = 0) -> Series:
        """The record and when its rows end; raises ScenarioError where it cannot be used."""
        source = SAMPLE if self.path is None else self.path
        changed = [_changed(file.path) for file in (self, self.weather) if file is not None]
        try:
            return _read(source, self.columns, self.weather, tuple(changed))
        except RecordError as error:
            key, file = "wind.path", source
            if isinstance(error, _WeatherError) and self.weather is not None:
                key, file = "wind.weather.path", self.weather.path
            found = [Problem(key, f"{p.key}: {p.message}" if p.key else p.message) for p in error.problems]
            raise ScenarioError(found, file) from None

    def dates(self, seconds: NDArray[np.float64]) -> NDArray[np.datetime64] | None:
        """Dates of times (s) since the start of a run, NaT beyond the record; None where it has no dates."""
        record, ends = self.series()
        if record.start is None:
            return None
        found = np.full(seconds.shape, np.datetime64("NaT"), "datetime64[s]")
        known = (seconds >= 0.0) & (seconds < ends[-1])
        rows = np.searchsorted(ends, seconds[known], "right")
        since = record.time[rows] + seconds[known] - (ends[rows] - record.duration[rows])
        found[known] = record.start.astype("datetime64[s]") + np.rint(since).astype("timedelta64[s]")
        return found

    def summary(self) -> str:
        """The wind in a few words."""
        return f"as in the record {'that ships with Barchan' if self.path is None else Path(self.path).name}"


class _WeatherError(RecordError):
    """A mistake in the record of the weather."""


def _changed(path: str | None) -> int:
    """When a file was changed last; 0 where there is none."""
    return Path(path).stat().st_mtime_ns if path is not None and Path(path).is_file() else 0


@lru_cache(maxsize=4)
def _read(
    source: str, columns: RecordFormat, weather: WeatherFile | None, _changed: tuple[int, ...]
) -> Series:
    record = read_record(source, columns)
    if weather is None:
        record = with_gaps(record)
    else:
        try:
            record = with_weather(record, read_weather(Path(weather.path), weather.columns))
        except RecordError as error:
            raise _WeatherError(error.problems, weather.path) from None
    return Series(record, np.cumsum(record.duration))
