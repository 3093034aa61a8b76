"""The roses of a recorded wind, as the wind panel draws them."""

import math
from typing import Any

from barchan.aeolian.saltation import Saltation
from barchan.simulation import Simulation
from barchan.theory.assessment import assess_record
from barchan.theory.roses import sand_rose, speed_limits, wind_rose
from barchan.wind import Recorded


def rose_of(simulation: Simulation) -> dict[str, Any] | None:
    """How often the wind blows from each side and how much sand it moves; None unless it is a record."""
    if not isinstance(simulation.wind, Recorded):
        return None
    record = simulation.wind.record
    sand = simulation.scenario.clock or Saltation()
    limits = speed_limits(record, sand.threshold_speed())
    shares, calms = wind_rose(record, limits)
    found = assess_record(record, sand)
    return {
        "source": record.source,
        "days": record.seconds / 86_400.0,
        "threshold": sand.threshold_speed(),
        "limits": limits,
        "shares": shares.tolist(),
        "calms": calms,
        "sand": sand_rose(found.drift).tolist(),
        "unit": found.drift.unit,
        "toward": _known(found.drift.toward),
        "steadiness": _known(found.drift.steadiness),
        "crest": _known(found.gross_transport.azimuth),
    }


def _known(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
