"""The numbers in a study's table: what was found, with its scatter or run by run, beside the published."""

import re
from dataclasses import dataclass

from validation.pages import Result

_NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
_UNITS = r"cells/step|cells|slabs|mm/s|m/h|mm|cm|m|degrees|°|%"
_UNIT = rf"(?: ?({_UNITS})(?![\w/]))?"
_PAIR = re.compile(rf"({_NUMBER}) ± ({_NUMBER}){_UNIT}")
_RUN = re.compile(r"(?<![\w.])[-+]\d+(?:\.\d+)?")
_NAME = re.compile(r"^[A-Za-z ]*")
_ALONE = re.compile(rf"^(|[A-Za-z ]+ )({_NUMBER}){_UNIT}$")
_SHARE = re.compile(r"^\d+ of \d+ \((\d+)%\)")
_BETWEEN = re.compile(rf"^between ({_NUMBER}) and ({_NUMBER}){_UNIT}")
_PUBLISHED = re.compile(rf"^(?:about |at least |up to )?({_NUMBER})(?: to ({_NUMBER}))?(?=°| |$)")
_JUDGED = re.compile(r"agrees|differs|within")
_COMPARED = re.compile(r"^(?:with|without|single|in a field of \d+)?$")
"""Words beside numbers that are compared with each other: they name no quantity of their own."""


@dataclass(frozen=True)
class Point:
    """A mean and the standard deviation over the seeds, or a single run, which has none."""

    mean: float
    deviation: float | None = None


@dataclass(frozen=True)
class Quantity:
    """Numbers of one kind in a row: one, two that are compared, several in time, or single runs."""

    name: str
    unit: str
    points: tuple[Point, ...]
    runs: bool = False
    """Whether the points are single runs, in no order."""


@dataclass(frozen=True)
class Numbers:
    """A row of a table as numbers."""

    what: str
    judged: str
    """``agrees``, ``differs``, ``open`` or nothing."""
    quantities: tuple[Quantity, ...]
    published: tuple[float, float] | None
    """The published number, or its range, where it is one of the same kind as what was found."""


def numbers_of(result: Result) -> Numbers | None:
    """The numbers of a row; None where it holds only words."""
    found = re.sub(r" ?\([^()]*±[^()]*\)", "", result.found)
    quantities = _pairs(found) or _others(found)
    if not quantities:
        return None
    published = _published(result) if len(quantities) == 1 and len(quantities[0].points) == 1 else None
    return Numbers(re.sub(r"[`*]", "", result.what), result.judged, quantities, published)


def _published(result: Result) -> tuple[float, float] | None:
    found = _PUBLISHED.match(result.published)
    if found is None or not _JUDGED.search(result.verdict):
        return None
    return float(found[1]), float(found[2] or found[1])


def _pairs(text: str) -> tuple[Quantity, ...]:
    """Means with their deviations: words beside one name it, others are compared with the one before."""
    groups: list[tuple[str, list[re.Match[str]]]] = []
    for item in re.split(r"[,;] ", text):
        matches = list(_PAIR.finditer(item))
        if not matches:
            continue
        before, after = item[: matches[0].start()].strip(), item[matches[-1].end() :].strip()
        name = before if len(matches) > 1 else f"{before} {after}".strip()
        if _COMPARED.match(name) and groups:
            groups[-1][1].extend(matches)
        else:
            groups.append(("" if _COMPARED.match(name) else name, matches))
    return tuple(_quantity(name, matches) for name, matches in groups)


def _quantity(name: str, matches: list[re.Match[str]]) -> Quantity:
    unit = next((match[3] for match in reversed(matches) if match[3]), "")
    points = tuple(Point(float(match[1]), float(match[2])) for match in matches)
    return Quantity(name, unit.replace("degrees", "°"), points)


def _others(text: str) -> tuple[Quantity, ...]:
    """Single runs with their signs, two limits, one number, or a share of the runs."""
    if share := _SHARE.match(text):
        return (Quantity("share of the runs", "%", (Point(float(share[1])),)),)
    signed, *_ = text.split(";")
    if runs := _RUN.findall(signed):
        points = tuple(Point(float(number)) for number in runs)
        (name,) = _NAME.findall(signed)
        return (Quantity(name.strip(), "°" if "°" in signed else "", points, runs=True),)
    if between := _BETWEEN.match(text):
        low, high = float(between[1]), float(between[2])
        return (Quantity("", between[3] or "", (Point((low + high) / 2, (high - low) / 2),)),)
    if alone := _ALONE.match(text):
        return (Quantity(alone[1].strip(), alone[3] or "", (Point(float(alone[2])),)),)
    return ()
