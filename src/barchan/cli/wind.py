"""``barchan wind``: the effect of a wind on sand."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.aeolian.saltation import Saltation
from barchan.cli.options import group_from, group_of, option, options_of
from barchan.errors import BarchanError
from barchan.wind.records.format import RecordFormat

if TYPE_CHECKING:
    from barchan.theory.wind_report import Subject

    SandOptions = Any
    FormatOptions = Any
else:
    SandOptions = options_of(Saltation)
    FormatOptions = options_of(RecordFormat, without=("height",))

View = Literal["roses", "thresholds", "laws"]
Part = Literal["month", "season"]


@Parameter(name="*")
@dataclass(frozen=True)
class Second:
    """A second record, of the weather."""

    weather: Annotated[
        Path | None,
        option("A second record, whose temperature and snowfall are joined to a wind record in time."),
    ] = None
    weather_time_zone: Annotated[
        str | None,
        option("Zone of the second record's times where they state none, as +01:00 or UTC."),
    ] = None
    weather_missing: Annotated[
        list[float | str] | None,
        option("Numbers and texts that stand for a missing value in the second record, as with --missing."),
    ] = None

    @property
    def columns(self) -> RecordFormat:
        """How its file is to be read; raises ScenarioError for values that are not allowed."""
        stated = {"time_zone": self.weather_time_zone, "missing": self.weather_missing}
        return group_of(RecordFormat, {key: value for key, value in stated.items() if value is not None})


@Parameter(name="*")
@dataclass(frozen=True)
class Output:
    """What is written."""

    out: Annotated[
        Path | None,
        option(
            "The picture's file (PNG, PDF or SVG by its ending); wind-VIEW.png in the current folder without "
            "it, and none with --json or --csv."
        ),
    ] = None
    save_record: Annotated[
        Path | None,
        option(
            "Write the record, or the storms that a scenario makes up, as CSV with temperature and snowfall."
        ),
    ] = None
    save_rose: Annotated[
        Path | None,
        option("Write the roses as CSV: sand moved and time by the direction that winds come from."),
    ] = None
    as_json: Annotated[bool, option("Print as JSON, in SI units, with the roses.", "--json")] = False
    as_csv: Annotated[bool, option("Print as CSV, in SI units, a row a measure.", "--csv")] = False


def wind(
    source: str = "sample",
    /,
    *,
    view: View = "roses",
    supply: Annotated[float | None, Parameter(validator=Number(gte=0))] = None,
    sectors: Annotated[int, Parameter(validator=Number(gte=8, lte=360))] = 16,
    by: Part | None = None,
    second: Second = Second(),
    output: Output = Output(),
    sand: Annotated[SandOptions | None, Parameter(name="*")] = None,
    form: Annotated[FormatOptions | None, Parameter(name="*")] = None,
) -> None:
    """Print and draw the effect of a wind on sand: roses, drift, the crests and dunes to expect.

    A number marked with a doubt, in CSV and JSON, should not be quoted, for the reason given.

    Parameters
    ----------
    source
        A wind record (a table of text, a spreadsheet or NetCDF), a scenario file, a preset's name or a
        run's folder; sample is a made-up
        record that ships with Barchan.
    view
        Draw roses, the threshold of movement against grain size, or the flux laws side by side.
    supply
        Sand spread evenly over the ground (m), for the dunes to expect; by default that of the scenario,
        and for a record both kinds are given.
    sectors
        Directions of the roses, 8 or more.
    by
        Print the drift potential of each month, or of each season, too.
    """
    from barchan.cli import wind_output

    grains = group_from(Saltation, sand)
    if output.as_json and output.as_csv:
        raise BarchanError("--json and --csv are both given; give one of them")
    if view != "roses":
        _draw_law(grains, view, output)
        return
    subject = _subject(source, second, sand, form, grains, supply)
    if by and subject.record is None:
        raise BarchanError(f"--by {by}: the winds of {source} have no dates")
    if output.save_record is not None:
        wind_output.save_record(subject.record, output.save_record, source, quiet=_printed(output))
    if output.save_rose is not None:
        wind_output.save_rose(subject, output.save_rose, sectors, quiet=_printed(output))
    if output.as_json:
        wind_output.print_json(subject, by, source, sectors)
    elif output.as_csv:
        wind_output.print_csv(subject, by)
    else:
        wind_output.print_report(subject, by)
    _draw_roses(subject, output, sectors)


def _subject(
    source: str,
    second: Second,
    sand: SandOptions | None,
    form: FormatOptions | None,
    grains: Saltation,
    supply: float | None,
) -> "Subject":
    from barchan.cli.wind_subject import joined, names_record, of_scenario, read
    from barchan.theory.wind_report import of_record

    if names_record(source):
        height = None if sand is None or sand.height is None else grains.height
        record = read(source, group_from(RecordFormat, form), height)
        record = joined(record, second.weather, second.columns)
        return of_record(record, grains, supply, "--height")
    if second.weather is not None:
        raise BarchanError(f"--weather: {source} is no wind record; a scenario names one as wind.weather")
    return of_scenario(source, supply)


def _printed(output: Output) -> bool:
    """Whether numbers are printed for other programs, so that nothing else may be."""
    return output.as_json or output.as_csv


def _draw_law(grains: Saltation, view: View, output: Output) -> None:
    from barchan.cli.terminal import save_picture
    from barchan.figures.sand import flux_laws, thresholds

    if _printed(output):
        raise BarchanError(f"--view {view} is a picture; --json and --csv are for the roses")
    draw = thresholds if view == "thresholds" else flux_laws
    save_picture(draw(grains), output.out or Path(f"wind-{view}.png"))


def _draw_roses(subject: "Subject", output: Output, sectors: int) -> None:
    from barchan.cli.terminal import save_picture

    if _printed(output) and output.out is None:
        return
    from barchan.figures.roses import roses

    threshold = subject.sand.threshold_speed()
    drawn = roses(subject.title, subject.found, subject.measured, threshold, sectors)
    save_picture(drawn, output.out or Path("wind-roses.png"), quiet=_printed(output))
