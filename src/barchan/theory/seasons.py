"""Drift potential by month and by season."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from barchan.theory.drift import THRESHOLD, Drift, drift_potential
from barchan.wind.clock import DAY, YEAR
from barchan.wind.records import WindRecord

Parting = Literal["month", "season"]

_MONTHS = ("January", "February", "March", "April", "May", "June", "July", "August", "September", "October",
           "November", "December")  # fmt: skip
_DAYS = (31, 28.25, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)
"""Mean lengths of the months (days); they add up to 365.25."""

_SEASONS = {
    "December to February": (11, 0, 1),
    "March to May": (2, 3, 4),
    "June to August": (5, 6, 7),
    "September to November": (8, 9, 10),
}


@dataclass(frozen=True)
class PartOfYear:
    """A month or a season of a record, all years together."""

    name: str
    days: float
    """Days of winds that the record has in it."""
    potential: Drift
    """Its part of the drift potential of a year (VU)."""


def by_part_of_year(record: WindRecord, parting: Parting, threshold: float = THRESHOLD) -> list[PartOfYear]:
    """Drift potential of each month or season of which the record has winds, speeds being those at 10 m.

    Each month counts for its length in a mean year, whatever part of it the record covers, so that the
    parts add
    up to the drift potential of a year. ``threshold`` is in knots. Raises ValueError where the record has no
    dates.
    """
    if record.start is None:
        raise ValueError("the record has no dates, so months are not known")
    stamps = record.start + (record.time * 1e3).astype("timedelta64[ms]")
    month = stamps.astype("datetime64[M]").astype(np.int64) % 12
    parts = {name: (k,) for k, name in enumerate(_MONTHS)} if parting == "month" else _SEASONS
    found = [_part(name, months, month, record, threshold) for name, months in parts.items()]
    return [part for part in found if part.days > 0]


def _part(
    name: str, months: Sequence[int], month: np.ndarray, record: WindRecord, threshold: float
) -> PartOfYear:
    seconds, drifts = 0.0, []
    for number in months:
        these = month == number
        if not these.any():
            continue
        some = record.picked(these)
        drift = drift_potential(some, threshold)
        drifts.append(replace(drift, amount=drift.amount * (_DAYS[number] * DAY / YEAR)))
        seconds += some.seconds
    directions = np.concatenate([d.direction for d in drifts]) if drifts else np.zeros(0)
    amounts = np.concatenate([d.amount for d in drifts]) if drifts else np.zeros(0)
    return PartOfYear(name, seconds / DAY, Drift(directions, amounts, "VU", record.direction_width))
