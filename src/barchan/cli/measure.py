"""``barchan measure``: the measures of any surface, and the change between two dates of one place."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from barchan.cli.options import option
from barchan.errors import BarchanError, SurveyError

if TYPE_CHECKING:
    from barchan.survey import HeightField, Survey


@Parameter(name="*")
@dataclass(frozen=True)
class File:
    """How a file is read."""

    cell_size: Annotated[
        float | None, option("Side of a cell (m), of files without coordinates: .npy, images.")
    ] = None
    crs: Annotated[
        str | None, option("Reference system of a file that states none: EPSG:32633, or metres.")
    ] = None
    variable: Annotated[str | None, option("Variable to read in a NetCDF file of several.")] = None
    missing: Annotated[
        str | None,
        option("Numbers for cells without a height, with commas between; none if all are heights."),
    ] = None
    limits: Annotated[
        tuple[float, float] | None, option("Heights (m) of black and white, of an image.", "--range")
    ] = None
    periodic: Annotated[bool, option("Opposite edges of the file are joined.")] = False
    flatten: Annotated[
        float | None,
        option(
            "Subtract the mean over squares of this width (m): relief of the ground wider than the bedforms."
        ),
    ] = None


@Parameter(name="*")
@dataclass(frozen=True)
class Output:
    """What is written."""

    crests: Annotated[
        Path | None, option("Write the crest lines: .geojson, in the coordinates of the file.")
    ] = None
    dunes: Annotated[
        Path | None, option("Write the dunes one by one: .csv, or .geojson with their outlines.")
    ] = None
    as_json: Annotated[bool, option("Print as JSON, in SI units.", "--json")] = False
    as_csv: Annotated[bool, option("Print as CSV, in SI units.", "--csv")] = False


@Parameter(name="*")
@dataclass(frozen=True)
class Dates:
    """What is known of two dates of one place."""

    years: Annotated[float | None, option("Time between two surfaces, for speeds.")] = None
    noise: Annotated[
        float | None,
        option("Random error (m, one standard deviation) of a cell's change; estimated without it."),
    ] = None
    offset: Annotated[
        float | None,
        option("Standard error (m) of the level of one survey against the other; 0 without it."),
    ] = None


def measure(
    file: Path,
    later: Path | None = None,
    /,
    *,
    wind: float | None = None,
    step: str | None = None,
    reading: File = File(),
    output: Output = Output(),
    dates: Dates = Dates(),
) -> None:
    """Measure any surface: heights, crests, dunes; or the change between two dates of a place.

    Files are GeoTIFF (.tif), ESRI ASCII grids (.asc), points on a grid (.xyz), NetCDF (.nc), SRTM (.hgt),
    NumPy arrays (.npy, row 0 in the south), images (.png, .jpg), or the folders of runs. With two files
    of the same cells the migration and the volumes moved are printed, with standard errors.

    A measure marked with ? should not be quoted, for the reason that follows.

    Parameters
    ----------
    file
        The surface, or the earlier of two.
    later
        The same place at a later date.
    wind
        Where the resultant wind comes from, degrees clockwise from north. Without it that of the run, or
        the one for which the steeper sides are the lee.
    step
        A saved step of a run, or two of the same run with a comma between, to compare them.
    """
    if output.as_json and output.as_csv:
        raise BarchanError("--json and --csv are both given; give one of them")
    fields = _fields(file, later, step, reading)
    if len(fields) == 2:
        _compare(fields, output, dates, wind)
        return
    if told := [f"--{name}" for name, value in vars(dates).items() if value is not None]:
        raise SurveyError(f"{', '.join(told)}: for two surfaces; one is given")
    from barchan.survey import measure as measured

    _print(measured(fields[0], wind=wind), output)


def _fields(file: Path, later: Path | None, step: str | None, reading: File) -> "list[HeightField]":
    from barchan.survey import read_field

    steps = _steps(step)
    if later is None:
        sources = [(file, one) for one in steps]
    elif len(steps) == 2:
        sources = list(zip((file, later), steps, strict=True))
    else:
        sources = [(file, steps[0]), (later, steps[0])]
    found = [
        read_field(
            path,
            cell_size=reading.cell_size,
            crs=reading.crs,
            variable=reading.variable,
            missing=_numbers(reading.missing),
            limits=reading.limits,
            step=at,
            periodic=reading.periodic,
        )
        for path, at in sources
    ]
    return found if reading.flatten is None else [field.flattened(reading.flatten) for field in found]


def _steps(text: str | None) -> list[int | None]:
    try:
        found: list[int | None] = [None] if text is None else [int(part) for part in text.split(",")]
    except ValueError:
        found = []
    if len(found) not in (1, 2):
        raise SurveyError(f"--step {text}; allowed: a saved step, or two with a comma between")
    return found


def _numbers(text: str | None) -> list[float] | None:
    if text is None or text == "none":
        return None if text is None else []
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise SurveyError(f"--missing {text}; allowed: numbers with commas between, or none") from None


def _print(survey: "Survey", output: Output) -> None:
    from barchan.cli import measure_table
    from barchan.cli.terminal import console
    from barchan.survey import write_crests, write_dunes

    values, form = survey.values(), survey.landform
    written = []
    if output.crests is not None:
        written.append(write_crests(output.crests, survey))
    if output.dunes is not None:
        written.append(write_dunes(output.dunes, survey))
    if output.as_json:
        data = {
            "file": survey.field.name,
            "field": survey.field.spoken(),
            "class": {"name": form.name, "reason": form.reason},
            "measures": measure_table.as_data(values),
        }
        console.out(json.dumps(data, indent=2, ensure_ascii=False))
        return
    if output.as_csv:
        words = [("class", "class of the field", form.name, "")]
        console.out(measure_table.as_csv(values, words), end="")
        return
    console.out(survey.field.spoken())
    console.out(f"class: {form.name} ({form.reason})")
    measure_table.print_values(values, survey.field.cell_size)
    for path in written:
        console.print(str(path))


def _compare(fields: "list[HeightField]", output: Output, dates: Dates, wind: float | None) -> None:
    from barchan.cli import change_table
    from barchan.cli.terminal import console
    from barchan.survey import compare

    if output.crests is not None or output.dunes is not None or wind is not None:
        raise SurveyError("--crests, --dunes and --wind are for one surface; two are given")
    compared = compare(*fields, years=dates.years, noise=dates.noise, offset=dates.offset or 0.0)
    found = compared.findings()
    if output.as_json:
        data: dict[str, Any] = {"files": [field.name for field in fields], "field": fields[0].spoken()}
        console.out(json.dumps(data | {"change": change_table.as_data(found)}, indent=2, ensure_ascii=False))
    elif output.as_csv:
        console.out(change_table.as_csv(found), end="")
    else:
        console.out(fields[0].spoken())
        change_table.print_findings(found, fields[0].cell_size)
