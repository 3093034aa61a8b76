"""Tables as CSV, units in the headings."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np


def heading(name: str, unit: str) -> str:
    """The heading of a column, with its unit: (1) for ratios, nothing for counts and words."""
    return name if unit in ("-", "") else f"{name} ({unit})"


def write_table(path: Path, headings: Sequence[str], rows: Iterable[Sequence[Any]]) -> None:
    """Write rows; cells without a value stay empty."""
    with path.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(headings)
        table.writerows([cell(value) for value in row] for row in rows)


def cell(value: Any) -> Any:
    """A value as a cell of a table: numbers in full, empty where there is none."""
    if value is None:
        return ""
    if isinstance(value, float | np.floating):
        return repr(float(value)) if np.isfinite(value) else ""
    return value
