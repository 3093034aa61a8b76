"""Everything that the theories say of a wind, at once."""

import math
from dataclasses import dataclass, replace

import numpy as np

from barchan.aeolian.saltation import Saltation
from barchan.scenario import Scenario
from barchan.theory.crests import Crest, bed_instability, elongation, gross_transport
from barchan.theory.drift import KNOT, THRESHOLD, Drift, drift_of, drift_potential, sand_flux
from barchan.theory.dune_types import dune_type
from barchan.theory.variability import Variability, variability
from barchan.wind.clock import DAY, spoken
from barchan.wind.records import WindRecord

FRYBERGER_HEIGHT = 10.0
"""Height (m) at which drift potential takes the wind."""

SHORTEST_YEAR = 350.0
"""Days from which on a record counts as annual."""

LONGEST_MEAN = 6 * 3600.0
"""Duration of a row (s) above which a mean hides too much of the wind."""

MOST_STEPS = 10_000
"""Steps of a scenario whose winds are looked at."""


@dataclass(frozen=True)
class Assessment:
    """Expectations for a wind."""

    drift: Drift
    """Sand moved, in m²/yr or as shares."""
    potential: Drift | None
    """Drift potential (VU), of winds in m/s."""
    variability: Variability
    gross_transport: Crest
    bed_instability: Crest
    elongation: float
    """Where fingers grow to (degrees); NaN where they do not."""
    dunes: str
    threshold: float = THRESHOLD
    """Threshold of the drift potential (knots at 10 m)."""
    remarks: tuple[str, ...] = ()
    """What the record cannot tell."""

    @property
    def moves(self) -> bool:
        """Whether any sand moves."""
        return self.drift.total > 0


def assess(drift: Drift, potential: Drift | None = None, supply: float | None = None) -> Assessment:
    """Classes, crests and dunes for a drift, and for its drift potential where there is one.

    ``supply`` is the equivalent sand thickness (m), where it is known.
    """
    return Assessment(
        drift,
        potential,
        variability(drift),
        gross_transport(drift),
        bed_instability(drift),
        elongation(drift),
        dune_type(drift.steadiness, supply),
    )


def assess_record(record: WindRecord, sand: Saltation, supply: float | None = None) -> Assessment:
    """Expectations for a wind record over some sand.

    Speeds are at the record's height, or at that of the sand's law where the record states none. Drift
    potential
    takes them at 10 m, by the law of the wall; its threshold is 12 knots, or the sand's where that is stated.
    """
    high = at_ten_metres(record, sand)
    threshold = THRESHOLD if sand.threshold is None else sand.threshold * _up(sand) / KNOT
    found = assess(sand_flux(record, sand), drift_potential(high, threshold), supply)
    return replace(found, threshold=threshold, remarks=tuple(_remarks(record)))


def at_ten_metres(record: WindRecord, sand: Saltation) -> WindRecord:
    """The record with its speeds as they are at 10 m, by the law of the wall."""
    speed = sand.at_own_height(record.speed, record.height) * _up(sand)
    return replace(record, speed=speed, height=FRYBERGER_HEIGHT)


def _up(sand: Saltation) -> float:
    """The speed at 10 m over that at the height of the sand's law."""
    return math.log(FRYBERGER_HEIGHT / sand.roughness_length) / math.log(sand.height / sand.roughness_length)


def is_annual(record: WindRecord) -> bool:
    """Whether a record covers a year, so that its drift potential is annual."""
    return float(record.time[-1] + record.duration[-1]) >= SHORTEST_YEAR * DAY


def _remarks(record: WindRecord) -> list[str]:
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
            f"potential "
            "comes out too low"
        )
    return said


def scenario_supply(scenario: Scenario) -> float:
    """The sand of a scenario's first bed, spread evenly over the ground (m)."""
    scenario = scenario.seeded()
    bed = scenario.first_bed()
    return float(bed.depth.mean())


def scenario_drift(scenario: Scenario) -> Drift:
    """The drift of a scenario's winds over its run: polls a cell times hop length, as shares of the whole.

    Of a long run it is that of the first 10,000 steps.
    """
    steps = min(max(scenario.run.steps, 1), MOST_STEPS)
    own = getattr(scenario.model, "hop_length", 1.0)
    works: dict[float, float] = {}
    for _, count, intervals in scenario.seeded().forcing().constant_intervals(0, steps):
        for s in intervals:
            hop = own if s.hop_length is None else s.hop_length
            works[s.direction] = works.get(s.direction, 0.0) + count * s.share * s.strength * hop
    winds = list(works.items())
    drift = drift_of(winds)
    return replace(drift, amount=drift.amount / drift.total) if drift.total > 0 else drift
