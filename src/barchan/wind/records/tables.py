"""Wind records in tables of text: CSV, also compressed, with commas, semicolons or tabs."""

import gzip
import io
import re
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.columns import UNIT_OF_NAME, allowed_units, guess, speed_unit, split
from barchan.wind.records.format import UNITS, RecordFormat
from barchan.wind.records.record import Rows
from barchan.wind.records.times import seconds

if TYPE_CHECKING:
    import pandas as pd

NO_VALUE = ["", "-", "--", "M", "NA", "N/A", "NaN", "nan", "null", "None", "missing"]
"""Words that stand for a missing value."""

VARIABLE = ["VRB", "990", "990.0"]
"""Codes of a wind without a certain direction; 990 is that of weather services."""

HEADING_WITHIN = 60
"""Lines in which the heading is looked for."""


def read_table(path: Path, form: RecordFormat) -> Rows:
    """The rows of a table; raises RecordError where it is none."""
    text = _text(path)
    first, separator = _heading(text, form, path.name)
    table = _table(text, first, separator, path.name)
    names = _names(list(table.columns), form, path.name)
    numbers = np.asarray(table.index, np.int64) + first + 2
    unit, remarks = _unit(names["speed"], form, path.name)
    speed = _numbers(table[names["speed"]], numbers, form, NO_VALUE, path.name) * UNITS[unit]
    direction = _numbers(table[names["direction"]], numbers, form, [*NO_VALUE, *VARIABLE], path.name)
    parts = [table[part] for part in names["time"].split("+")]
    time, start = seconds(parts, names["time"], numbers, form.time_format, path.name)
    return Rows(path.name, time, start, speed, direction, names, numbers, (unit, UNITS[unit]), remarks)


def _text(path: Path) -> str:
    data = path.read_bytes()
    try:
        data = gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
    except (OSError, EOFError) as error:
        raise RecordError([Problem("", f"cannot be unpacked: {error}")], path.name) from None
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def _heading(text: str, form: RecordFormat, source: str) -> tuple[int, str]:
    """Number of the line (from 0) that names the columns, and the separator of columns."""
    stated = [name for name in (form.time, form.speed, form.direction) if name]
    lines = text.split("\n", HEADING_WITHIN)[:HEADING_WITHIN]
    filled = [number for number, line in enumerate(lines) if line.strip() and not line.startswith("#")]
    if not filled:
        raise RecordError([Problem("", "is empty")], source)
    for number in filled:
        separator = max(",;\t", key=lines[number].count)
        headings = [heading.strip(' "\r') for heading in lines[number].split(separator)]
        known = [q for q in ("time", "speed", "direction") if guess(headings, q)]
        if len(known) > 1 or any(part in headings for name in stated for part in name.split("+")):
            return number, separator
    return filled[0], max(",;\t", key=lines[filled[0]].count)


def _table(text: str, first: int, separator: str, source: str) -> "pd.DataFrame":
    import pandas as pd

    body = text.split("\n", first)[-1] if first else text
    sample = body.split("\n", 3)[1:3]
    comma = separator != "," and any(re.search(r"\d,\d", line) for line in sample)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", pd.errors.ParserWarning)
            table = pd.read_csv(
                io.StringIO(body),
                sep=separator,
                decimal="," if comma else ".",
                skip_blank_lines=False,
                skipinitialspace=True,
                keep_default_na=False,
                na_values=NO_VALUE,
                index_col=False,
                low_memory=False,
            )
    except pd.errors.ParserWarning:
        raise RecordError(
            [Problem("", "has rows with more values than the heading has names")], source
        ) from None
    except (pd.errors.ParserError, pd.errors.EmptyDataError) as error:
        said = str(error).strip().removeprefix("Error tokenizing data. C error: ")
        said = re.sub(r"line (\d+)", lambda found: f"row {int(found[1]) + first}", said)
        raise RecordError([Problem("", f"cannot be read as a table: {said}")], source) from None
    table.columns = [str(name).strip() for name in table.columns]
    return table.dropna(how="all")


def _names(headings: list[str], form: RecordFormat, source: str) -> dict[str, str]:
    """Names of time, speed and direction in the table."""
    names, problems = {}, []
    for quantity in ("time", "speed", "direction"):
        stated = getattr(form, quantity)
        name = stated or guess(headings, quantity)
        absent = [part for part in (name or "").split("+") if part not in headings]
        if absent:
            what = f"no column '{absent[0]}'" if stated else f"no column for the {quantity}"
            problems.append(Problem(quantity, f"{what}; the columns are {', '.join(headings)}"))
        else:
            names[quantity] = str(name)
    if problems:
        raise RecordError(problems, source)
    return names


def _unit(heading: str, form: RecordFormat, source: str) -> tuple[str, tuple[str, ...]]:
    """Unit of the speeds, and the assumptions made."""
    name, spelling = split(heading)
    if form.unit:
        return form.unit, ()
    if not spelling:
        unit = UNIT_OF_NAME.get(name)
        return unit or "m/s", () if unit else (f"column '{heading}' states no unit; taken as m/s",)
    found = speed_unit(spelling)
    if found is None:
        message = f"is in '{spelling}'; allowed: {allowed_units()}"
        raise RecordError([Problem(f"column '{heading}'", message)], source)
    return found, ()


def _numbers(
    column: "pd.Series", rows: NDArray[np.int64], form: RecordFormat, words: list[str], source: str
) -> NDArray[np.float64]:
    """A column as numbers, NaN where a value is missing; raises RecordError at a word that is no number."""
    import pandas as pd

    values = pd.to_numeric(column, errors="coerce").to_numpy(np.float64, copy=True)
    strange = np.isnan(values) & column.notna().to_numpy()
    for row in np.flatnonzero(strange):
        word = str(column.iloc[row]).strip()
        if word not in words:
            where = f"row {rows[row]}, column '{column.name}'"
            raise RecordError([Problem(where, f"is '{word}'; allowed: numbers, or nothing")], source)
    codes = [*form.missing, *(float(word) for word in words if word.isdigit())]
    values[np.isin(values, codes) | ~np.isfinite(values)] = np.nan
    return values
