"""The layout of a table of text: where its heading is, what parts its columns, where its rows begin."""

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass

from barchan.errors import Problem, RecordError
from barchan.wind.records.claims import guess
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.providers import UNKNOWN, Provider, provider_of, provider_of_rows
from barchan.wind.records.quantities import WIND
from barchan.wind.records.time_columns import joined_columns
from barchan.wind.records.values import CALM, VARIABLE

SEPARATORS = (",", ";", "\t", "|")
BLANKS = " "
"""Stands for any number of blanks as the separator."""

HEADING_WITHIN = 300
"""Lines in which the heading is looked for."""

_MOST_UNIT_ROWS = 3
_SAMPLE = 20


@dataclass(frozen=True)
class Layout:
    """How a table is laid out."""

    separator: str
    headings: list[str]
    """Names of the columns, each once; their numbers from 1 where there is no heading."""
    above: list[list[str]]
    """Rows between the heading and the first row of data: units, kinds of mean."""
    lines: list[str]
    """The rows of data."""
    numbers: list[int]
    """Number of each row of data in the file, from 1."""
    provider: Provider
    heading_number: int | None
    """Number of the heading in the file; None where there is none."""


def laid_out(text: str, form: RecordFormat, source: str) -> Layout:
    """The layout of a table; raises RecordError where it is empty."""
    lines = text.split("\n")
    kept = [n for n in range(form.skip_rows, len(lines)) if lines[n].strip(" \t,;|\ufeff")]
    if not kept:
        raise RecordError([Problem("", "is empty")], source)
    bare = _without_heading(lines, kept, form)
    if bare is not None:
        return bare
    at, separator = _heading(lines, kept, form)
    headings = _unique(_fields(lines[kept[at]], separator))
    rest = [n for n in kept[at + 1 :] if not lines[n].lstrip().startswith("#") or _is_data(lines[n], form)]
    above = []
    for n in kept[at + 1 : at + 1 + _MOST_UNIT_ROWS]:
        fields = _fields(lines[n], separator)
        if any(map(_is_value, fields)) or len(fields) != len(headings):
            break
        above.append(fields)
        rest = [k for k in rest if k != n] if n in rest[:1] else rest
    provider = provider_of(headings, "\n".join(lines[:3])) or UNKNOWN
    data = [lines[n] for n in rest]
    return Layout(separator, headings, above, data, [n + 1 for n in rest], provider, kept[at] + 1)


def _without_heading(lines: list[str], kept: list[int], form: RecordFormat) -> Layout | None:
    """The layout of a table that begins with a row of data; None where it begins otherwise."""
    rows = [n for n in kept if not lines[n].lstrip().startswith("#")]
    sample = [lines[n] for n in rows[:_SAMPLE]]
    if not sample or not all(_is_data(line, form) for line in sample):
        return None
    provider = provider_of_rows(sample) or UNKNOWN
    separator = next((mark for mark in SEPARATORS if mark in sample[0]), BLANKS)
    count = len(_fields(sample[0], separator))
    stated = any(getattr(form, q) for q in ("time", *WIND))
    if not provider.columns or stated:
        provider = UNKNOWN
    headings = list(provider.columns) or [str(k + 1) for k in range(count)]
    if any(n < rows[0] and _known(_fields(lines[n], separator), form) > 1 for n in kept):
        return None
    return Layout(separator, headings, [], [lines[n] for n in rows], [n + 1 for n in rows], provider, None)


def _is_data(line: str, form: RecordFormat) -> bool:
    """Whether a line begins with a number or a date and has no words but such as mark a missing value."""
    words = re.findall(r"[A-Za-z]{3,}", line)
    known = {word for text in (*form.texts, *VARIABLE, *CALM) for word in re.findall(r"[a-z]{3,}", text)}
    return _begins_with_digit(line.lstrip("\" '")) and all(word.lower() in known for word in words)


def _is_value(field: str) -> bool:
    """Whether a field is a number, a date or a time, which no row of units holds."""
    return re.fullmatch(r"(?=.*\d)[-+\d/.:,TZ eE]+(?:[AP]M)?", field.strip()) is not None


def _begins_with_digit(text: str) -> bool:
    return bool(re.match(r"[-+]?\.?\d", text.strip(" \"'")))


def _heading(lines: list[str], kept: list[int], form: RecordFormat) -> tuple[int, str]:
    """Which of the lines that are not empty names the columns, and the separator of columns."""
    for at, n in enumerate(kept[:HEADING_WITHIN]):
        line = lines[n]
        marked = line.lstrip().startswith("#")
        for separator in (
            *sorted((s for s in SEPARATORS if s in line), key=line.count, reverse=True),
            BLANKS,
        ):
            fields = _fields(line, separator)
            if len(fields) < 2 or _known(fields, form) < 2:
                continue
            if (marked or separator == BLANKS) and not _same_count(
                lines, kept[at + 1 :], separator, len(fields)
            ):
                continue
            return at, separator
    first = next((at for at, n in enumerate(kept) if not lines[n].lstrip().startswith("#")), 0)
    return first, max(SEPARATORS, key=lines[kept[first]].count)


def _known(fields: Sequence[str], form: RecordFormat) -> int:
    """How many quantities a line names; many where it has a stated name or those of a known format."""
    stated = [name for name in (getattr(form, q) for q in ("time", *WIND)) if name]
    if any(joined_columns(name, fields) for name in stated) or provider_of(fields):
        return 99
    return sum(guess(list(fields), quantity) is not None for quantity in ("time", *WIND))


def _same_count(lines: list[str], after: list[int], separator: str, count: int) -> bool:
    """Whether the next row of data has as many columns as there are names."""
    row = next((lines[n] for n in after if _is_row(lines[n])), None)
    return row is not None and len(_fields(row, separator)) == count


def _is_row(line: str) -> bool:
    return _begins_with_digit(line) or bool(re.search(r"[,;\t|]\s*\"?\d", line))


def _fields(line: str, separator: str) -> list[str]:
    """The fields of a line, without quotes, blanks and the mark ``#`` of a heading."""
    line = line.strip(" \r\n") if separator != BLANKS else line.strip()
    if line.startswith("#") and not line.startswith('"'):
        line = line.lstrip("# ")
    if separator == BLANKS:
        return line.split()
    return [
        field.strip(' "\ufeff')
        for field in next(csv.reader([line], delimiter=separator, skipinitialspace=True))
    ]


def _unique(headings: list[str]) -> list[str]:
    """Names of which each is there once: a second ``MM`` is ``MM.1``."""
    seen: dict[str, int] = {}
    made = []
    for name in headings:
        count = seen.get(name, 0)
        seen[name] = count + 1
        made.append(f"{name}.{count}" if count else name)
    return made
