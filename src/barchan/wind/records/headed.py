"""Tables that begin with a header of keys and values: SMET 0.9 to 1.2 and NEAD (GC-Net, EnviDat)."""

import math
from dataclasses import dataclass

from barchan.errors import Problem, RecordError
from barchan.wind.records.claims import Documented, Stated
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.layout import Layout
from barchan.wind.records.providers import Provider
from barchan.words import counted

SMET, NEAD = "SMET", "NEAD"

_TIMES = ("timestamp", "time", "datetime")

_SMET: Documented = {
    "speed": (Stated("VW", "m/s"),),
    "direction": (Stated("DW", "deg"),),
    "temperature": (Stated("TA", "K"),),
    "snowfall": (Stated("PSUM_S", "mm"),),
    "precipitation": (Stated("PSUM", "mm"), Stated("PINT", "mm/h")),
    "rain_share": (Stated("PSUM_PH", "1"),),
    "snow_depth": (Stated("HS", "m"),),
}
"""Columns and units that the documentation of SMET fixes; amounts are those since the row before."""

_NEAD: Documented = {
    "speed": tuple(Stated(name, "m/s") for name in ("VW", "VW1", "VW2", "wspd_u", "windspeed1")),
    "direction": tuple(Stated(name, "deg") for name in ("DW", "DW1", "DW2", "wdir_u", "winddir1")),
    "temperature": tuple(Stated(name, "°C") for name in ("TA1", "TA2", "TA", "t_u", "airtemp1")),
}
"""Columns of the GC-Net stations, whose temperatures are in °C."""

_FACTORS, _OFFSETS = ("units_multiplier", "scale_factor"), ("units_offset", "add_value")
"""Keys of the factors of the fields, and of what is added after them, in SMET and in NEAD."""


@dataclass(frozen=True)
class _Header:
    """The header of a file."""

    name: str
    keys: dict[str, str]
    data: int
    """Index of the first line of data."""


@dataclass(frozen=True)
class _Fields:
    """How the values of the fields are to be read."""

    names: list[str]
    factors: list[float]
    offsets: list[float]
    absent: list[float]
    """Numbers for no data, as the file has them: that of the header and those that the user states."""
    zone: str
    """What times end with."""


def headed(text: str, form: RecordFormat, source: str) -> Layout | None:
    """The layout of a SMET or NEAD file; None for any other.

    Values are brought to their documented units (first the factors, then the offsets), values without data
    are emptied, and times get the zone of the header. Raises RecordError where header or rows are incomplete.
    """
    first = text.lstrip("\ufeff").split("\n", 1)[0].lstrip("# ").split()
    if not first or first[0] not in (SMET, NEAD):
        return None
    if "BINARY" in first:
        raise RecordError([Problem("row 1", "is binary SMET; convert it to ASCII")], source)
    header = _header(text, first[0], source)
    fields = _fields(header, form, source)
    lines, numbers = [], []
    for at, line in enumerate(text.split("\n")[header.data :], start=header.data + 1):
        stripped = line.strip()
        if stripped and stripped[0] not in "#;":
            lines.append(",".join(_values(_words(stripped, header), fields, at, source)))
            numbers.append(at)
    if not lines:
        raise RecordError([Problem("", "holds no rows of data")], source)
    return Layout(",", fields.names, [], lines, numbers, _provider(header, fields, source), header.data)


def _provider(header: _Header, fields: _Fields, source: str) -> Provider:
    """The format, as far as its documented columns are there."""
    time = next((name for name in fields.names if name.lower() in _TIMES), None)
    if time is None:
        message = f"no field of times (timestamp); the fields are {', '.join(fields.names)}"
        raise RecordError([Problem("time", message)], source)
    documented = {
        quantity: tuple(column for column in columns if column.column in fields.names)
        for quantity, columns in (_SMET if header.name == SMET else _NEAD).items()
    }
    return Provider(
        header.name,
        documented={quantity: columns for quantity, columns in documented.items() if columns},
        times=((time,),),
        remark=f"{header.name} does not state the height of the wind; state it as height",
        utc="tz" in header.keys and not fields.zone,
    )


def _header(text: str, name: str, source: str) -> _Header:
    keys: dict[str, str] = {}
    marked = text.lstrip("\ufeff").startswith("#")
    for at, line in enumerate(text.split("\n")):
        plain = line.lstrip("# ").strip() if marked else line.strip()
        if plain.upper() == "[DATA]":
            absent = [key for key in ("fields", "nodata") if key not in keys]
            if absent:
                raise RecordError([Problem("", f"its header states no {key}") for key in absent], source)
            return _Header(name, keys, at + 1)
        key, equals, value = plain.partition("=")
        if equals:
            keys[key.strip().lower()] = value.strip()
    raise RecordError([Problem("", f"is {name}, but has no [DATA]")], source)


def _fields(header: _Header, form: RecordFormat, source: str) -> _Fields:
    names = _words(header.keys["fields"], header)
    nodata = _number(header.keys["nodata"])
    if nodata is None:
        message = f"is '{header.keys['nodata']}'; allowed: a number"
        raise RecordError([Problem("nodata", message)], source)
    factors, offsets = (_per_field(header, names, *s, source) for s in ((_FACTORS, 1.0), (_OFFSETS, 0.0)))
    return _Fields(names, factors, offsets, [nodata, *form.stated_codes], _zone(header, source))


def _words(text: str, header: _Header) -> list[str]:
    mark = header.keys.get("field_delimiter", header.keys.get("column_delimiter", "")).strip("\"'")
    words = text.split(mark) if mark and not mark.isspace() and mark in text else text.split()
    return [word.strip() for word in words]


def _values(words: list[str], fields: _Fields, at: int, source: str) -> list[str]:
    """The words of a row in documented units; empty where the header's number for no data stands."""
    if len(words) != len(fields.names):
        message = (
            f"has {counted(len(words), 'value')}; allowed: {len(fields.names)}, one for each of the fields"
        )
        raise RecordError([Problem(f"row {at}", message)], source)
    found = []
    for word, name, factor, offset in zip(words, fields.names, fields.factors, fields.offsets, strict=True):
        value = _number(word)
        if name.lower() in _TIMES:
            found.append(word + fields.zone)
        elif value is None or value in fields.absent or math.isnan(value):
            found.append("" if value is not None else word)
        else:
            found.append(word if (factor, offset) == (1.0, 0.0) else repr(value * factor + offset))
    return found


def _per_field(
    header: _Header, names: list[str], keys: tuple[str, str], neutral: float, source: str
) -> list[float]:
    """A number for each field; the neutral one where the header states none."""
    stated = next((key for key in keys if key in header.keys), None)
    if stated is None:
        return [neutral] * len(names)
    numbers = [_number(word) for word in _words(header.keys[stated], header)]
    if len(numbers) != len(names):
        message = f"has {counted(len(numbers), 'value')}; allowed: {len(names)}, one for each of the fields"
        raise RecordError([Problem(stated, message)], source)
    return [neutral if value is None else value for value in numbers]


def _zone(header: _Header, source: str) -> str:
    """The zone of the times, as ISO 8601 writes it; empty where the header states none, or UTC."""
    stated = header.keys.get("tz", "")
    if stated.upper() in {"", "UTC", "GMT"}:
        return ""
    hours = _number(stated)
    if hours is None or abs(hours) > 14:
        raise RecordError([Problem("tz", f"is '{stated}'; allowed: hours east of UTC, -12 to 14")], source)
    minutes = round(abs(hours) * 60)
    return f"{'+' if hours > 0 else '-'}{minutes // 60:02d}:{minutes % 60:02d}" if minutes else ""


def _number(word: str) -> float | None:
    try:
        return float(word)
    except ValueError:
        return None
