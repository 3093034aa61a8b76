"""A wind that blows as it was recorded."""

from functools import lru_cache
from pathlib import Path
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from barchan.errors import Problem, RecordError, ScenarioError
from barchan.parameters import parameter
from barchan.wind.records import SAMPLE, RecordFormat, WindRecord, read_record
from barchan.wind.records.gaps import with_gaps
from barchan.wind.series import Series, SeriesWind


class Recorded(SeriesWind):
    """The winds of a record, one after the other, by the run's clock, with their weather if it has any."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["record"] = parameter("record", unit="-", meaning="Winds as they were recorded.")
    path: str | None = parameter(
        None,
        unit="-",
        min_length=1,
        meaning="The record, a table or NetCDF; by default the made-up one that ships with Barchan.",
    )
    columns: RecordFormat = Field(default_factory=RecordFormat, description="How the record is written.")

    @property
    def record(self) -> WindRecord:
        """The record; raises ScenarioError where it cannot be used."""
        return self.series().record

    def series(self, _seed: int = 0) -> Series:
        """The record and when its rows end; raises ScenarioError where it cannot be used."""
        source = SAMPLE if self.path is None else self.path
        file = Path(source)
        changed = file.stat().st_mtime_ns if self.path is not None and file.is_file() else 0
        try:
            return _read(source, self.columns, changed)
        except RecordError as error:
            found = [
                Problem("wind.path", f"{p.key}: {p.message}" if p.key else p.message) for p in error.problems
            ]
            raise ScenarioError(found, source) from None

    def summary(self) -> str:
        """The wind in a few words."""
        return f"as in the record {'that ships with Barchan' if self.path is None else Path(self.path).name}"


@lru_cache(maxsize=4)
def _read(source: str, columns: RecordFormat, _changed: int) -> Series:
    record = with_gaps(read_record(source, columns))
    return Series(record, np.cumsum(record.duration))
