"""The text of a table, from whatever file it is in: packed, in UTF-16, in a spreadsheet."""

import gzip
import io
import zipfile
from pathlib import Path

from barchan.errors import Problem, RecordError

GZIP = b"\x1f\x8b"
ZIP = b"PK\x03\x04"
NETCDF = (b"CDF\x01", b"CDF\x02", b"CDF\x05", b"\x89HDF\r\n\x1a\n")
NOT_READ = {
    b"GRIB": "is GRIB; convert it to NetCDF, or download it as NetCDF",
    b"\xd0\xcf\x11\xe0": "is an old Excel workbook (.xls); save it as .xlsx or .csv",
    b"BZh": "is packed with bzip2; unpack it",
    b"\xfd7zXZ": "is packed with xz; unpack it",
    b"TOB1": "is binary TOB1; convert it to TOA5 with the logger's software",
    b"TOB3": "is binary TOB3; convert it to TOA5 with the logger's software",
}
"""Beginnings of files that are known and not read, and the way out."""


def first_bytes(path: Path, count: int = 512) -> bytes:
    """The beginning of a file, unpacked where it is gzip."""
    with path.open("rb") as opened:
        head = opened.read(count)
    if head[:2] != GZIP:
        return head
    try:
        with gzip.open(path) as packed:
            return packed.read(count)
    except (OSError, EOFError):
        return head


def text_of(path: Path, sheet: str | None) -> str:
    """The text of a table; raises RecordError where it cannot be had."""
    data = path.read_bytes()
    if data[:4] == ZIP:
        return _spreadsheet(data, sheet, path.name)
    if sheet is not None:
        raise RecordError([Problem("sheet", f"is '{sheet}', but the file is no spreadsheet")], path.name)
    try:
        data = gzip.decompress(data) if data[:2] == GZIP else data
    except (OSError, EOFError) as error:
        raise RecordError([Problem("", f"cannot be unpacked: {error}")], path.name) from None
    return _decoded(data, path.name).replace("\r\n", "\n").replace("\r", "\n")


def _decoded(data: bytes, source: str) -> str:
    if data[:2] in {b"\xff\xfe", b"\xfe\xff"}:
        return data.decode("utf-16", errors="replace")
    some = data[:200]
    if some[1::2].count(0) > len(some) // 3:
        return data.decode("utf-16-le", errors="replace")
    if some[0::2].count(0) > len(some) // 3:
        return data.decode("utf-16-be", errors="replace")
    if b"\x00" in data[:10_000]:
        raise RecordError([Problem("", "is neither a table of text nor NetCDF")], source)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def _spreadsheet(data: bytes, sheet: str | None, source: str) -> str:
    """A sheet of a workbook as text parted by tabs, its dates in ISO 8601."""
    import openpyxl

    try:
        book = openpyxl.load_workbook(io.BytesIO(data), read_only=True, data_only=True)
    except (KeyError, ValueError, OSError, zipfile.BadZipFile) as error:
        message = f"is a zip archive that is no workbook ({error}); unpack it"
        raise RecordError([Problem("", message)], source) from None
    names = book.sheetnames
    if sheet is not None and sheet not in names:
        raise RecordError([Problem("sheet", f"is '{sheet}'; the sheets are {', '.join(names)}")], source)
    rows = book[sheet or names[0]].iter_rows(values_only=True)
    text = "\n".join("\t".join(map(_cell, row)) for row in rows)
    book.close()
    return text


def _cell(value: object) -> str:
    if value is None:
        return ""
    if hasattr(value, "isoformat"):
        return str(value.isoformat())
    return " ".join(str(value).split())
