"""Choosing the columns of the wind among all that a file offers: one height, one convention, and said so."""

import math
from dataclasses import dataclass
from itertools import product

from barchan.errors import Problem, RecordError
from barchan.wind.records.claims import Claim
from barchan.wind.records.format import RecordFormat

USUAL_HEIGHT = 10.0
"""Height (m) that is preferred, as drift potential takes the wind there."""


@dataclass(frozen=True)
class Choice:
    """The columns that are read as the wind."""

    first: Claim
    """Speed, or eastward component."""
    second: Claim
    """Direction, or northward component."""
    height: float | None
    """Height of the speeds (m), where it is known."""
    remarks: tuple[str, ...]

    @property
    def components(self) -> bool:
        """Whether the wind is in components."""
        return self.first.quantity == "eastward"

    @property
    def names(self) -> dict[str, str]:
        """Names of the columns of speed and direction."""
        if self.components:
            return dict.fromkeys(("speed", "direction"), f"{self.first.column}, {self.second.column}")
        return {"speed": self.first.column, "direction": self.second.column}


def choose(
    claims: dict[str, list[Claim]], form: RecordFormat, names: list[str], source: str, kind: str = "column"
) -> Choice:
    """The columns (or variables, ``kind``) to read as the wind.

    Speed and direction of one height and one number of sensor come before others, then 10 m or the stated
    height, then speed and direction before components, then the likeliest name. Raises RecordError where
    there is no wind, none at a stated height, or only one that is known not to be of use.
    """
    pairs = [(rank, *pair) for rank, (x, y) in enumerate(_KINDS) for pair in product(claims[x], claims[y])]
    if not pairs:
        raise RecordError(_absent(claims, form, names, kind), source)
    if form.height is not None:
        pairs = _at(pairs, form.height, source)
    wanted = form.height or USUAL_HEIGHT
    _, first, second = min(pairs, key=lambda p: (_mismatch(p[1], p[2]), _far(p[1], wanted), p[0]))
    for claim in (first, second):
        if claim.refusal:
            raise RecordError([Problem(f"{kind} '{claim.column}'", claim.refusal)], source)
    height = form.height if first.height is None else first.height
    return Choice(first, second, height, tuple(_remarks(claims, first, second)))


_KINDS = (("speed", "direction"), ("eastward", "northward"))


def _mismatch(first: Claim, second: Claim) -> bool:
    """Whether two columns are of different heights, or of sensors with different numbers."""
    sides = ((first.height, second.height), (first.sensor, second.sensor))
    return any(None not in side and side[0] != side[1] for side in sides)


def _far(claim: Claim, wanted: float) -> float:
    """How far a height is from the wanted one; 0 where it is not stated."""
    return 0.0 if claim.height is None else abs(math.log(claim.height / wanted))


def _at(pairs: list[tuple[int, Claim, Claim]], height: float, source: str) -> list[tuple[int, Claim, Claim]]:
    """The pairs whose first column is at a height, or does not state one."""
    fitting = [p for p in pairs if p[1].height is None or math.isclose(p[1].height, height, rel_tol=1e-3)]
    if not fitting:
        heights = sorted({p[1].height for p in pairs if p[1].height is not None})
        told = ", ".join(f"{h:g}" for h in heights)
        raise RecordError([Problem("height", f"is {height:g} m; the file has winds at {told} m")], source)
    return fitting


def _absent(claims: dict[str, list[Claim]], form: RecordFormat, names: list[str], kind: str) -> list[Problem]:
    problems = []
    wanted = _KINDS[1] if claims["eastward"] or claims["northward"] else _KINDS[0]
    listed = f"the {kind}s are {', '.join(names)}"
    for quantity in wanted:
        stated = getattr(form, quantity)
        if stated and stated not in names:
            problems.append(Problem(quantity, f"no {kind} '{stated}'; {listed}"))
        elif not claims[quantity]:
            problems.append(Problem(quantity, f"no {kind} for the {_words(quantity)}; {listed}"))
    return problems


def _words(quantity: str) -> str:
    return quantity if quantity in _KINDS[0] else f"{quantity} wind"


def _remarks(claims: dict[str, list[Claim]], first: Claim, second: Claim) -> list[str]:
    said = []
    if _mismatch(first, second):
        said.append(f"the direction {second} is taken with the speed {first}, which has none of its own")
    chosen = {first.column, second.column}
    left = [c for kind in claims.values() for c in kind if c.column not in chosen]
    if left:
        told = ", ".join(dict.fromkeys(map(str, left)))
        said.append(f"the wind is read from {first} and {second}; not from {told}")
    if first.quantity == "speed" and second.way == "to":
        said.append(
            f"directions of '{second.column}' are where the wind goes to; turned to where it comes from"
        )
    return said
