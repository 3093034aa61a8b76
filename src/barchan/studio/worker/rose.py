"""The roses of the wind, as the wind panel draws them."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.saltation import Saltation
from barchan.scenario import Scenario
from barchan.simulation import Simulation
from barchan.theory.assessment import assess_record, scenario_drift, stated_winds, time_by_direction
from barchan.theory.crests import gross_transport
from barchan.theory.drift import Drift
from barchan.theory.roses import sand_rose, sector_sums, speed_limits, wind_rose
from barchan.wind import SeriesWind
from barchan.wind.clock import DAY
from barchan.wind.records import WindRecord


def rose_of(simulation: Simulation) -> dict[str, Any]:
    """How often the wind blows from each side, and how much sand it moves.

    Of a record that is all of it, of any other wind the scenario's run. Classes of speed (m/s) and days are
    known of winds in m/s alone.
    """
    if isinstance(simulation.wind, SeriesWind):
        record = simulation.wind.series(simulation.scenario.seed).record
        sand = simulation.scenario.clock or Saltation()
        return {**_of_record(record, sand), **_of_drift(assess_record(record, sand).drift)}
    scenario = simulation.scenario_in_force
    stated = stated_winds(scenario)
    time = _of_steps(scenario) if stated is None else _of_record(stated, scenario.clock or Saltation())
    return {**time, **_of_drift(scenario_drift(scenario))}


def _of_record(record: WindRecord, sand: Saltation) -> dict[str, Any]:
    """Shares of the time by sector and class of speed."""
    limits = speed_limits(record, sand.threshold_speed())
    shares, calms, _ = wind_rose(record, limits)
    return {"days": record.seconds / DAY, "limits": limits, "shares": shares.tolist(), "calms": calms}


def _of_steps(scenario: Scenario) -> dict[str, Any]:
    """Shares of the steps by sector alone."""
    directions, shares = time_by_direction(scenario)
    rose: NDArray[np.float64] = sector_sums(directions, shares)
    return {"days": None, "limits": [], "shares": rose[:, np.newaxis].tolist(), "calms": 1.0 - shares.sum()}


def _of_drift(drift: Drift) -> dict[str, Any]:
    """Sand by sector, where it goes, and the crests to expect."""
    return {
        "sand": sand_rose(drift).tolist(),
        "toward": _known(drift.toward),
        "steadiness": _known(drift.steadiness),
        "crest": _known(gross_transport(drift).azimuth),
    }


def _known(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
