"""What limits the drift that is found from a wind record, and what makes it doubtful."""

import numpy as np

from barchan.theory.drift import HIGHEST, KNOT, undirected_share
from barchan.wind.clock import DAY, spoken
from barchan.wind.records import WindRecord
from barchan.words import counted

SHORTEST_YEAR = 350.0
"""Days from which on a record counts as annual."""

LONGEST_MEAN = 6 * 3600.0
"""Duration of a row (s) above which a mean hides too much of the wind."""


def is_annual(record: WindRecord) -> bool:
    """Whether a record covers a year, so that its drift potential is annual."""
    return float(record.time[-1] + record.duration[-1]) >= SHORTEST_YEAR * DAY


def record_remarks(record: WindRecord) -> list[str]:
    """What a record is too short, or too coarse, for."""
    said = []
    if not is_annual(record):
        covered = (record.time[-1] + record.duration[-1]) / DAY
        said.append(
            f"the record spans {covered:.3g} days: its drift potential is that of these days, not of a year"
        )
    usual = float(np.median(record.duration))
    if usual > LONGEST_MEAN:
        said.append(
            f"rows stand for {spoken(usual)} each; means over so long hide strong winds, and the drift "
            "potential comes out too low"
        )
    return said


def undirected_drift_remarks(record: WindRecord, threshold: float) -> list[str]:
    """How winds without a direction count in the drift potential above a threshold (knots at 10 m)."""
    which = record.without_direction
    if not which.any():
        return []
    above = record.speed > threshold * KNOT
    if not above[which].any():
        return ["rows without a direction stay below the threshold: time without drift"]
    rows = counted(int(np.count_nonzero(above & which)), "row")
    return [
        (
            f"in {rows} without a direction the speed exceeds "
            f"the threshold: {100 * undirected_share(record, threshold):.2g} % of the drift potential, "
            "shared over all directions as the rest is"
        )
    ]


def doubts_of(potential: float) -> tuple[str, ...]:
    """Doubt of a drift potential (VU) of a year."""
    if potential <= HIGHEST:
        return ()
    return (
        (
            f"the drift potential is {potential:.0f} VU; more than {HIGHEST:.0f} VU are hardly "
            "possible: is the unit of the speeds right? State it as unit"
        ),
    )
