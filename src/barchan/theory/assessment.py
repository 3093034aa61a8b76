"""Everything that the theories say of a wind, at once."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.saltation import Saltation
from barchan.scenario import Scenario
from barchan.theory.crests import Crest, bed_instability, elongation, gross_transport
from barchan.theory.drift import (
    KNOT,
    THRESHOLD,
    Drift,
    drift_of,
    drift_potential,
    sand_flux,
)
from barchan.theory.dune_types import dune_type
from barchan.theory.limits_nearby import class_nearby, dunes_nearby
from barchan.theory.record_remarks import doubts_of, is_annual, record_remarks, undirected_drift_remarks
from barchan.theory.variability import Variability, variability
from barchan.wind.clock import YEAR
from barchan.wind.interval import WindInterval
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
    threshold: float = THRESHOLD
    """Threshold of the drift potential (knots at 10 m)."""
    remarks: tuple[str, ...] = ()
    """What the record cannot tell."""
    warnings: tuple[str, ...] = ()
    """What makes the wind implausible."""
    supply: float | None = None
    """Equivalent sand thickness (m), where it is known."""

    @property
    def nearby(self) -> tuple[str, ...]:
        """Limits of classes that are near, and the class or dune beyond; none where nothing moves."""
        if not self.moves:
            return ()
        return (*class_nearby(self.drift), *dunes_nearby(self.drift.steadiness, self.supply))

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
        supply=supply,
    )


def assess_record(record: WindRecord, sand: Saltation, supply: float | None = None) -> Assessment:
    """Expectations for a wind record over some sand.

    Speeds are at the record's height, or at that of the sand's law where the record states none. Drift
    potential
    takes them at 10 m, by the law of the wall; its threshold is 12 knots, or the sand's where that is stated.
    """
    high = at_ten_metres(record, sand)
    threshold = _threshold_of(sand)
    potential = drift_potential(high, threshold)
    found = assess(sand_flux(record, sand), potential, supply)
    doubts = doubts_of(potential.total) if is_annual(record) else ()
    warnings = () if record.unit_stated else doubts
    said = doubts if record.unit_stated else ()
    remarks = (*record_remarks(record), *undirected_drift_remarks(high, threshold), *said)
    return replace(found, threshold=threshold, remarks=remarks, warnings=warnings)


def _threshold_of(sand: Saltation) -> float:
    """Threshold of the drift potential (knots at 10 m): 12, or the sand's where that is stated."""
    return THRESHOLD if sand.threshold is None else sand.threshold * _up(sand) / KNOT


def at_ten_metres(record: WindRecord, sand: Saltation) -> WindRecord:
    """The record with its speeds as they are at 10 m, by the law of the wall."""
    speed = sand.at_own_height(record.speed, record.height) * _up(sand)
    return replace(record, speed=speed, height=FRYBERGER_HEIGHT)


def _up(sand: Saltation) -> float:
    """The speed at 10 m over that at the height of the sand's law."""
    return math.log(FRYBERGER_HEIGHT / sand.roughness_length) / math.log(sand.height / sand.roughness_length)


def scenario_supply(scenario: Scenario) -> float:
    """The sand of a scenario's first bed, spread evenly over the ground (m)."""
    scenario = scenario.seeded()
    bed = scenario.first_bed()
    return float(bed.depth.mean())


def assess_winds(scenario: Scenario, supply: float | None = None) -> Assessment:
    """Expectations for the winds of a scenario that are no record, as if they went on all year.

    Where they state their speeds in m/s the drift potential is that of these speeds, brought from the
    clock's height to 10 m. ``supply`` is the equivalent sand thickness (m), where it is known.
    """
    sand, drift = scenario.clock or Saltation(), scenario_drift(scenario)
    record = stated_winds(scenario)
    if record is None:
        return assess(drift, supply=supply)
    threshold = _threshold_of(sand)
    found = assess(drift, drift_potential(at_ten_metres(record, sand), threshold), supply)
    return replace(found, threshold=threshold, remarks=_gust_remarks(scenario))


def stated_winds(scenario: Scenario) -> WindRecord | None:
    """The winds of a scenario that states all of them in m/s, as a record at the height of its clock.

    Of a long run those of the first 10,000 steps. None where a wind states none, or steps have no duration.
    """
    seconds, own = scenario.step_seconds, getattr(scenario.model, "wind_speed", None)
    if seconds is None:
        return None
    rows = []
    for start, count, intervals in _winds(scenario):
        time = start * seconds
        for s in intervals:
            speed = _speed_of(s, own)
            if speed is None:
                return None
            rows.append((time, count * s.share * seconds, speed, s.direction))
            time += s.share * seconds
    times, durations, speeds, directions = np.array(rows, np.float64).reshape(-1, 4).T
    height = scenario.clock.height if scenario.clock is not None else FRYBERGER_HEIGHT
    return WindRecord(times, durations, speeds, directions, height=height)


def _speed_of(interval: WindInterval, own: float | None) -> float | None:
    """Speed (m/s) of an interval: the one that it states, 0 in a calm, or the model's ``own``."""
    if interval.strength == 0.0 and interval.speed is None:
        return 0.0
    return own if interval.speed is None and interval.hop_length is None else interval.speed


def _gust_remarks(scenario: Scenario) -> tuple[str, ...]:
    gusty = any(part.gusts is not None and part.varies for _, part in scenario.wind.placed_parts())
    return ("the drift potential is that of mean speeds, without gusts",) if gusty else ()


def _winds(scenario: Scenario) -> Iterator[tuple[int, int, list[WindInterval]]]:
    """The winds of a run, of a long one those of its first steps; see ``Forcing.constant_intervals``."""
    steps = min(max(scenario.run.steps, 1), MOST_STEPS)
    return scenario.seeded().forcing().constant_intervals(0, steps)


def time_by_direction(scenario: Scenario) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Directions (degrees) of a scenario's winds, and the shares of its steps for which each blows.

    Calms are left out, so that the shares sum to less than 1 where there are any. Of a long run those of
    the first 10,000 steps.
    """
    times: dict[float, float] = {}
    total = 0
    for _, count, intervals in _winds(scenario):
        total += count
        for s in intervals:
            if s.strength > 0.0 or s.speed:
                times[s.direction] = times.get(s.direction, 0.0) + count * s.share
    return np.array(list(times)), np.array(list(times.values())) / max(total, 1)


def scenario_drift(scenario: Scenario) -> Drift:
    """The drift of a scenario's winds over its run: polls a cell times hop length, as shares of the whole.

    It is in m²/yr where a clock tells the flux of every wind. Of a long run it is that of the first 10,000
    steps.
    """
    own = getattr(scenario.model, "hop_length", 1.0)
    works: dict[float, float] = {}
    steps, in_cells = 0, False
    for _, count, intervals in _winds(scenario):
        steps += count
        for s in intervals:
            hop = own if s.hop_length is None else s.hop_length
            in_cells |= s.speed is None and s.strength > 0.0
            works[s.direction] = works.get(s.direction, 0.0) + count * s.share * s.strength * hop
    drift = drift_of(list(works.items()))
    if scenario.clock is not None and not in_cells:
        volume = scenario.new_model().step_volume()
        flux = volume / scenario.clock.duration(volume) * YEAR
        return replace(drift, amount=drift.amount / (own * steps) * flux, unit="m²/yr")
    return replace(drift, amount=drift.amount / drift.total) if drift.total > 0 else drift
