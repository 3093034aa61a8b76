"""Reading a heading: the name, unit, height, convention and kind of mean that its words state."""

import re
from dataclasses import dataclass, replace
from functools import lru_cache

from barchan.wind.records.units import ANGLE, SPEED, TIME

_FOOT = 0.3048
_LENGTHS = {"m": 1.0, "metre": 1.0, "metres": 1.0, "meter": 1.0, "meters": 1.0, "ft": _FOOT, "feet": _FOOT}
_PERIODS = frozenset(["min", "mins", "minute", "minutes", "h", "hr", "hour", "sec"])
_FILLING = frozenset((
    "at", "avg", "mean", "average", "averaged", "wvt", "wvc", "above", "ground", "level", "agl",
    "scalar", "vector", "height", "true", "utc", "gmt", "lst", "local", "the", "of", "hourly",
    "prevailing", "surface",
))  # fmt: skip
_OTHER = frozenset((
    "gust", "gusts", "gustspeed", "windgust", "max", "maximum", "min", "minimum", "std", "stdev",
    "stddev", "sd", "sigma", "deviation", "peak", "flag", "quality", "qc", "qn", "code", "variability",
    "variance", "error", "uncertainty", "count", "lull", "highest", "lowest",
))  # fmt: skip
_WAYS = {"to": "to", "toward": "to", "towards": "to", "from": "from"}
_UNIT_WORDS = {
    "ms": "m/s", "mps": "m/s", "kn": "kn", "kts": "kn", "kt": "kn", "knots": "kn", "kmh": "km/h",
    "kph": "km/h",
    "mph": "mph", "deg": "deg", "degrees": "deg", "degree": "deg", "rad": "rad", "radians": "rad",
}  # fmt: skip
_LEAST_HEIGHT = 10.0
"""A number without a unit in a name, as in ``u100``, is a height (m) from here on; below it counts
sensors."""


@dataclass(frozen=True)
class Heading:
    """What the words of a heading state; empty where they state nothing."""

    name: str
    """The plain name: lower case, joined by underscores, without all that follows."""
    unit: str = ""
    """The unit as spelled."""
    height: float | None = None
    """Height above the ground (m)."""
    way: str = ""
    """Whether a direction is where the wind comes ``from`` or goes ``to``."""
    plain: bool = True
    """Whether it is the wind itself, neither a gust, an extreme, a deviation nor a mark of quality."""
    sensor: int | None = None
    """Number of the sensor, as in WS2."""


@lru_cache(maxsize=4096)
def read_heading(text: str) -> Heading:
    """Name, unit, height, convention and kind of mean that a heading states."""
    pieces = [piece for found in re.findall(r"[(\[](.*?)[)\]]", text) for piece in re.split(r"[,;]", found)]
    rest, *more = re.sub(r"[(\[].*?[)\]]", " ", text).split(",")
    inside = re.search(r"\s(?:measured\s+)?in\s+(.+)$", rest)
    if inside:
        rest, more = rest[: inside.start()], [*more, inside[1]]
    said = _read_words(rest)
    strange = ""
    for piece in filter(None, map(str.strip, [*more, *pieces])):
        if _is_unit(piece):
            said = _joined(said, Heading("", unit=piece))
            continue
        words = _read_words(piece)
        said = _joined(said, words)
        strange = strange or (piece if words.name else "")
    return said if said.unit else replace(said, unit=strange)


def _is_unit(text: str) -> bool:
    return any(kind.unit_of(text) or kind.why_useless(text) for kind in (SPEED, ANGLE, TIME))


def _joined(first: Heading, other: Heading) -> Heading:
    """The name of the first, and what either states."""
    height = other.height if first.height is None else first.height
    return replace(
        first,
        unit=first.unit or other.unit,
        height=height,
        way=first.way or other.way,
        plain=first.plain and other.plain,
    )


def _read_words(text: str) -> Heading:
    """What the words of a text without brackets state."""
    split = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Za-z])(?=\d)|(?<=\d)(?=[A-Za-z])", " ", text)
    joined = " ".join(re.findall(r"[a-z\u00df-\u00ff]+|\d+(?:\.\d+)?", split.lower()))
    joined = re.sub(r"\b(?:s|d \d+) (?=wvt)", "", joined)
    joined = re.sub(r"\bdeg t\b", "deg", joined)
    words = re.sub(r"\bsd \d+ (?=wvt)", "sd ", joined).split()
    name: list[str] = []
    unit, height, way, plain, sensor = "", None, "", True, None
    for at, word in enumerate(words):
        before, after = (words[k] if 0 <= k < len(words) else "" for k in (at - 1, at + 1))
        if word[0].isdigit():
            if after in _LENGTHS:
                height = float(word) * _LENGTHS[after]
            elif after not in _PERIODS and float(word) >= _LEAST_HEIGHT:
                height = float(word)
            elif after not in _PERIODS and word.isdigit():
                sensor = int(word)
        elif before[:1].isdigit() and (word in _LENGTHS or word in _PERIODS):
            continue
        elif word in _UNIT_WORDS and name:
            unit = _UNIT_WORDS[word]
        elif word in _WAYS:
            way = _WAYS[word]
        elif word in _OTHER:
            plain = False
        elif word not in _FILLING or len(words) == 1:
            name.append(word)
    return Heading("_".join(name), unit, height, way, plain, sensor)
