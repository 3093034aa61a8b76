"""``barchan wind``: the effect of a wind on sand."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.aeolian.saltation import Saltation
from barchan.cli.options import group_from, options_of
from barchan.errors import BarchanError
from barchan.wind.records.format import RecordFormat

if TYPE_CHECKING:
    from barchan.cli.wind_table import Rows
    from barchan.scenario import Scenario
    from barchan.simulation import Record
    from barchan.theory.assessment import Assessment
    from barchan.wind.records import WindRecord

    SandOptions = Any
    FormatOptions = Any
else:
    SandOptions = options_of(Saltation)
    FormatOptions = options_of(RecordFormat, without=("height",))

View = Literal["roses", "thresholds", "laws"]


def wind(
    source: str = "sample",
    /,
    *,
    view: View = "roses",
    out: Path | None = None,
    supply: Annotated[float | None, Parameter(validator=Number(gte=0))] = None,
    sectors: Annotated[int, Parameter(validator=Number(gte=8, lte=360))] = 16,
    by: Literal["month", "season"] | None = None,
    weather: Path | None = None,
    weather_time_zone: str | None = None,
    save_record: Path | None = None,
    sand: Annotated[SandOptions | None, Parameter(name="*")] = None,
    form: Annotated[FormatOptions | None, Parameter(name="*")] = None,
) -> None:
    """Print and draw the effect of a wind on sand: roses, drift, the crests and dunes to expect.

    Parameters
    ----------
    source
        A wind record (a table of text, a spreadsheet or NetCDF), a scenario file, a preset's name or a
        run's folder; sample is a made-up
        record that ships with Barchan.
    view
        Draw roses, the threshold of movement against grain size, or the flux laws side by side.
    out
        The picture's file (PNG, PDF or SVG by its ending); wind-VIEW.png in the current folder without it.
    supply
        Sand spread evenly over the ground (m), for the dunes to expect; by default that of the scenario,
        and for a record both kinds are given.
    sectors
        Directions of the roses, 8 or more.
    by
        Print the drift potential of each month, or of each season, too.
    weather
        A second record, whose temperature and snowfall are joined to a wind record in time.
    weather_time_zone
        Zone of the second record's times where they state none, as +01:00 or UTC.
    save_record
        Write the record, or the storms that a scenario makes up, as CSV with temperature and snowfall.
    """
    from barchan.cli.terminal import save_picture

    grains = group_from(Saltation, sand)
    path = out or Path(f"wind-{view}.png")
    if view != "roses":
        from barchan.figures.sand import flux_laws, thresholds

        save_picture((thresholds if view == "thresholds" else flux_laws)(grains), path)
        return
    if _is_record(source):
        height = None if sand is None or sand.height is None else grains.height
        record = _joined(_read(source, form, height), weather, weather_time_zone)
        subject = _of_record(record, grains, supply, "--height")
    elif weather is not None:
        raise BarchanError(f"--weather: {source} is no wind record; a scenario names one as wind.weather")
    else:
        subject = _of_scenario(source, supply)
    if save_record is not None:
        _save_record(subject.record, save_record, source)
    _print(subject, by, source)

    from barchan.figures.roses import roses

    threshold = subject.sand.threshold_speed()
    measured = None if subject.record is None else subject.record.measured
    save_picture(roses(subject.title, subject.found, measured, threshold, sectors), path)


def _read(source: str, form: FormatOptions | None, height: float | None) -> "WindRecord":
    """A record, its speeds at a stated height (m) or at that which the file states."""
    from barchan.wind.records import read_record

    columns = group_from(RecordFormat, form)
    if height is not None:
        columns = columns.model_copy(update={"height": height})
    return read_record(source, columns)


def _joined(record: "WindRecord", weather: Path | None, zone: str | None) -> "WindRecord":
    """A record with the weather of another file, where one is named."""
    from barchan.wind.records.joining import with_weather
    from barchan.wind.records.weather_record import read_weather

    columns = group_from(RecordFormat, FormatOptions(time_zone=zone))
    return record if weather is None else with_weather(record, read_weather(weather, columns))


def _print(subject: "_Subject", by: Literal["month", "season"] | None, source: str) -> None:
    """Warnings first, then the table, then remarks."""
    from barchan.cli.report import print_table
    from barchan.cli.terminal import print_note, print_warning
    from barchan.cli.wind_table import drift_rows, part_rows

    found, record = subject.found, None if subject.record is None else subject.record.measured
    for warning in (*(record.warnings if record else ()), *found.warnings):
        print_warning(warning)
    if by and record is None:
        raise BarchanError(f"--by {by}: the winds of {source} have no dates")
    parts = part_rows(record, subject.sand, found.threshold, by) if record and by else []
    print_table([*subject.rows, *drift_rows(found), *parts], left=True)
    for remark in (*subject.remarks, *found.remarks):
        print_note(remark)
    if not found.moves:
        print_note("nothing would move: no wind exceeds the threshold")


def _save_record(record: "WindRecord | None", path: Path, source: str) -> None:
    """Write a record as CSV; raises BarchanError where the wind is none."""
    from barchan.cli.terminal import print_note
    from barchan.wind.records.writing import write_record

    if record is None:
        raise BarchanError(f"--save-record: the wind of {source} is neither a record nor made-up storms")
    write_record(record, path)
    print_note(f"{len(record)} rows written to {path}")


@dataclass(frozen=True)
class _Subject:
    """A wind that is looked at."""

    title: str
    rows: "Rows"
    found: "Assessment"
    record: "WindRecord | None"
    """The record, where the wind is one or is made up as one."""
    sand: Saltation
    remarks: tuple[str, ...] = ()
    """Assumptions made in reading it."""


def _of_record(record: "WindRecord", sand: Saltation, supply: float | None, key: str) -> _Subject:
    """A record over some sand; ``key`` is where the height of its speeds can be stated."""
    from barchan.cli.wind_table import potential_rows, record_rows, weather_rows
    from barchan.theory.assessment import assess_record
    from barchan.theory.record_remarks import is_annual
    from barchan.wind.records.summary import height_remarks

    measured = record.measured
    try:
        found = assess_record(measured, sand, supply)
    except ValueError as error:
        raise BarchanError(f"{record.source}: {error}") from None
    potential = potential_rows(found.potential, found.threshold, is_annual(measured))
    remarks = [*record.remarks, *height_remarks(record, sand.height, key)]
    if record.supposed is not None:
        remarks.append("roses, drift and potential are of the wind as measured, without gaps")
    rows = [*record_rows(measured, sand), *weather_rows(record), *potential]
    return _Subject(record.source, rows, found, record, sand, tuple(remarks))


def _of_scenario(source: str, supply: float | None) -> _Subject:
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
        subject = _of_record(record, sand, supply, "wind.columns.height")
        return replace(subject, title=title, rows=[*rows, *subject.rows])
    found = assess_winds(scenario, supply)
    if found.drift.unit == "-":
        rows.append(("weights", "polls times hop length", ""))
    rows += potential_rows(found.potential, found.threshold, annual=True)
    return _Subject(title, rows, found, None, sand)


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


def _is_record(source: str) -> bool:
    """Whether a source names a wind record rather than a scenario."""
    from barchan.wind.records.reading import SAMPLE, is_record

    return source == SAMPLE or is_record(Path(source))
