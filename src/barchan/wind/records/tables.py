"""Wind records in tables of text and spreadsheets."""

import io
import re
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.wall import REFERENCE_HEIGHT
from barchan.errors import Problem, RecordError
from barchan.wind.records.boom import boom_of, brought_to_ten_metres
from barchan.wind.records.choice import Choice, choose
from barchan.wind.records.claims import Claim, Column, claims_of
from barchan.wind.records.commas import with_points
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.headed import headed
from barchan.wind.records.layout import BLANKS, Layout, laid_out
from barchan.wind.records.record import Rows
from barchan.wind.records.stations import one_place
from barchan.wind.records.texts import text_of
from barchan.wind.records.time_columns import time_columns
from barchan.wind.records.times import Times, seconds
from barchan.wind.records.units import ANGLE, SPEED
from barchan.wind.records.values import Unit, numbers_of, unit_of, wind_of, without_codes
from barchan.wind.records.weather_columns import weather_of

if TYPE_CHECKING:
    import pandas as pd


def read_table(path: Path, form: RecordFormat) -> Rows:
    """The rows of a table; raises RecordError where it is none."""
    source = path.name
    text = text_of(path, form.sheet)
    layout = headed(text, form, source) or laid_out(text, form, source)
    parts, hint, choice = _found(layout, form, source)
    table, numbers = one_place(words_of(layout, source), np.asarray(layout.numbers), layout, form, source)
    name = "+".join(parts)
    times = Times([table[part] for part in parts], name, numbers, form, hint, source, layout.provider.utc)
    time, start, utc = seconds(times)
    measured, calm, units = [], np.zeros(len(table), bool), []
    for claim in (choice.first, choice.second):
        unit = unit_of(claim, form, source)
        values, still = column_values(table, claim, unit, numbers, form, source)
        measured.append(values * unit.size)
        units.append(unit)
        calm |= still
    speed, direction = wind_of(choice, measured[0], measured[1], form)
    provider = layout.provider
    height, told = choice.height, ""
    boom = boom_of(choice.first.column, layout.headings, form, source)
    if boom is not None:
        claim = Claim(boom, "boom_height", "m", None, "")
        tall = column_values(table, claim, Unit("m", 1.0), numbers, form, source)[0]
        speed, told = brought_to_ten_metres(speed, tall, boom, numbers, source)
        height = REFERENCE_HEIGHT
    weather = weather_of(
        all_columns(layout),
        form,
        provider.documented,
        frozenset((*parts, choice.first.column, choice.second.column)),
        lambda claim, unit: column_values(table, claim, unit, numbers, form, source)[0],
        time,
        numbers,
        source,
    )
    said = [*(unit.remark for unit in units), *choice.remarks, told or provider.remark, *weather.remarks]
    return Rows(
        source,
        time,
        start,
        np.where(calm & np.isnan(speed), 0.0, speed),
        direction,
        {**choice.names, "time": name},
        numbers,
        (units[0].name, units[0].size),
        tuple(filter(None, said)),
        height,
        provider.name,
        weather.temperature,
        weather.snowfall,
        provider.several_reports,
        unit_stated=units[0].stated,
        utc=utc,
    )


def _found(layout: Layout, form: RecordFormat, source: str) -> tuple[list[str], str | None, Choice]:
    """The columns of the time, how it is written, and those of the wind; RecordError names all absent."""
    problems: list[Problem] = []
    parts: list[str] = []
    hint = None
    try:
        parts, hint = time_columns(layout.headings, form.time, layout.provider, source)
    except RecordError as error:
        problems += error.problems
    claims = claims_of(all_columns(layout), form, layout.provider.documented, frozenset(parts))
    try:
        choice = choose(claims, form, layout.headings, source)
    except RecordError as error:
        problems += error.problems
    if problems and layout.heading_number is None:
        message = (
            f"has no heading; state its {len(layout.headings)} columns by number, as in time 1, speed 2, "
            "direction 3, and the unit of counted times as time_format"
        )
        raise RecordError([Problem("", message)], source)
    if problems:
        raise RecordError(problems, source)
    return parts, hint, choice


def all_columns(layout: Layout) -> list[Column]:
    """The columns with the units and kinds of mean that rows below the heading state."""
    ranked = sorted(layout.above, key=lambda row: -sum(map(_is_unit, row)))
    units = ranked[0] if ranked and any(map(_is_unit, ranked[0])) else [""] * len(layout.headings)
    others = [row for row in layout.above if row is not units]
    described = [" ".join(words) for words in zip(*others, strict=True)] if others else [""] * len(units)
    return [
        Column(name, unit, description=text)
        for name, unit, text in zip(layout.headings, units, described, strict=True)
    ]


def _is_unit(text: str) -> bool:
    return any(kind.unit_of(text) or kind.why_useless(text) for kind in (SPEED, ANGLE))


def words_of(layout: Layout, source: str) -> "pd.DataFrame":
    """All columns as words."""
    import pandas as pd

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", pd.errors.ParserWarning)
            return pd.read_csv(
                io.StringIO("\n".join(layout.lines)),
                sep=r"\s+" if layout.separator == BLANKS else layout.separator,
                header=None,
                names=layout.headings,
                skip_blank_lines=False,
                skipinitialspace=True,
                keep_default_na=False,
                index_col=False,
                dtype=str,
            ).fillna("")
    except pd.errors.ParserWarning:
        message = "has rows with more values than the heading has names"
        raise RecordError([Problem("", message)], source) from None
    except (pd.errors.ParserError, pd.errors.EmptyDataError) as error:
        raise RecordError(
            [Problem("", f"cannot be read as a table: {_said(error, layout)}")], source
        ) from None


def _said(error: Exception, layout: Layout) -> str:
    """The words of a reader of tables, with the row's number in the file."""
    said = str(error).strip().removeprefix("Error tokenizing data. C error: ")
    return re.sub(r"line (\d+)", lambda found: f"row {layout.numbers[int(found[1]) - 1]}", said)


def column_values(
    table: "pd.DataFrame",
    claim: Claim,
    unit: Unit,
    numbers: NDArray[np.int64],
    form: RecordFormat,
    source: str,
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """A column in its own unit, NaN where a value is missing or marked as wrong, and which rows are calm."""
    words, stated = table[claim.column], claim.stated
    if stated is not None and stated.part is not None:
        words = _part(words, stated.part)
    else:
        words = with_points(words, claim.column, numbers, form.codes, source)
    values, calm = numbers_of(words.rename(claim.column), claim, unit, numbers, source, form.texts)
    values = without_codes(values, claim, form)
    if stated is not None and stated.doubt is not None:
        column, part, wrong = stated.doubt
        if column in table:
            marks = table[column] if part is None else _part(table[column], part)
            values = np.where(marks.str.strip().isin(wrong), np.nan, values)
    return values, calm


def _part(words: "pd.Series", part: int) -> "pd.Series":
    """A part of words that commas part."""
    return words.str.split(",").str.get(part).fillna("")
