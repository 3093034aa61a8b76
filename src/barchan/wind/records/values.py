"""From the words and numbers of columns to winds in m/s and degrees."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.missing import marked
from barchan.wind.records.choice import Choice
from barchan.wind.records.claims import Claim
from barchan.wind.records.format import USUAL_TEXTS, RecordFormat
from barchan.wind.records.quantities import QUANTITIES

if TYPE_CHECKING:
    import pandas as pd

VARIABLE = frozenset(["vrb", "variable", "var"])
"""Words for a wind without a certain direction."""

VARIABLE_CODE = 990.0
"""Code of weather services for a wind without a certain direction."""

CALM = frozenset(["calm", "clm", "c"])
"""Words for no wind, in a column of speeds or of directions."""

_POINTS = ["N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"]
COMPASS = {name.lower(): 22.5 * k for k, name in enumerate(_POINTS)}
"""Degrees of the points of the compass."""

_LETTERS = frozenset("nesowz")
"""Letters of the points of the compass in the languages that are known."""

_ROUNDING = 0.01
"""Degrees by which a full turn may be exceeded, as 6.2832 rad is."""

_FILL = 1e19
"""Numbers from here on fill in for missing values in NetCDF."""

_LONG = {"north": "n", "east": "e", "south": "s", "west": "w", "-": "", " ": ""}


@dataclass(frozen=True)
class Unit:
    """The unit of a column."""

    name: str
    size: float
    """m/s, or degrees, in one."""
    remark: str = ""
    """The assumption made, if any."""
    stated: bool = True
    """Whether the file or the user states it."""


def unit_of(claim: Claim, form: RecordFormat, source: str) -> Unit:
    """Unit of a column: the stated one, that of the file, or the usual one.

    Raises RecordError at a unit that is not known, or known and of no use.
    """
    kind = QUANTITIES[claim.quantity]
    sizes = kind.dimension.sizes
    stated = form.direction_unit if claim.quantity == "direction" else form.unit
    if stated:
        said = claim.unit and kind.dimension.unit_of(claim.unit)
        differs = said and said != stated
        told = f"column '{claim.column}' states {said}; taken as {stated}, as asked for" if differs else ""
        return Unit(stated, sizes[stated], told)
    if claim.unit:
        found = kind.dimension.required(claim.unit, claim.column, source)
        return Unit(found, sizes[found])
    told = f"column '{claim.column}' states no unit; taken as {kind.usual_unit}" if kind.said else ""
    return Unit(kind.usual_unit, sizes[kind.usual_unit], told, stated=False)


def wind_of(
    choice: Choice, first: NDArray[np.float64], second: NDArray[np.float64], form: RecordFormat
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Speeds (m/s) and where the winds come from (degrees), of the chosen columns in m/s and degrees."""
    if choice.components:
        return np.hypot(first, second), np.degrees(np.arctan2(-first, -second)) % 360.0
    inside = (second >= 0) & (second <= 360.0 + _ROUNDING)
    from_there = np.where(inside, np.minimum(second, 360.0), second)
    if (form.convention or choice.second.way) == "to":
        from_there = np.where(inside, (from_there + 180.0) % 360.0, from_there)
    return first, from_there


def without_codes(values: NDArray[np.float64], claim: Claim, form: RecordFormat) -> NDArray[np.float64]:
    """Numbers of a column as the file has them, NaN where they stand for a missing value."""
    codes = [*form.codes, *(claim.stated.missing if claim.stated else ())]
    if claim.quantity == "direction":
        codes.append(VARIABLE_CODE)
    if claim.stated and claim.stated.calm is not None:
        codes.append(claim.stated.calm)
    absent = marked(values, codes) | ~(np.abs(values) < _FILL)
    return np.where(absent, np.nan, values)


def numbers_of(
    words: "pd.Series",
    claim: Claim,
    unit: Unit,
    rows: NDArray[np.int64],
    source: str,
    absent: frozenset[str] = USUAL_TEXTS,
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """A column of words as numbers, NaN at texts of ``absent``, and which rows say that the air is calm.

    Points of the compass become angles in the column's own unit, also those with O, which is east in German
    and Dutch and west in French, Spanish and Italian: the column's other letters tell. Raises RecordError at
    a word that is none of these.
    """
    import pandas as pd

    plain = words.str.strip()
    english = _letters_of(plain) if claim.quantity == "direction" else {}
    values = pd.to_numeric(plain, errors="coerce").to_numpy(np.float64, copy=True)
    strange = np.isnan(values)
    calm = np.zeros(len(values), bool)
    for word in plain[strange].unique():
        here = strange & (plain == word).to_numpy()
        low = str(word).lower()
        if low in absent:
            continue
        point = COMPASS.get(_short(low).translate(english)) if claim.quantity == "direction" else None
        if low in CALM:
            calm |= here
            values[here] = 0.0 if claim.quantity == "speed" else np.nan
        elif point is not None:
            values[here] = point / unit.size
        elif not (claim.quantity == "direction" and low in VARIABLE):
            where = f"row {rows[int(np.argmax(here))]}, column '{words.name}'"
            allowed = _allowed(claim.quantity)
            if claim.quantity == "direction" and "o" in low and _LETTERS.issuperset(low):
                allowed += (
                    "; O is east (Ost) or west (ouest), and the column's other letters do not tell which"
                )
            raise RecordError([Problem(where, f"is '{word}'; allowed: {allowed}")], source)
    return values, calm


def _letters_of(words: "pd.Series") -> dict[int, str]:
    """The English letters of points of the compass that are written with O and Z, by a column's letters.

    Beside W, without E, O is east (German, Dutch); beside E, without W, it is west (French, Spanish, Italian,
    Portuguese). Z, without S, is south (Dutch).
    """
    found = {word.lower() for word in map(str, words.unique())}
    letters = set().union(*(word for word in found if word and _LETTERS.issuperset(word)))
    english = {}
    if "o" in letters and ("w" in letters) != ("e" in letters):
        english["o"] = "e" if "w" in letters else "w"
    if "z" in letters and "s" not in letters:
        english["z"] = "s"
    return str.maketrans(english)


def _short(word: str) -> str:
    for long, short in _LONG.items():
        word = word.replace(long, short)
    return word


def _allowed(quantity: str) -> str:
    also = ", points of the compass (N, WSW), VRB, Calm" if quantity == "direction" else ", Calm"
    return f"numbers{also}, or nothing"
