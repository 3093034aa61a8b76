"""The change between two surfaces, as a table to read, as JSON and as CSV."""

import csv
import io
import math
from typing import TYPE_CHECKING, Any

from barchan.analysis.suited_units import number, spoken, suited
from barchan.cli.measure_table import MARK
from barchan.cli.terminal import console

if TYPE_CHECKING:
    from barchan.survey import Finding


def print_findings(findings: "list[Finding]", cell_size: float) -> None:
    """A line for each result: value, standard error, unit, and why it should not be quoted.

    Units are those that suit cells of ``cell_size`` (m).
    """
    lines = [
        (one.title, _text(one, cell_size), f"{MARK} {one.doubt}" if one.doubt else "") for one in findings
    ]
    titles, shown = (max(len(line[column]) for line in lines) for column in (0, 1))
    for title, text, doubt in lines:
        console.out(f"{title:{titles}}  {text:{shown}}  {doubt}".rstrip())


def _text(one: "Finding", cell_size: float) -> str:
    if math.isnan(one.value):
        return "–"
    if math.isnan(one.error):
        return spoken(one.value, one.unit, cell_size)
    larger = max(abs(one.value), one.error)
    shown, unit = suited(larger, one.unit, cell_size)
    size = larger / shown if shown else 1.0
    return f"{number(one.value / size)} ± {number(float(f'{one.error / size:.2g}'))} {unit}".rstrip()


def as_data(findings: "list[Finding]") -> list[dict[str, Any]]:
    """A record for each result; null where there is no value or no error."""
    return [
        {
            "name": one.name,
            "title": one.title,
            "value": one.value if math.isfinite(one.value) else None,
            "error": one.error if math.isfinite(one.error) else None,
            "unit": one.unit,
            "doubt": one.doubt or None,
        }
        for one in findings
    ]


def as_csv(findings: "list[Finding]") -> str:
    """A row for each result; empty where there is no value or no error."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["name", "title", "value", "error", "unit", "doubt"])
    for one in as_data(findings):
        table.writerow(["" if part is None else part for part in one.values()])
    return text.getvalue()
