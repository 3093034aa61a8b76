"""What a column or variable claims to hold: quantity, unit, height and convention.

One place decides, from the heading, the row of units, the attributes (CF) and the options of the user;
tables and
grids both ask here.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from barchan.wind.records.format import RecordFormat
from barchan.wind.records.headings import Heading, read_heading
from barchan.wind.records.quantities import QUANTITIES, UNIT_OF_NAME, WIND


@dataclass(frozen=True)
class Column:
    """A column of a table or a variable of a NetCDF file, as its words and attributes describe it."""

    name: str
    unit: str = ""
    """Unit by the attribute ``units`` or by a row of units, as spelled."""
    standard_name: str = ""
    """CF standard name."""
    description: str = ""
    """CF ``long_name``, or the row of processing of a logger."""
    height: float | None = None
    """Height (m) by a coordinate."""
    sideways: str = ""
    """Why components are not eastward and northward, where they are not."""


@dataclass(frozen=True)
class Stated:
    """A column of a known format, as its provider documents it."""

    column: str
    unit: str
    height: float | None = None
    part: int | None = None
    """Which of the parts of a column that are parted by commas (from 0)."""
    missing: tuple[float, ...] = ()
    """Codes of a missing value beside the usual ones."""
    calm: float | None = None
    """A direction that stands for a calm."""
    doubt: tuple[str, int | None, tuple[str, ...]] | None = None
    """Column and part that hold a mark of quality, and the marks of values that are wrong."""


@dataclass(frozen=True)
class Claim:
    """A column that holds a quantity of the wind."""

    column: str
    quantity: str
    unit: str
    """As spelled; empty where none is stated."""
    height: float | None
    way: str
    stated: Stated | None = None
    refusal: str = ""
    """Why it cannot be used though it is known; empty where it can."""
    sensor: int | None = None
    """Number of the sensor by its heading, as in WS2."""

    def __str__(self) -> str:
        tall = "" if self.height is None else f" at {self.height:g} m"
        return f"'{self.column}'{tall}"


Documented = Mapping[str, tuple[Stated, ...]]
"""The columns that a known format has for each quantity, the preferred first."""


def claims_of(
    columns: list[Column],
    form: RecordFormat,
    documented: Documented,
    taken: frozenset[str],
    quantities: tuple[str, ...] = WIND,
) -> dict[str, list[Claim]]:
    """All columns by the quantity that each may hold, the likeliest first.

    ``documented`` are the columns of a known format, ``taken`` those that make the time. A column that
    the user
    gave to one quantity is offered for no other.
    """
    given = taken | frozenset(getattr(form, quantity) for quantity in WIND)
    found = {}
    for quantity in quantities:
        stated = getattr(form, quantity)
        if stated:
            chosen = [c for c in columns if c.name == stated]
        else:
            chosen = _likely([c for c in columns if c.name not in given], quantity, documented)
        found[quantity] = [_claim(column, quantity, documented) for column in chosen]
    return found


def _likely(columns: list[Column], quantity: str, documented: Documented) -> list[Column]:
    """The columns that may hold a quantity, the likeliest first."""
    names = [known.column for known in documented.get(quantity, ())]
    known = [c for name in names for c in columns if c.name == name]
    if known:
        return known
    ranked = [(rank, c) for c in columns if (rank := _rank(c, quantity)) is not None]
    return [column for _, column in sorted(ranked, key=lambda pair: pair[0])]


def _rank(column: Column, quantity: str) -> int | None:
    """How likely a column holds a quantity, 0 the likeliest; None where it does not."""
    kind, heading = QUANTITIES[quantity], read_heading(column.name)
    described = read_heading(column.description)
    if not (heading.plain and described.plain):
        return None
    if column.standard_name in kind.standard:
        return 0
    if any(column.standard_name in QUANTITIES[q].standard for q in QUANTITIES if q != quantity):
        return None
    return kind.names.index(heading.name) + 1 if heading.name in kind.names else None


def guess(headings: list[str], quantity: str) -> str | None:
    """The heading that most likely names a quantity; None where none does."""
    ranks = {h: _rank(Column(h), quantity) for h in headings}
    likely = [h for h in headings if ranks[h] is not None]
    return min(likely, key=lambda h: ranks[h] or 0) if likely else None


def _claim(column: Column, quantity: str, documented: Documented) -> Claim:
    heading, described = read_heading(column.name), read_heading(column.description)
    known = next((k for k in documented.get(quantity, ()) if k.column == column.name), None)
    if known is not None:
        return Claim(column.name, quantity, known.unit, known.height, "from", known, sensor=heading.sensor)
    unit = column.unit or heading.unit or UNIT_OF_NAME.get(heading.name, "")
    heights = (column.height, heading.height, described.height)
    height = next((h for h in heights if h is not None), None)
    refusal = column.sideways if quantity in ("eastward", "northward") else ""
    way = _way(column, heading, described)
    return Claim(column.name, quantity, unit, height, way, refusal=refusal, sensor=heading.sensor)


def _way(column: Column, heading: Heading, described: Heading) -> str:
    """Whether a direction is where the wind comes from or goes to, as far as it is stated."""
    if column.standard_name == "wind_to_direction":
        return "to"
    if column.standard_name == "wind_from_direction":
        return "from"
    return heading.way or described.way
