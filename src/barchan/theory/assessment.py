"""Everything that the theories say of a wind, at once."""

import math
from dataclasses import dataclass, replace

from barchan.aeolian.saltation import Saltation
from barchan.scenario import Scenario
from barchan.theory.crests import Crest, bed_instability, elongation, gross_transport
from barchan.theory.drift import Drift, drift_of, drift_potential, sand_flux
from barchan.theory.dune_types import dune_type
from barchan.theory.variability import Variability, variability
from barchan.wind.records import WindRecord

FRYBERGER_HEIGHT = 10.0
"""Height (m) at which drift potential takes the wind."""

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

    Drift potential takes the speed at 10 m, by the law of the wall from the height of the record.
    """
    up = math.log(FRYBERGER_HEIGHT / sand.roughness_length) / math.log(sand.height / sand.roughness_length)
    potential = drift_potential(replace(record, speed=record.speed * up))
    return assess(sand_flux(record, sand), potential, supply)


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
