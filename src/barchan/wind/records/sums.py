"""Running sums of what fell, as some reanalyses give them, turned into amounts since the row before."""

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError

DAY = 86_400.0
"""A day (s)."""

ENOUGH = 2
"""Times that a column starts over from which on it is taken for running sums."""

MOSTLY = 0.8
"""Share of rows that do not fall nor stay at zero from which on a column is taken for running sums."""

_ROUNDING = 1e-9


def amounts_of(
    values: NDArray[np.float64],
    time: NDArray[np.float64],
    accumulated: bool | None,
    numbers: NDArray[np.int64],
    column: str,
    source: str,
) -> NDArray[np.float64]:
    """Amounts since the row before; ``accumulated`` says whether the values are running sums.

    A sum starts over at one time of the day. Raises RecordError where it falls at another, or where nothing
    is said of a column that looks like running sums.
    """
    order = np.argsort(time, kind="stable")
    ordered, clock = values[order], time[order] % DAY
    steps = np.diff(ordered)
    falls = np.flatnonzero(steps < -_ROUNDING) + 1
    if accumulated is None and _looks_summed(ordered, clock, falls):
        message = (
            f"falls at one time of the day only, {len(falls)} times: is it a running sum? State "
            "accumulated: true, or false for amounts since the row before"
        )
        raise RecordError([Problem(f"column '{column}'", message)], source)
    if not accumulated:
        return values
    if len(falls):
        phases, counts = np.unique(np.round(clock[falls]), return_counts=True)
        usual = phases[np.argmax(counts)]
        odd = falls[np.round(clock[falls]) != usual]
        if len(odd):
            row = order[odd[0]]
            message = (
                f"is {ordered[odd[0]]:g} after {ordered[odd[0] - 1]:g}; allowed: sums that fall only where "
                "they start over, at one time of the day"
            )
            raise RecordError([Problem(f"row {numbers[row]}, column '{column}'", message)], source)
    amounts = np.full(len(values), np.nan)
    amounts[order[1:]] = np.where(steps < -_ROUNDING, ordered[1:], steps)
    return amounts


def _looks_summed(values: NDArray[np.float64], clock: NDArray[np.float64], falls: NDArray[np.intp]) -> bool:
    """Whether values rise through every day and fall at one time of it only."""
    if len(falls) < ENOUGH or len(np.unique(np.round(clock[falls]))) > 1 or len(np.unique(clock)) <= ENOUGH:
        return False
    return float(np.mean(values > 0.0)) > MOSTLY
