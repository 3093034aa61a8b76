"""Species of plants: how they grow and die with the year's sediment balance."""

from itertools import pairwise
from typing import Self

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError, model_validator

from barchan.parameters import Parameters, mistake, parameter, redeclared

SPECIES = ("grass", "mesquite", "shrub")

FIGURE = "Prague thesis, Fig. 3.6; numbers of DECAL's descendants"
ASSUMED = "ours: assumed, for the published curve was not found"
RANGES = "Prague thesis, §4.7: physiological ranges"

LEAST, MOST = -10.0, 10.0
"""Bounds of a coefficient of vegetation."""


class Vertex(Parameters):
    """A point of a growth curve."""

    balance: float = parameter(
        unit="m/yr", ge=-1000, le=1000, meaning="Sand gained (negative: lost) in a year.", source=FIGURE
    )
    change: float = parameter(
        unit="1/yr",
        ge=-100,
        le=100,
        meaning="Change of effectiveness in a year at that balance.",
        source=FIGURE,
    )


class Species(Parameters):
    """How one kind of plant grows and dies."""

    lowest: float = parameter(unit="-", ge=LEAST, le=MOST, meaning="Least effectiveness.", source=RANGES)
    highest: float = parameter(unit="-", ge=LEAST, le=MOST, meaning="Greatest effectiveness.", source=RANGES)
    curve: list[Vertex] = parameter(
        unit="-",
        min_length=2,
        max_length=100,
        meaning="Growth against the year's balance: straight between the points, held beyond them.",
        source=FIGURE,
    )

    @model_validator(mode="after")
    def _is_a_function(self) -> Self:
        found = [
            mistake(("curve", at, "balance"), f"is {later} after {earlier}; allowed: balances that increase")
            for at, (earlier, later) in enumerate(pairwise(v.balance for v in self.curve), start=1)
            if later <= earlier
        ]
        if self.lowest > self.highest:
            found.append(mistake(("lowest",), f"is {self.lowest}, above highest {self.highest}"))
        if found:
            raise ValidationError.from_exception_data(type(self).__name__, found)
        return self

    def growth(self, balance: NDArray[np.float64]) -> NDArray[np.float64]:
        """Change of effectiveness in a year with these balances (m)."""
        x, y = zip(*((vertex.balance, vertex.change) for vertex in self.curve), strict=True)
        return np.interp(balance, x, y)

    def grown(self, cover: NDArray[np.float64], balance: NDArray[np.float64]) -> NDArray[np.float64]:
        """Effectiveness a year later."""
        return np.clip(cover + self.growth(balance), self.lowest, self.highest)


def points(*pairs: tuple[float, float]) -> list[Vertex]:
    """The points (balance, change) of a curve."""
    return [Vertex(balance=balance, change=change) for balance, change in pairs]


class Grass(Species):
    """Pioneer grass."""

    lowest: float = redeclared(Species, "lowest", 0.0, RANGES)
    highest: float = redeclared(Species, "highest", 1.0, RANGES)
    curve: list[Vertex] = redeclared(
        Species,
        "curve",
        lambda: points((-1.4, -1.0), (0.1, 0.0), (0.45, 0.4), (0.85, 0.0), (1.4, -1.0)),
        FIGURE,
    )


class Mesquite(Species):
    """Mesquite: like the shrub under erosion, with a broad optimum under moderate burial."""

    lowest: float = redeclared(Species, "lowest", -1.0, RANGES)
    highest: float = redeclared(Species, "highest", 3.0, RANGES)
    curve: list[Vertex] = redeclared(
        Species,
        "curve",
        lambda: points((-1.3, -1.0), (-0.65, 0.0), (0.1, 0.1), (0.5, 0.1), (1.5, 0.0), (2.5, -1.0)),
        ASSUMED,
    )


class Shrub(Species):
    """Woody shrub."""

    lowest: float = redeclared(Species, "lowest", -0.5, RANGES)
    highest: float = redeclared(Species, "highest", 1.5, RANGES)
    curve: list[Vertex] = redeclared(
        Species,
        "curve",
        lambda: points((-1.3, -1.0), (-0.65, 0.0), (0.0, 0.1), (0.2, 0.0), (2.2, -1.0)),
        FIGURE,
    )
