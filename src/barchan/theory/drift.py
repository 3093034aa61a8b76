"""Sand drift under many winds: how much, which way, how variable.

A drift is given by directions (where each wind comes from) and amounts: drift potential, flux times duration,
or any weight in proportion to the sand that each wind moves.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.saltation import Saltation
from barchan.wind.clock import YEAR
from barchan.wind.records import WindRecord
from barchan.wind.records.units import UNITS

KNOT = UNITS["kn"]

THRESHOLD = 12.0
"""Threshold speed of drift potential (knots at 10 m): Fryberger & Dean (1979)."""

ENERGY = ((200.0, "low"), (400.0, "intermediate"), (np.inf, "high"))
"""Energy of a wind by drift potential (vector units in knots): Fryberger & Dean (1979)."""


@dataclass(frozen=True)
class Drift:
    """Sand moved by each of many winds."""

    direction: NDArray[np.float64]
    """Where each wind comes from (degrees)."""
    amount: NDArray[np.float64]
    """How much sand it moves; not negative."""
    unit: str = "-"
    width: float = 0.0
    """Degrees that each direction stands for; 0 where it is exact."""

    @property
    def total(self) -> float:
        """All that is moved, whichever way: the drift potential DP, in the unit of the amounts."""
        return float(self.amount.sum())

    @property
    def vector(self) -> tuple[float, float]:
        """Sum of all movements (east, north)."""
        angle = np.radians(self.direction)
        return -float(self.amount @ np.sin(angle)), -float(self.amount @ np.cos(angle))

    @property
    def resultant(self) -> float:
        """Magnitude of the vector sum of all movements: the resultant drift potential RDP."""
        return float(np.hypot(*self.vector))

    @property
    def toward(self) -> float:
        """Where the resultant points: the resultant drift direction RDD, degrees clockwise from north.

        NaN where the movements cancel.
        """
        east, north = self.vector
        if self.resultant <= 1e-9 * self.total:
            return float("nan")
        return float(np.degrees(np.arctan2(east, north)) % 360.0)

    @property
    def steadiness(self) -> float:
        """RDP/DP: 1 for a single direction, 0 where all cancel, NaN where nothing moves."""
        return self.resultant / self.total if self.total > 0 else float("nan")

    def by_degree(self) -> "Drift":
        """The same drift summed by whole degrees, which is quicker to work with where winds are many."""
        degree = np.round(self.direction).astype(np.int64) % 360
        sums = np.bincount(degree, self.amount, 360).astype(np.float64)
        return Drift(np.arange(360.0), sums, self.unit, self.width)


def drift_of(winds: list[tuple[float, float]], unit: str = "-") -> Drift:
    """The drift of winds given as (direction it comes from, amount of sand moved)."""
    directions, amounts = np.array(winds, np.float64).reshape(-1, 2).T
    return Drift(directions, amounts, unit)


def drift_potential(record: WindRecord, threshold: float = THRESHOLD) -> Drift:
    """Drift potential in vector units (VU) by knots, of speeds at 10 m, with a threshold speed (knots) there.

    U² (U - U_t) t above the threshold, U in knots and t the share of the time: Fryberger & Dean (1979), USGS
    Prof. Pap. 1052, 137. Each row has its own weight, so there is no bias from classes of speed.
    """
    amounts = _directed(record, _potential(record, threshold))
    return Drift(record.direction, amounts, "VU", record.direction_width)


def undirected_share(record: WindRecord, threshold: float = THRESHOLD) -> float:
    """Share of the drift potential that winds without a known direction have; 0 where there is none."""
    amounts = _potential(record, threshold)
    return float(amounts[record.without_direction].sum()) / max(float(amounts.sum()), 1e-300)


def _potential(record: WindRecord, threshold: float) -> NDArray[np.float64]:
    """Drift potential (VU) of each row."""
    speed = record.speed / KNOT
    weight = np.where(speed > threshold, speed**2 * (speed - threshold), 0.0)
    amounts: NDArray[np.float64] = weight * record.duration / record.seconds
    return amounts


def sand_flux(record: WindRecord, sand: Saltation) -> Drift:
    """Sand that each wind moves in a mean year, m² a year of sand as it lies, by a flux law.

    Speeds are brought from the record's height to that of the law, where the record states it.
    """
    share = record.duration / record.seconds
    flux = sand.volume_flux(sand.at_own_height(record.speed, record.height))
    amounts = _directed(record, flux * share * YEAR)
    return Drift(record.direction, amounts, "m²/yr", record.direction_width)


def _directed(record: WindRecord, amounts: NDArray[np.float64]) -> NDArray[np.float64]:
    """Amounts by row, those of winds without a direction shared over the others in proportion to theirs.

    So all sand counts in the total, and the unknown directions change no share and no resultant of the
    known ones. Where no wind with a direction moves sand, those without keep the direction before them.
    """
    known = np.where(record.without_direction, 0.0, amounts)
    total = float(known.sum())
    return known * (float(amounts.sum()) / total) if total > 0.0 else amounts


HIGHEST = 5000.0
"""Drift potential (VU) of a year above which a wind is doubted, a limit of ours: 12 times that from which on
Fryberger & Dean (1979) call the energy high. A steady wind of 11 m/s has it."""


def energy(potential: float) -> str:
    """Energy of a wind by its drift potential (VU in knots): low, intermediate or high."""
    return next(name for limit, name in ENERGY if potential < limit)


def in_metres(potential: float) -> float:
    """Drift potential in vector units by metres a second, of one in knots (Bullard 1997)."""
    return potential * KNOT**3
