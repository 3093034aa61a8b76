"""A figure for each study, drawn from its stored results: ``python -m validation --pages`` draws them.

Rows of the table from top to bottom; numbers of one unit stand on one axis.
"""

import hashlib
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from html import escape
from itertools import groupby
from textwrap import wrap

from validation.pages import FIGURES, Study
from validation.quantities import Numbers, Point, Quantity, numbers_of

MOST_ROWS = 40
"""Rows of a figure; of longer tables those are drawn that are compared with something published."""

MOST_PANELS = 4
"""Axes side by side."""

WIDTH, LABELS, RIGHT, GAP = 760, 270, 16, 26
LINE, ROW, HEAD, FOOT, AFTER = 12, 20, 20, 22, 12
"""Pixels: the width of a figure, its labels and gaps; a line of a label, a row, what surrounds rows."""

LETTERS = 46
"""Letters of a line of a label."""

LOGARITHMIC = 30.0
"""Ratio of the highest to the lowest number from which on an axis is logarithmic."""

STYLE = """
.t{font:11px sans-serif;fill:#4a3f30}.n{font:10.5px sans-serif;fill:#7a6a50}.h{font-weight:600}
.g{stroke:#ddd2bf;stroke-width:1}.f{fill:#a3591a}.o{fill:#fbf8f2;stroke:#a3591a;stroke-width:1.5}
.w{stroke:#a3591a;stroke-width:1.5;fill:none}.l{stroke:#c9a37a;stroke-width:1;fill:none}
.agrees .f{fill:#4b7a3c}.agrees .w{stroke:#4b7a3c}.differs .f{fill:#b3402a}.differs .w{stroke:#b3402a}
.p{fill:none;stroke:#2f6d8c;stroke-width:1.8}.r{fill:#2f6d8c;fill-opacity:.22}
@media(prefers-color-scheme:dark){.t{fill:#ece4d6}.n{fill:#b5a993}.g{stroke:#4a443c}.f{fill:#e0a55c}
.o{fill:#1d1b18;stroke:#e0a55c}.w{stroke:#e0a55c}.agrees .f{fill:#8cc07a}.agrees .w{stroke:#8cc07a}
.differs .f{fill:#ef7a5f}.differs .w{stroke:#ef7a5f}.p{stroke:#6fb2d0}.r{fill:#6fb2d0}}
"""


@dataclass(frozen=True)
class Axis:
    """Where numbers lie on a line of pixels."""

    low: float
    high: float
    left: float
    right: float
    logarithmic: bool

    def at(self, value: float) -> float:
        """The pixel of a number; those beyond the ends lie at the end."""
        low, high, value = (self._scaled(v) for v in (self.low, self.high, max(value, self.low)))
        return round(self.left + (self.right - self.left) * min((value - low) / (high - low), 1.0), 1)

    def ticks(self) -> list[float]:
        """Round numbers along it."""
        if self.logarithmic:
            powers = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
            return [10.0**power for power in powers if self.low <= 10.0**power <= self.high]
        wanted = max(2.0, (self.right - self.left) / 55)
        rough = (self.high - self.low) / wanted
        power = 10.0 ** math.floor(math.log10(rough))
        step = power * next(factor for factor in (1, 2, 5, 10) if factor * power >= rough * 0.999)
        first = math.ceil(self.low / step - 1e-9)
        return [k * step for k in range(first, math.floor(self.high / step + 1e-9) + 1)]

    def _scaled(self, value: float) -> float:
        return math.log10(value) if self.logarithmic else value


def drawn(study: Study) -> str | None:
    """The figure of a study as SVG; None where its table holds no numbers."""
    known = [numbers for result in study.results if (numbers := numbers_of(result))]
    rows = known if len(known) <= MOST_ROWS else [row for row in known if row.judged][:MOST_ROWS]
    if not rows:
        return None
    parts, top = [], 6.0
    for key, group in groupby(sorted(rows, key=_order(rows)), _kind):
        block, height = _block(key, list(group), top)
        parts += block
        top += height
    caption, height = _caption(len(rows), len(study.results), top), round(top + 26)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
        f'height="{height}" data-of="{digest(study)}"><title>{escape(study.title)}</title>'
        f"<style>{STYLE.strip()}</style>\n" + "\n".join([*parts, *caption]) + "\n</svg>\n"
    )


def digest(study: Study) -> str:
    """A name for the numbers of a study's table."""
    rows = "\n".join(f"{r.what}|{r.published}|{r.found}|{r.verdict}" for r in study.results)
    return hashlib.sha256(rows.encode()).hexdigest()[:16]


def write(known: Iterable[Study]) -> None:
    """Draw the figures of studies, and remove those of studies that have none any more."""
    FIGURES.mkdir(parents=True, exist_ok=True)
    made = {f"{study.name}.svg": text for study in known if (text := drawn(study))}
    for path in FIGURES.glob("*.svg"):
        if path.name not in made:
            path.unlink()
    for name, text in made.items():
        (FIGURES / name).write_text(text, "utf-8")


Kind = tuple[tuple[str, str], ...]


def _kind(row: Numbers) -> Kind:
    return tuple((quantity.name, quantity.unit) for quantity in row.quantities[:MOST_PANELS])


def _order(rows: list[Numbers]):
    """Rows of one kind together, kinds in the order in which they first come."""
    first: dict[Kind, int] = {}
    for at, row in enumerate(rows):
        first.setdefault(_kind(row), at)
    return lambda row: first[_kind(row)]


def _block(kind: Kind, rows: list[Numbers], top: float) -> tuple[list[str], float]:
    """Rows of one kind: labels on the left, an axis for each quantity; the elements and their height."""
    labels = [wrap(row.what, LETTERS) for row in rows]
    heights = [max(ROW, LINE * len(lines) + 6) for lines in labels]
    bottom = top + HEAD + sum(heights)
    room = (WIDTH - LABELS - RIGHT - GAP * (len(kind) - 1)) / len(kind)
    axes = []
    parts = []
    for place, (name, unit) in enumerate(kind):
        left = LABELS + place * (room + GAP)
        axis = _axis(
            [row.quantities[place] for row in rows], rows if len(kind) == 1 else [], left, left + room
        )
        axes.append(axis)
        parts += _frame(axis, f"{name}{f' ({unit})' if unit else ''}".strip(), top + HEAD, bottom)
    middle = top + HEAD
    for row, lines, height in zip(rows, labels, heights, strict=True):
        parts += _row(row, lines, axes, middle + height / 2)
        middle += height
    return parts, bottom + FOOT + AFTER - top


def _axis(quantities: list[Quantity], rows: list[Numbers], left: float, right: float) -> Axis:
    values = [edge for quantity in quantities for point in quantity.points for edge in _ends(point)]
    values += [edge for row in rows for edge in row.published or ()]
    means = [point.mean for quantity in quantities for point in quantity.points]
    low, high = min(values), max(values)
    if min(means) > 0 and max(means) / min(means) > LOGARITHMIC:
        low = max(low, min(means) / 3)
        return Axis(
            10.0 ** math.floor(math.log10(low)), 10.0 ** math.ceil(math.log10(high)), left, right, True
        )
    if low >= 0 and low < 0.5 * high:
        low = 0.0
    margin = 0.06 * (high - low) or max(abs(high), 1.0) * 0.5
    return Axis(low if low == 0 else low - margin, high + margin, left, right, False)


def _ends(point: Point) -> tuple[float, float]:
    reach = point.deviation or 0.0
    return point.mean - reach, point.mean + reach


def _frame(axis: Axis, title: str, top: float, bottom: float) -> Iterator[str]:
    """The lines, the numbers and the title of an axis."""
    if title:
        yield _text(axis.left, top - 7, title, "t h")
    for tick in axis.ticks():
        x = axis.at(tick)
        yield f'<path class="g" d="M{x:g} {top:g}V{bottom:g}"/>'
        yield _text(x, bottom + 13, f"{tick:.6g}".replace("-", "−"), "n", "middle")


def _row(row: Numbers, lines: list[str], axes: list[Axis], y: float) -> Iterator[str]:
    """The label of a row and its numbers."""
    for place, line in enumerate(lines):
        at = y + 4 + LINE * (place - (len(lines) - 1) / 2)
        yield _text(LABELS - 12, round(at, 1), line, "t", "end")
    yield f'<g class="{row.judged}">' if row.judged in ("agrees", "differs") else "<g>"
    if row.published:
        yield _published(axes[0], row.published, y)
    for axis, quantity in zip(axes, row.quantities, strict=False):
        yield from _points(axis, quantity, y)
    yield "</g>"


def _published(axis: Axis, published: tuple[float, float], y: float) -> str:
    low, high = (axis.at(edge) for edge in published)
    if low == high:
        return f'<path class="p" d="M{low:g} {y - 6:g}l6 6l-6 6l-6 -6z"/>'
    return f'<rect class="r" x="{low:g}" y="{y - 7:g}" width="{high - low:g}" height="14"/>'


def _points(axis: Axis, quantity: Quantity, y: float) -> Iterator[str]:
    """Points with their deviations; the last of several in order, and the first of two, is filled."""
    places = [axis.at(point.mean) for point in quantity.points]
    if len(places) > 1 and not quantity.runs:
        yield f'<path class="l" d="M{min(places):g} {y:g}H{max(places):g}"/>'
    filled = {0} if len(places) == 2 else {len(places) - 1}
    later = sorted(range(len(places)), key=filled.__contains__)  # filled ones above the others
    for at in later:
        point, x = quantity.points[at], places[at]
        low, high = (axis.at(edge) for edge in _ends(point))
        if high - low > 8:
            yield f'<path class="w" d="M{low:g} {y:g}H{high:g}"/>'
        full = quantity.runs or at in filled
        kind, radius = "f" if full else "o", 3.2 if quantity.runs else 4
        yield f'<circle class="{kind}" cx="{x:g}" cy="{y:g}" r="{radius}"/>'


def _caption(shown: int, rows: int, top: float) -> Iterator[str]:
    """What the signs mean, and how many rows of the table are shown."""
    y = top + 10
    yield f'<circle class="f" cx="14" cy="{y - 4:g}" r="4"/>' + _text(
        24, y, "found: mean, standard deviation; or runs", "n"
    )
    yield f'<circle class="o" cx="252" cy="{y - 4:g}" r="4"/>' + _text(
        262, y, "compared with, or earlier", "n"
    )
    yield f'<path class="p" d="M412 {y - 10:g}l6 6l-6 6l-6 -6z"/>' + _text(424, y, "published", "n")
    some = f"{shown} of {rows} rows" if shown < rows else "all rows"
    yield _text(WIDTH - RIGHT, y, f"{some} of the table; green agrees, red differs", "n", "end")


def _text(x: float, y: float, text: str, kind: str, anchor: str = "") -> str:
    placed = f' text-anchor="{anchor}"' if anchor else ""
    return f'<text class="{kind}" x="{x:g}" y="{y:g}"{placed}>{escape(text)}</text>'
