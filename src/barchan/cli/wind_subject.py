"""The wind that ``barchan wind`` looks at: a record, or that of a scenario, over its sand."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from barchan.wind.records.format import RecordFormat

if TYPE_CHECKING:
    from barchan.scenario import Scenario
    from barchan.simulation import Record
    from barchan.theory.wind_report import Subject
    from barchan.theory.wind_table import Rows
    from barchan.wind.records import WindRecord


def of_scenario(source: str, supply: float | None) -> "Subject":
    """The wind of a scenario over its sand: its record, or its winds weighted by the sand they move."""
    from barchan.scenario.summary import wind_in_words
    from barchan.simulation import SetWind
    from barchan.theory.assessment import scenario_supply
    from barchan.theory.wind_report import of_winds

    scenario, events = _scenario_of(source)
    supply = scenario_supply(scenario) if supply is None else supply
    title = scenario.title or source
    rows: Rows = [
        ("scenario", title, ""),
        ("wind", wind_in_words(scenario), ""),
        *[("changed", str(record), "") for record in events if isinstance(record.event, SetWind)],
        ("sand supply", f"{supply:.3g} m", ""),
    ]
    subject = of_winds(scenario, supply)
    return replace(subject, title=title, rows=[*rows, *subject.rows])


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
