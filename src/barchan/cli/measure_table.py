"""The measures of a run's last frame, as a table to read, as JSON and as CSV."""

import csv
import io
import math
from collections.abc import Sequence
from itertools import zip_longest
from typing import Any

from barchan.analysis.declared_measures import Value, in_rows
from barchan.analysis.suited_units import spoken
from barchan.cli.terminal import console

Words = tuple[str, str, str, str]
"""Name, title, text and doubt of a finding that is no number."""

MARK = "?"
"""Stands before the reason why a value should not be quoted."""


def print_values(values: list[Value], cell_size: float, step_seconds: float | None = None) -> None:
    """A line for each measure: its value in every unit, what an angle is counted from, and doubts.

    Units are those that suit cells of ``cell_size`` (m) and steps of ``step_seconds``.
    """
    lines = [
        (row[0].measure.title, _values(row, cell_size, step_seconds), row[0].doubt) for row in in_rows(values)
    ]
    titles, shown = (max(len(line[column]) for line in lines) for column in (0, 1))
    for title, text, doubt in lines:
        console.out(f"{title:{titles}}  {text:{shown}}  {f'{MARK} {doubt}' if doubt else ''}".rstrip())


def _values(row: list[Value], cell_size: float, step_seconds: float | None) -> str:
    if all(math.isnan(value.value) for value in row):
        return "–"
    text = ", ".join(spoken(value.value, value.measure.unit, cell_size, step_seconds) for value in row)
    return f"{text} {row[0].measure.reference}".rstrip()


def as_data(values: list[Value]) -> list[dict[str, Any]]:
    """A record for each measure, with its value in every unit it is declared in; null where there is none."""
    return [
        {
            "name": row[0].measure.name,
            "title": row[0].measure.title,
            "values": [{"value": _finite(value.value), "unit": value.measure.unit} for value in row],
            "reference": row[0].measure.reference or None,
            "doubt": row[0].doubt or None,
        }
        for row in in_rows(values)
    ]


def as_csv(values: list[Value], words: Sequence[Words] = ()) -> str:
    """A row for each measure, its values and their units side by side; empty where there is none.

    Findings in ``words`` follow, the text in place of the value.
    """
    rows = in_rows(values)
    most = max(map(len, rows), default=1)
    heading = ["name", "title", "value", "unit"]
    heading += [f"{word}_{number}" for number in range(2, most + 1) for word in ("value", "unit")]
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow([*heading, "reference", "doubt"])
    for row in rows:
        measure = row[0].measure
        cells: list[Any] = [measure.name, measure.title]
        for _, value in zip_longest(range(most), row):
            cells += ["", ""] if value is None else [_text(value.value), value.measure.unit]
        table.writerow([*cells, measure.reference, row[0].doubt])
    for name, title, said, doubt in words:
        table.writerow([name, title, said, *[""] * (2 * most), doubt])
    return text.getvalue()


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _text(value: float) -> str:
    return repr(value) if math.isfinite(value) else ""
