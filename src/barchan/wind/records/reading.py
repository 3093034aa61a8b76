"""Reading a wind record from whatever file it is in."""

from collections.abc import Callable
from importlib.resources import as_file, files
from pathlib import Path

from barchan.errors import Problem, RecordError
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.grids import read_grid
from barchan.wind.records.record import Rows, WindRecord, checked
from barchan.wind.records.tables import read_table

SAMPLE = "sample"
"""Name of the record that ships with Barchan, in place of a file."""

SAMPLE_FILE = "sample.csv.gz"

READERS: dict[str, Callable[[Path, RecordFormat], Rows]] = {
    ".csv": read_table,
    ".txt": read_table,
    ".tsv": read_table,
    ".nc": read_grid,
    ".nc4": read_grid,
    ".netcdf": read_grid,
}
"""Readers by the suffix of the file; a table may be compressed (``.csv.gz``)."""


def read_record(path: Path | str, form: RecordFormat | None = None) -> WindRecord:
    """The wind record in a file, CSV or NetCDF by its suffix; ``sample`` is the one that ships with Barchan.

    Raises RecordError, with file, row and column, where it cannot be used.
    """
    if str(path) == SAMPLE:
        with as_file(files("barchan.wind.records") / SAMPLE_FILE) as shipped:
            return read_record(shipped, form)
    path = Path(path)
    reader = _reader(path)
    if reader is None:
        allowed = f"is of an unknown kind; allowed: {', '.join(READERS)}, and tables in .gz"
        raise RecordError([Problem("", allowed)], str(path))
    if not path.is_file():
        raise RecordError([Problem("", "no such file")], str(path))
    return checked(reader(path, form or RecordFormat()))


def is_record(path: Path) -> bool:
    """Whether a file is taken for a wind record, by its suffix."""
    return _reader(path) is not None


def _reader(path: Path) -> Callable[[Path, RecordFormat], Rows] | None:
    plain = path.with_suffix("") if path.suffix.lower() == ".gz" else path
    return READERS.get(plain.suffix.lower())
