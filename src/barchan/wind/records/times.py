"""Times as people write them, as seconds from the first one."""

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.headings import read_heading
from barchan.wind.records.units import SECONDS, TIME

if TYPE_CHECKING:
    import pandas as pd

COMPACT = {8: "%Y%m%d", 10: "%Y%m%d%H", 12: "%Y%m%d%H%M", 14: "%Y%m%d%H%M%S"}
"""Dates written in digits alone, by their number."""

_ZONE = re.compile(r"(?:Z|[+-]\d\d:?\d\d)$")

_CLEAR = (
    "%d.%m.%Y %H:%M",
    "%d.%m.%Y %H:%M:%S",
    "%d.%m.%Y",
    "%Y.%m.%d %H:%M",
    "%Y:%m:%d %H:%M",
    "%Y%m%d:%H%M",
    "%d-%b-%Y %H:%M",
    "%d-%b-%Y %H:%M:%S",
    "%d %b %Y %H:%M",
    "%Y%m%d %H%M",
    "%Y%m%d %H:%M",
)
"""Ways to write a time that can be read in one way only."""

_SLASHES = tuple(
    (f"%d/%m/%{year} {hour}", f"%m/%d/%{year} {hour}")
    for year in "Yy"
    for hour in ("%H:%M", "%H:%M:%S", "%I:%M:%S %p", "%I:%M %p")
)
"""Ways to write a time that put the day first, or the month."""

_UTC_NAMED = re.compile(
    r"(?<![a-z])(?:utc|gmt)(?:\s*([+\u2212-])\s*(\d{1,2})(?::?([0-5]\d))?(?!\d))?(?![a-z])", re.IGNORECASE
)
"""A zone in a heading, such as ``UTC`` or ``UTC+1``."""


class Dated(NamedTuple):
    """Times of a file."""

    seconds: NDArray[np.float64]
    """Since the first one (s)."""
    start: np.datetime64 | None
    """The first one, where times are dates."""
    utc: bool
    """Whether they are in UTC, as a zone is known."""


@dataclass(frozen=True)
class Times:
    """The column or columns that make the time."""

    parts: "list[pd.Series]"
    name: str
    """Their names, joined."""
    numbers: NDArray[np.int64]
    """The rows' numbers in the file."""
    stated: RecordFormat
    """What the user states."""
    hint: str | None
    """How the format of the file writes them, where it is known."""
    source: str
    utc: bool = False
    """Whether the format of the file fixes UTC."""

    @property
    def form(self) -> str | None:
        """How times are written, where it is stated."""
        return self.stated.time_format

    def error(self, row: int, message: str) -> RecordError:
        """The error of a row."""
        return RecordError([Problem(f"row {self.numbers[row]}, column '{self.name}'", message)], self.source)


def offset_of(zone: str) -> np.timedelta64:
    """How much later than UTC the clocks of a zone are: ``UTC``, ``Z``, or ``+01:00``."""
    if zone in {"UTC", "Z"}:
        return np.timedelta64(0, "m")
    hours, minutes = zone[1:].split(":")
    return np.timedelta64((1 if zone[0] == "+" else -1) * (60 * int(hours) + int(minutes)), "m")


def seconds(times: Times) -> Dated:
    """Seconds since the first time of the file, and that time where it is a date, in UTC if a zone is known.

    Raises RecordError at the first time that cannot be read, where only some times state a zone, and where
    they state one beside that of the user.
    """
    empty = np.any([(part.str.strip() == "").to_numpy() for part in times.parts], axis=0)
    if empty.any():
        raise times.error(int(np.argmax(empty)), "is empty; allowed: a time in each row")
    if not len(times.parts[0]):
        return Dated(np.zeros(0), None, utc=False)
    unit = times.form if times.form in SECONDS else TIME.unit_of(read_heading(times.name).unit)
    if unit and (times.form is None or times.form in SECONDS):
        return Dated(_counted(times, SECONDS[unit]), None, utc=False)
    return _dates(_joined(times.parts), times)


def _counted(times: Times, unit: float) -> NDArray[np.float64]:
    import pandas as pd

    words = times.parts[0]
    column = pd.to_numeric(words, errors="coerce").to_numpy(np.float64)
    if not np.isfinite(column).all():
        row = int(np.argmin(np.isfinite(column)))
        raise times.error(row, f"is '{words.iloc[row]}'; allowed: numbers")
    return (column - column[0]) * unit


def _joined(parts: "list[pd.Series]") -> "pd.Series":
    """The parts of each time, with a blank between, of whole numbers without fractions; ``a`` as ``AM``."""
    words = _plainly_joined(parts)
    return words.str.replace(
        r"(?<=\d)\s*([aApP])\.?[mM]?\.?$", lambda found: f" {found[1].upper()}M", regex=True
    )


def _plainly_joined(parts: "list[pd.Series]") -> "pd.Series":
    if len(parts) == 1:
        return parts[0].str.strip().str.replace(r"\s*(?:UTC|GMT)$", "Z", regex=True)
    whole = [part.str.strip().str.replace(r"(?<=\d)\.0+$", "", regex=True) for part in parts]
    words = whole[0]
    for part in whole[1:]:
        words = words + " " + part
    return words


def _dates(words: "pd.Series", times: Times) -> Dated:
    """Dates of words; the hour 24 is the first of the next day."""
    import pandas as pd

    wanted = times.form or _guessed(words, times)
    words, later = _without_24(words, wanted)
    zones = words.str.contains(r":.*(?:Z|[+-]\d\d:?\d\d)$", regex=True)
    try:
        dates = pd.to_datetime(words, format=wanted, utc=bool(zones.all()))
    except ValueError as error:
        if "bad directive" in str(error) or "stray %" in str(error):
            raise RecordError([Problem("time_format", str(error))], times.source) from None
        row, message = _first_mistake(words, wanted)
        raise times.error(row, message) from None
    zone, states = times.stated.time_zone, dates.dt.tz is not None
    if zone and states:
        message = f"states a zone ('{words.iloc[0]}'), and time_zone is {zone}; allowed: one of them"
        raise times.error(0, message)
    if states:
        dates = dates.dt.tz_convert("UTC").dt.tz_localize(None)
    stamps = dates.to_numpy().astype("datetime64[ms]") + later.astype("timedelta64[D]")
    named = None if zone or states else _named_zone(times.name)
    stamps = stamps - offset_of(zone or named or "UTC")
    utc = states or bool(zone) or times.utc or named is not None
    return Dated((stamps - stamps[0]).astype(np.float64) / 1e3, stamps[0].astype("datetime64[s]"), utc)


def _named_zone(name: str) -> str | None:
    """The zone that a heading names; None where it names none."""
    found = _UTC_NAMED.search(name)
    if found is None:
        return None
    sign, hours, minutes = found.groups()
    return "UTC" if sign is None else f"{'+' if sign == '+' else '-'}{int(hours):02d}:{minutes or '00'}"


def _guessed(words: "pd.Series", times: Times) -> str:
    """How times are written, by the words themselves; ISO 8601 where no other way fits all.

    Raises RecordError where both the day and the month may come first.
    """
    if times.hint:
        hints = (times.hint, times.hint.replace("%Y", "%y"))
        return next((form for form in hints if _fits(words, form)), times.hint)
    first = words.iloc[0]
    if first.isdigit():
        return COMPACT.get(len(first), "ISO8601")
    if re.fullmatch(r"\d{4}-\d\d-\d\d \d{1,2}", first):
        return "%Y-%m-%d %H"
    if re.fullmatch(r"\d{8} \d{1,2}", first):
        return "%Y%m%d %H"
    if re.match(r"\d{4}-", first):
        return "ISO8601"
    clear = next((form for form in _CLEAR if _fits(words, form)), None)
    if clear:
        return clear
    for day_first, month_first in _SLASHES:
        ways = [form for form in (day_first, month_first) if _fits(words, form)]
        if len(ways) == 2:
            message = f"is '{first}': day or month first? State time_format, '{day_first}' or '{month_first}'"
            raise times.error(0, message)
        if ways:
            return ways[0]
    return "ISO8601"


def _fits(words: "pd.Series", form: str) -> bool:
    """Whether all times are written in a way; the first is tried first, as it mostly decides."""
    import pandas as pd

    for some in (words.iloc[:1], words):
        plain, _ = _without_24(some, form)
        if pd.to_datetime(plain, format=form, errors="coerce").isna().any():
            return False
    return True


def _without_24(words: "pd.Series", form: str) -> "tuple[pd.Series, NDArray[np.int64]]":
    """Times whose hour 24 is written as 0, and the days that they are later by."""
    pattern = _hour_pattern(form)
    late = words.str.match(pattern).to_numpy(bool) if pattern else np.zeros(len(words), bool)
    if late.any():
        words = words.where(~late, words.str.replace(pattern, lambda found: found[1] + "00", n=1, regex=True))
    return words, late.astype(np.int64)


def _hour_pattern(form: str) -> "re.Pattern[str] | None":
    """What matches a time up to an hour that is 24, in a way to write times."""
    if form == "ISO8601":
        return re.compile(r"^(\d{4}-\d\d-\d\d[T ])24")
    before, hour, _ = form.partition("%H")
    if not hour:
        return None
    few = r"\d\d" if re.search(r"%[mdYyj]%", f"{before}%") else r"\d{1,2}"
    digits = {"Y": r"\d{4}", "y": r"\d\d", "m": few, "d": few, "j": r"\d{1,3}"}
    parts = re.split(r"%(.)", before)
    text = "".join(digits.get(part, r"\S+") if at % 2 else re.escape(part) for at, part in enumerate(parts))
    return re.compile(rf"^({text})24")


def _first_mistake(words: "pd.Series", wanted: str) -> tuple[int, str]:
    """The first row whose time cannot be read beside the others, and why."""
    import pandas as pd

    readable = pd.to_datetime(words, format=wanted, errors="coerce", utc=True).notna().to_numpy()
    if not readable.all():
        row = int(np.argmin(readable))
        how = "ISO 8601, as in 2024-01-31T06:00, or a stated format" if wanted == "ISO8601" else wanted
        return row, f"is '{words.iloc[row]}'; allowed: times written as {how}"
    zones = [_zone(word) for word in words]
    row = next(k for k, zone in enumerate(zones) if bool(zone) != bool(zones[0]))
    states = f"states the zone {zones[row]}" if zones[row] else "states no zone"
    return (
        row,
        f"is '{words.iloc[row]}', which {states} unlike the rows before; allowed: a zone in all or none",
    )


def _zone(word: str) -> str:
    found = _ZONE.search(word.strip()) if ":" in word or word.strip().endswith("Z") else None
    return found[0] if found else ""
