"""The roses of the wind, and what ``barchan wind`` tells of it, as the wind panel shows them."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.saltation import Saltation
from barchan.scenario import Scenario
from barchan.simulation import Simulation
from barchan.theory.assessment import stated_winds, time_by_direction
from barchan.theory.crests import gross_transport
from barchan.theory.drift import Drift
from barchan.theory.roses import sand_rose, sector_sums, speed_limits, wind_rose
from barchan.theory.wind_report import Subject, of_winds
from barchan.theory.wind_table import plain_rows, weather_rows
from barchan.wind.clock import DAY
from barchan.wind.records import WindRecord


def rose_of(simulation: Simulation) -> dict[str, Any]:
    """How often the wind blows from each side, how much sand it moves, and the table and remarks of it.

    Of a record that is all that was measured, of any other wind the scenario's run. Classes of speed (m/s)
    and days are known of winds in m/s alone. Over snow nothing is told that holds for dry sand only.
    """
    scenario = simulation.scenario_as_run
    supply = float(simulation.bed.depth.mean())
    told = of_winds(scenario, supply)
    record = stated_winds(scenario) if told.record is None else told.measured
    time = _of_steps(scenario) if record is None else _of_record(record, told.sand)
    if told.over_snow:
        return {**time, "sand": None, "toward": None, "steadiness": None, "crest": None, **_over_snow(told)}
    return {**time, **_of_drift(told.found.drift), **_in_words(told, supply)}


def _over_snow(told: Subject) -> dict[str, Any]:
    """Rows and warnings of a record itself, and a remark on what is left out."""
    record = told.measured
    if record is None:
        return {"rows": [], "warnings": (), "remarks": told.remarks}
    rows = [(name, value) for name, value, _ in (*plain_rows(record, told.sand), *weather_rows(record))]
    return {"rows": rows, "warnings": record.warnings, "remarks": told.remarks}


def _in_words(told: Subject, supply: float) -> dict[str, Any]:
    """Rows of name and value, and what makes them doubtful."""
    table = [("sand supply", f"{supply:.3g} m", ""), *told.table]
    rows = [(name, f"{value} {unit}".rstrip()) for name, value, unit in table]
    return {"rows": rows, "warnings": told.warnings, "remarks": told.all_remarks}


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
