"""The output of ``barchan wind``: a report to read, JSON, CSV, and the files of record and roses."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from barchan.analysis.declared_measures import Value
from barchan.cli import measure_table
from barchan.cli.terminal import console, print_note, print_warning
from barchan.errors import BarchanError
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.theory.wind_report import Subject
    from barchan.wind.records import WindRecord

Part = Literal["month", "season"]


def print_report(subject: "Subject", by: Part | None) -> None:
    """Warnings first, then the table, then remarks."""
    from barchan.cli.report import print_table
    from barchan.cli.wind_table import part_rows

    found, record = subject.found, subject.measured
    for warning in subject.warnings:
        print_warning(warning)
    parts = part_rows(record, subject.sand, found.threshold, by) if record and by else []
    print_table([*subject.table, *parts], left=True)
    for remark in subject.all_remarks:
        print_note(remark)


def print_csv(subject: "Subject", by: Part | None) -> None:
    """A row for each measure, with its doubts."""
    from barchan.cli.wind_values import words_of

    console.out(measure_table.as_csv(_values(subject, by), words_of(subject.found)), end="")


def print_json(subject: "Subject", by: Part | None, source: str, sectors: int) -> None:
    """Contents, measures, roses, and what makes them doubtful."""
    from barchan.cli.wind_values import rose_rows, words_of

    heading, rows = rose_rows(subject, sectors)
    data: dict[str, Any] = {
        "source": source,
        "contents": [{"name": name, "text": text} for name, text, _ in subject.rows],
        "classes": [
            {"name": name, "title": title, "text": text, "doubt": doubt or None}
            for name, title, text, doubt in words_of(subject.found)
        ],
        "modes": [{"value": mode, "unit": "degrees"} for mode in subject.found.variability.modes],
        "measures": measure_table.as_data(_values(subject, by)),
        "rose": {"columns": heading, "rows": rows},
        "warnings": list(subject.warnings),
        "remarks": list(subject.all_remarks),
    }
    console.out(json.dumps(data, indent=2, ensure_ascii=False))


def save_record(record: "WindRecord | None", path: Path, source: str, quiet: bool) -> None:
    """Write a record as CSV; raises BarchanError where the wind is none."""
    from barchan.wind.records.writing import write_record

    if record is None:
        raise BarchanError(f"--save-record: the wind of {source} is neither a record nor made-up storms")
    write_record(record, path)
    if not quiet:
        print_note(f"{counted(len(record), 'row')} written to {path}")


def save_rose(subject: "Subject", path: Path, sectors: int, quiet: bool) -> None:
    """Write the roses as CSV, a row a direction; raises BarchanError where that cannot be."""
    import csv

    from barchan.cli.wind_values import rose_rows

    heading, rows = rose_rows(subject, sectors)
    try:
        with path.open("w", encoding="utf-8", newline="") as opened:
            csv.writer(opened, lineterminator="\n").writerows([heading, *rows])
    except OSError as error:
        raise BarchanError(f"cannot write {path}: {error}") from None
    if not quiet:
        print_note(f"{sectors} directions written to {path}")


def _values(subject: "Subject", by: Part | None) -> list[Value]:
    from barchan.cli.wind_values import found_values, part_values, record_values

    found, record = subject.found, subject.measured
    values = [] if record is None else record_values(record, subject.sand)
    parts = part_values(record, subject.sand, found.threshold, by) if record and by else []
    return [*values, *found_values(found, subject.doubt), *parts]
