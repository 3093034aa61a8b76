"""Times as people write them, as seconds from the first one."""

import re
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.columns import split

if TYPE_CHECKING:
    import pandas as pd

SECONDS = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0, "days": 86400.0, "hours": 3600.0}
"""Seconds in units that a column of plain numbers may state."""

COMPACT = {8: "%Y%m%d", 10: "%Y%m%d%H", 12: "%Y%m%d%H%M", 14: "%Y%m%d%H%M%S"}
"""Dates written in digits alone, by their number."""

_ZONE = re.compile(r"(?:Z|[+-]\d\d:?\d\d)$")

Seconds = tuple[NDArray[np.float64], np.datetime64 | None]


def seconds(
    parts: "list[pd.Series]", name: str, numbers: NDArray[np.int64], form: str | None, source: str
) -> Seconds:
    """Seconds since the first time, and the first time where it is a date.

    ``parts`` are the columns that make the time, ``numbers`` the rows' numbers in the file. Raises
    RecordError at the first time that cannot be read, and where times state more than one zone.
    """
    empty = np.any([part.isna().to_numpy() for part in parts], axis=0)
    if empty.any():
        raise _error(name, numbers[int(np.argmax(empty))], "is empty; allowed: a time in each row", source)
    if not len(parts[0]):
        return np.zeros(0), None
    unit = split(name)[1]
    if unit in SECONDS and form is None:
        return _counted(parts[0], name, numbers, SECONDS[unit], source), None
    words = parts[0].astype(str)
    for part in parts[1:]:
        words = words + " " + part.astype(str)
    return _dates(words, name, numbers, form, source)


def _counted(
    words: "pd.Series", name: str, numbers: NDArray[np.int64], unit: float, source: str
) -> NDArray[np.float64]:
    import pandas as pd

    column = pd.to_numeric(words, errors="coerce").to_numpy(np.float64)
    if not np.isfinite(column).all():
        row = int(np.argmin(np.isfinite(column)))
        raise _error(name, numbers[row], f"is '{words.iloc[row]}'; allowed: numbers", source)
    return (column - column[0]) * unit


def _dates(
    words: "pd.Series", name: str, numbers: NDArray[np.int64], form: str | None, source: str
) -> Seconds:
    import pandas as pd

    first = words.iloc[0].strip()
    wanted = form or (COMPACT.get(len(first), "ISO8601") if first.isdigit() else "ISO8601")
    try:
        dates = pd.to_datetime(words, format=wanted)
    except ValueError as error:
        if "bad directive" in str(error) or "stray %" in str(error):
            raise RecordError([Problem("time_format", str(error))], source) from None
        row, message = _first_mistake(words, wanted)
        raise _error(name, numbers[row], message, source) from None
    if dates.dt.tz is not None:
        dates = dates.dt.tz_convert("UTC").dt.tz_localize(None)
    stamps = dates.to_numpy().astype("datetime64[ms]")
    return (stamps - stamps[0]).astype(np.float64) / 1e3, stamps[0].astype("datetime64[s]")


def _first_mistake(words: "pd.Series", wanted: str) -> tuple[int, str]:
    """The first row whose time cannot be read beside the others, and why."""
    import pandas as pd

    readable = pd.to_datetime(words, format=wanted, errors="coerce", utc=True).notna().to_numpy()
    if not readable.all():
        row = int(np.argmin(readable))
        how = "ISO 8601, as in 2024-01-31T06:00, or a stated format" if wanted == "ISO8601" else wanted
        return row, f"is '{words.iloc[row]}'; allowed: times written as {how}"
    zones = [_zone(word) for word in words]
    row = next(k for k, zone in enumerate(zones) if zone != zones[0])
    states = f"states the zone {zones[row]}" if zones[row] else "states no zone"
    return row, f"is '{words.iloc[row]}', which {states} unlike the rows before; allowed: one zone for all"


def _zone(word: str) -> str:
    found = _ZONE.search(word.strip()) if ":" in word or word.strip().endswith("Z") else None
    return found[0] if found else ""


def _error(name: str, number: int, message: str, source: str) -> RecordError:
    return RecordError([Problem(f"row {number}, column '{name}'", message)], source)
