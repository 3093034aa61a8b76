"""Which columns of a table make the time."""

from collections.abc import Sequence

from barchan.errors import Problem, RecordError
from barchan.wind.records.claims import guess
from barchan.wind.records.headings import read_heading
from barchan.wind.records.providers import Provider
from barchan.wind.records.quantities import QUANTITIES

_PARTS = (
    (("year", "yyyy", "yy", "yr"), "%Y"),
    (("month", "mo", "mm", "mon"), "%m"),
    (("day", "dy", "dd"), "%d"),
    (("hour", "hr", "hh", "hours"), "%H"),
    (("minute", "minutes", "mn", "mi", "min"), "%M"),
)
"""Names of columns that hold one part of the time each, and how the part is written."""

_DATES = ("date", "datum", "fecha", "data")
"""Names of a column of dates, in the languages that are known."""

_OF_DAY = (
    "time", "hour", "hours", "hr", "hh", "h", "uur", "time_of_day", "uhrzeit", "zeit", "stunde", "heure",
    "hora", "ora", "tijd",
)  # fmt: skip
"""Names of a column with the time of the day beside one of dates."""


_BESIDE = frozenset((
    "and", "und", "et", "y", "e", "en", "station", "logger", "measurement", "measured", "observation",
    "observed", "obs", "sample", "sampling", "record", "recorded", "recording",
))  # fmt: skip
"""Words of a heading that leave a time a time, as in ``Station date and time``."""


def time_columns(
    headings: list[str], stated: str | None, provider: Provider, source: str
) -> tuple[list[str], str | None]:
    """The columns that make the time, and how it is written where the format of the file says so.

    Raises RecordError where there are none.
    """
    if stated:
        parts = joined_columns(stated, headings)
        if parts is None:
            message = f"no column '{_absent(stated, headings)}'; the columns are {', '.join(headings)}"
            raise RecordError([Problem("time", message)], source)
        return parts, _hint(parts, provider)
    for known in provider.times:
        if all(name in headings for name in known):
            return list(known), _hint(known, provider)
    single = guess(headings, "time") or _worded(headings, source)
    plain = {_said(h): h for h in reversed(headings)} | {read_heading(h).name: h for h in reversed(headings)}
    date = next((plain[name] for name in _DATES if name in plain), None)
    if date:
        hour = next((plain[name] for name in _OF_DAY if name in plain), None)
        if hour and single in {hour, date, None}:
            return [date, hour], None
    if single is not None:
        return [single], provider.time_format
    found = [next((h for name in names if (h := _like(headings, name))), None) for names, _ in _PARTS]
    if all(found[:3]):
        parts = [name for name in found if name]
        return parts, _parts_format(len(parts))
    message = f"no column for the time; the columns are {', '.join(headings)}"
    raise RecordError([Problem("time", message)], source)


def _said(heading: str) -> str:
    """The name in a heading without the words that leave a time a time."""
    return "_".join(word for word in read_heading(heading).name.split("_") if word not in _BESIDE)


def _worded(headings: list[str], source: str) -> str | None:
    """The one heading whose words make it a time; None where there is none.

    Raises RecordError where several are times alike.
    """
    names = QUANTITIES["time"].names
    ranks = {h: names.index(_said(h)) for h in headings if read_heading(h).plain and _said(h) in names}
    likely = [h for h in ranks if ranks[h] == min(ranks.values())]
    if len(likely) > 1:
        message = f"several columns may be the time: {', '.join(likely)}; name one"
        raise RecordError([Problem("time", message)], source)
    return likely[0] if likely else None


def _hint(parts: Sequence[str], provider: Provider) -> str | None:
    """How the known format of a file writes the time in these columns."""
    if provider.time_format or len(parts) < 3:
        return provider.time_format
    return _parts_format(len(parts)) if tuple(parts) in provider.times else None


def _parts_format(count: int) -> str:
    return " ".join(form for _, form in _PARTS[:count])


def _like(headings: Sequence[str], name: str) -> str | None:
    return next((h for h in headings if h.strip("# ").lower() == name), None)


def joined_columns(stated: str, headings: Sequence[str]) -> list[str] | None:
    """The columns that a stated name means: one of that name, or several joined by plus signs.

    None where no way to part the name gives columns.
    """
    if stated in headings:
        return [stated]
    pieces = stated.split("+")
    for count in range(1, len(pieces)):
        first, rest = "+".join(pieces[:count]), "+".join(pieces[count:])
        if first in headings and (others := joined_columns(rest, headings)):
            return [first, *others]
    return None


def _absent(stated: str, headings: Sequence[str]) -> str:
    return next((part for part in stated.split("+") if part not in headings), stated)
