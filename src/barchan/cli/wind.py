"""``barchan wind``: the effect of a wind on sand."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.aeolian.saltation import Saltation
from barchan.cli.options import group_from, options_of
from barchan.wind.records.format import RecordFormat

if TYPE_CHECKING:
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
    sectors: Annotated[int, Parameter(validator=Number(gte=16, lte=360))] = 16,
    by: Literal["month", "season"] | None = None,
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
        Directions of the roses.
    by
        Print the drift potential of each month, or of each season, too.
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
        subject = _of_record(_read(source, form, height), grains, supply)
    else:
        subject = _of_scenario(source, supply)
    if save_record is not None:
        _save_record(subject.record, save_record, source)
    _print(subject, by)

    from barchan.figures.roses import roses

    threshold = subject.sand.threshold_speed()
    save_picture(roses(subject.title, subject.found, subject.record, threshold, sectors), path)


def _read(source: str, form: FormatOptions | None, height: float | None) -> "WindRecord":
    """A record, its speeds at a stated height (m) or at that which the file states."""
    from barchan.wind.records import read_record

    columns = group_from(RecordFormat, form)
    if height is not None:
        columns = columns.model_copy(update={"height": height})
    return read_record(source, columns)


def _print(subject: "_Subject", by: Literal["month", "season"] | None) -> None:
    """Warnings first, then the table, then remarks."""
    from barchan.cli.report import print_table
    from barchan.cli.terminal import print_note, print_warning

    found, record = subject.found, subject.record
    for warning in record.warnings if record else ():
        print_warning(warning)
    parts = _part_rows(record, subject, by) if record and by else []
    print_table([*subject.rows, *_drift_rows(found), *parts], left=True)
    for remark in (*(record.remarks if record else ()), *found.remarks):
        print_note(remark)
    if not found.moves:
        print_note("nothing would move: no wind exceeds the threshold")


def _save_record(record: "WindRecord | None", path: Path, source: str) -> None:
    """Write a record as CSV; raises BarchanError where the wind is none."""
    from barchan.cli.terminal import print_note
    from barchan.errors import BarchanError
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
    sand: Saltation


def _of_record(record: "WindRecord", sand: Saltation, supply: float | None) -> _Subject:
    from barchan.errors import BarchanError
    from barchan.theory.assessment import assess_record, is_annual

    try:
        found = assess_record(record, sand, supply)
    except ValueError as error:
        raise BarchanError(f"{record.source}: {error}") from None
    rows = [*_record_rows(record, sand), *_potential_rows(found, is_annual(record))]
    return _Subject(record.source, rows, found, record, sand)


def _of_scenario(source: str, supply: float | None) -> _Subject:
    """The wind of a scenario over its sand: its record, or its winds weighted by the sand they move."""
    from barchan.archive import run_info, source_at
    from barchan.archive.folder import SCENARIO
    from barchan.scenario.files import load_scenario
    from barchan.simulation import Record, SetWind
    from barchan.theory.assessment import assess, scenario_drift, scenario_supply
    from barchan.wind import SeriesWind

    found_at = source_at(source)
    scenario = load_scenario(found_at)
    events: tuple[Record, ...] = ()
    if isinstance(found_at, Path) and found_at.name == SCENARIO:
        known = run_info(found_at.parent)
        scenario, events = known.now, known.events
    scenario = scenario.seeded()
    sand = scenario.clock or Saltation()
    supply = scenario_supply(scenario) if supply is None else supply
    title = scenario.title or source
    rows: Rows = [
        ("scenario", title, ""),
        ("wind", scenario.wind.summary(), ""),
        *[("changed", str(record), "") for record in events if isinstance(record.event, SetWind)],
        ("sand supply", f"{supply:.3g} m", ""),
    ]
    if isinstance(scenario.wind, SeriesWind):
        subject = _of_record(scenario.wind.series(scenario.seed).record, sand, supply)
        return replace(subject, title=title, rows=[*rows, *subject.rows])
    found = assess(scenario_drift(scenario), supply=supply)
    return _Subject(title, [*rows, ("weights", "polls times hop length", "")], found, None, sand)


def _is_record(source: str) -> bool:
    """Whether a source names a wind record rather than a scenario."""
    from barchan.wind.records.reading import SAMPLE, is_record

    return source == SAMPLE or is_record(Path(source))


Rows = list[tuple[str, str, str]]


def _record_rows(record: "WindRecord", sand: Saltation) -> Rows:
    import numpy as np

    whole = len(record) + record.missing
    threshold, friction = sand.threshold_speed(), sand.threshold_friction_velocity()
    exceeds = sand.at_own_height(record.speed, record.height) > threshold
    blowing = float(record.duration[exceeds].sum()) / record.seconds
    mean = float(np.average(record.speed, weights=record.duration))
    tall = f"at {record.height:g} m" if record.height else f"taken to be at {sand.height:g} m"
    known = f", format of {record.format}" if record.format else ""
    rows: Rows = [
        ("record", f"{record.source}{known}", ""),
        ("read", f"{record.columns}, {tall}", ""),
        ("point", record.place, ""),
        ("time covered", f"{record.seconds / 86400:.6g} days{_span(record)}", ""),
        ("rows", f"{whole}, {_share(record.missing, whole)} missing, {_share(record.calms, whole)} calm", ""),
        ("wind speed", f"mean {mean:.2f} m/s, highest {record.speed.max():.1f} m/s", ""),
        ("flux law", f"{sand.law}, grains of {1e3 * sand.grain_diameter:g} mm", ""),
        ("threshold", f"{threshold:.2f} m/s at {sand.height:g} m, u* {friction:.3f} m/s", ""),
        ("exceeded", f"{100 * blowing:.1f} % of the time", ""),
    ]
    return [row for row in rows if row[1]]


def _span(record: "WindRecord") -> str:
    import numpy as np

    if record.start is None:
        return ""
    last = record.start + np.timedelta64(int(record.time[-1]), "s")
    return f", {str(record.start)[:10]} to {str(last)[:10]}"


def _potential_rows(found: "Assessment", annual: bool) -> Rows:
    from barchan.theory.drift import energy, in_metres

    potential = found.potential
    if potential is None:
        return []
    total = potential.total
    kind = f"energy {energy(total)}" if annual else "not annual"
    told = f"DP {total:.0f} VU above {found.threshold:.3g} kn ({in_metres(total):.1f} by m/s), {kind}"
    return [
        ("drift potential", told, ""),
        ("resultant", f"RDP {potential.resultant:.0f} VU, RDP/DP {_number(potential.steadiness)}", ""),
        ("", f"RDD {_toward(potential.toward)}", ""),
    ]


def _part_rows(record: "WindRecord", subject: _Subject, by: Literal["month", "season"]) -> Rows:
    """Drift potential by month or by season; raises BarchanError where the record has no dates."""
    from barchan.errors import BarchanError
    from barchan.theory.assessment import at_ten_metres
    from barchan.theory.seasons import by_part_of_year

    try:
        parts = by_part_of_year(at_ten_metres(record, subject.sand), by, subject.found.threshold)
    except ValueError as error:
        raise BarchanError(f"--by {by}: {error}") from None
    return [
        (
            part.name,
            (
                f"DP {part.potential.total:.1f} VU, RDP {part.potential.resultant:.1f} VU "
                f"{_toward(part.potential.toward)}, of {part.days:.4g} days"
            ),
            "",
        )
        for part in parts
    ]


def _drift_rows(found: "Assessment") -> Rows:
    drift = found.drift
    if not found.moves:
        return []
    rows = [] if drift.unit == "-" else [("sand flux", f"{drift.total:.1f} {drift.unit} to all sides", "")]
    share = "" if drift.unit == "-" else f"{drift.resultant:.1f} {drift.unit}, "
    modes = ", ".join(f"{mode:.0f}°" for mode in found.variability.modes)
    return [
        *rows,
        ("resultant flux", f"{share}{drift.steadiness:.2f} of all, {_toward(drift.toward)}", ""),
        ("directions", found.variability.name + (f", from {modes}" if modes else ""), ""),
        ("crests, gross transport", _crest(found.gross_transport), ""),
        ("crests, bed instability", _crest(found.bed_instability), ""),
        ("fingers of scarce sand", f"grow {_toward(found.elongation)}", ""),
        ("dunes to expect", found.dunes, ""),
    ]


def _crest(crest: Any) -> str:
    import math

    if math.isnan(crest.azimuth):
        return "none, no direction stands out"
    rivals = ", ".join(f"{rival:.0f}°" for rival in crest.rivals)
    return f"azimuth {crest.azimuth:.0f}°" + (f", ambiguous: as good are {rivals}" if rivals else "")


def _toward(angle: float) -> str:
    import math

    return "nowhere" if math.isnan(angle) else f"toward {angle:.0f}°"


def _number(value: float) -> str:
    import math

    return "–" if math.isnan(value) else f"{value:.2f}"


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} %"
