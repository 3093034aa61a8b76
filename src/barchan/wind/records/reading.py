"""Reading a wind record from whatever file it is in."""

from importlib.resources import as_file, files
from pathlib import Path

from barchan.errors import Problem, RecordError
from barchan.wind.records.checking import checked
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.grids import read_grid
from barchan.wind.records.record import WindRecord
from barchan.wind.records.tables import read_table
from barchan.wind.records.texts import NETCDF, NOT_READ, first_bytes

SAMPLE = "sample"
"""Name of the record that ships with Barchan, in place of a file."""

SAMPLE_FILE = "sample.csv.gz"

SAMPLE_HEIGHT = 10.0
"""Height (m) of the shipped record's winds, which were made up there."""

SUFFIXES = (
    ".csv",
    ".txt",
    ".tsv",
    ".dat",
    ".psv",
    ".smet",
    ".nead",
    ".xlsx",
    ".nc",
    ".nc4",
    ".netcdf",
    ".gz",
    ".grib",
    ".grb",
    ".xls",
)
"""Suffixes that are taken for a wind record where the file is not there to be looked at."""


def read_record(path: Path | str, form: RecordFormat | None = None) -> WindRecord:
    """The wind record in a file, a table or NetCDF by its content; ``sample`` is the shipped one.

    Raises RecordError, with file, row and column, where it cannot be used.
    """
    if str(path) == SAMPLE:
        with as_file(files("barchan.wind.records") / SAMPLE_FILE) as shipped:
            form = form or RecordFormat()
            height = SAMPLE_HEIGHT if form.height is None else form.height
            return read_record(shipped, form.model_copy(update={"height": height}))
    path = Path(path)
    refuse_unreadable(path)
    return checked((read_grid if is_grid(path) else read_table)(path, form or RecordFormat()))


def refuse_unreadable(path: Path) -> None:
    """Raise RecordError for a file that is not there, or of a kind that is known and not read."""
    if not path.is_file():
        raise RecordError([Problem("", "no such file")], str(path))
    head = first_bytes(path)
    why = next((why for begin, why in NOT_READ.items() if head.startswith(begin)), None)
    if why is None and head.startswith(b"SMET") and b"BINARY" in head.split(b"\n", 1)[0]:
        why = "is binary SMET; convert it to ASCII"
    if why is not None:
        raise RecordError([Problem("", why)], str(path))


def is_grid(path: Path) -> bool:
    """Whether a file is NetCDF, by its content or its suffix."""
    return first_bytes(path).startswith(NETCDF) or path.suffix.lower() in {".nc", ".nc4", ".netcdf"}


def is_record(path: Path) -> bool:
    """Whether a file is taken for a wind record: by its content, or by its suffix where it is not there.

    A text that begins with a brace is a scenario.
    """
    if not path.is_file():
        return path.suffix.lower() in SUFFIXES
    return path.suffix.lower() != ".json" and not first_bytes(path).lstrip(b"\xef\xbb\xbf \t\r\n").startswith(
        b"{"
    )
