"""The wind that ``barchan wind`` looks at: a record, or that of a scenario, over its sand."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from barchan.aeolian.saltation import Saltation
from barchan.errors import BarchanError
from barchan.wind.records.format import RecordFormat

if TYPE_CHECKING:
    from barchan.cli.wind_table import Rows
    from barchan.scenario import Scenario
    from barchan.simulation import Record
    from barchan.theory.assessment import Assessment
    from barchan.wind.records import WindRecord


@dataclass(frozen=True)
class Subject:
    """A wind that is looked at."""

    title: str
    rows: "Rows"
    found: "Assessment"
    record: "WindRecord | None"
    """The record, where the wind is one or is made up as one."""
    sand: Saltation
    remarks: tuple[str, ...] = ()
    """Assumptions made in reading it."""

    @property
    def measured(self) -> "WindRecord | None":
        """The winds that were measured, without those supposed in gaps."""
        return None if self.record is None else self.record.measured

    @property
    def warnings(self) -> tuple[str, ...]:
        """What makes the wind implausible."""
        return (*(self.measured.warnings if self.measured else ()), *self.found.warnings)

    @property
    def doubt(self) -> str:
        """Why its drift potential should not be quoted; empty where all is well."""
        from barchan.theory.record_remarks import is_annual

        annual = self.measured is None or is_annual(self.measured)
        return "; ".join((*self.warnings, *(() if annual else ("not that of a year",))))

    @property
    def all_remarks(self) -> tuple[str, ...]:
        """All that a reader should know, in order."""
        still = () if self.found.moves else ("nothing would move: no wind exceeds the threshold",)
        return (*self.remarks, *self.found.remarks, *self.found.nearby, *still)


def of_record(record: "WindRecord", sand: Saltation, supply: float | None, key: str) -> Subject:
    """A record over some sand; ``key`` is where the height of its speeds can be stated."""
    from barchan.cli.wind_table import potential_rows, record_rows, weather_rows
    from barchan.theory.assessment import assess_record
    from barchan.theory.record_remarks import is_annual
    from barchan.wind.records.summary import height_remarks, weather_remarks

    measured = record.measured
    try:
        found = assess_record(measured, sand, supply)
    except ValueError as error:
        raise BarchanError(f"{record.source}: {error}") from None
    potential = potential_rows(found.potential, found.threshold, is_annual(measured))
    remarks = [*record.remarks, *height_remarks(record, sand.height, key)]
    remarks += weather_remarks(record)
    if record.supposed is not None:
        remarks.append("roses, drift and potential are of the wind as measured, without gaps")
    rows = [*record_rows(measured, sand), *weather_rows(record), *potential]
    return Subject(record.source, rows, found, record, sand, tuple(remarks))


def of_scenario(source: str, supply: float | None) -> Subject:
    """The wind of a scenario over its sand: its record, or its winds weighted by the sand they move."""
    from barchan.cli.wind_table import potential_rows
    from barchan.scenario.summary import wind_in_words
    from barchan.simulation import SetWind
    from barchan.theory.assessment import assess_winds, scenario_supply
    from barchan.wind import SeriesWind

    scenario, events = _scenario_of(source)
    sand = scenario.clock or Saltation()
    supply = scenario_supply(scenario) if supply is None else supply
    title = scenario.title or source
    rows: Rows = [
        ("scenario", title, ""),
        ("wind", wind_in_words(scenario), ""),
        *[("changed", str(record), "") for record in events if isinstance(record.event, SetWind)],
        ("sand supply", f"{supply:.3g} m", ""),
    ]
    if isinstance(scenario.wind, SeriesWind):
        record = scenario.wind.series(scenario.seed).record
        subject = of_record(record, sand, supply, "wind.columns.height")
        return replace(subject, title=title, rows=[*rows, *subject.rows])
    found = assess_winds(scenario, supply)
    if found.drift.unit == "-":
        rows.append(("weights", "polls times hop length", ""))
    rows += potential_rows(found.potential, found.threshold, annual=True)
    return Subject(title, rows, found, None, sand)


def _scenario_of(source: str) -> tuple["Scenario", tuple["Record", ...]]:
    """A scenario with a seed, as it is now where it is that of a run, and the changes during the run."""
    from barchan.archive import run_info, source_at
    from barchan.archive.folder import SCENARIO
    from barchan.scenario.files import load_scenario

    found_at = source_at(source)
    if isinstance(found_at, Path) and found_at.name == SCENARIO:
        known = run_info(found_at.parent)
        return known.now.seeded(), known.events
    return load_scenario(found_at).seeded(), ()


def names_record(source: str) -> bool:
    """Whether a source names a wind record rather than a scenario."""
    from barchan.wind.records.reading import SAMPLE, is_record

    return source == SAMPLE or is_record(Path(source))


def read(source: str, columns: RecordFormat, height: float | None) -> "WindRecord":
    """A record, its speeds at a stated height (m) or at that which the file states."""
    from barchan.wind.records import read_record

    if height is not None:
        columns = columns.model_copy(update={"height": height})
    return read_record(source, columns)


def joined(record: "WindRecord", weather: Path | None, columns: RecordFormat) -> "WindRecord":
    """A record with the weather of another file, where one is named, read as its ``columns`` say."""
    from barchan.wind.records.joining import with_weather
    from barchan.wind.records.weather_record import read_weather

    if weather is None:
        return record
    return with_weather(record, read_weather(weather, columns))
