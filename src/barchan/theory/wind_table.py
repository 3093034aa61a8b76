"""Rows of a table of a wind: the record, its drift potential, the drift and what it shapes."""

import math

import numpy as np

from barchan.aeolian.saltation import Saltation
from barchan.theory.assessment import Assessment
from barchan.theory.crests import Crest
from barchan.theory.drift import Drift, energy, in_metres
from barchan.wind.records import WindRecord
from barchan.wind.records.summary import record_facts, weather_facts

Rows = list[tuple[str, str, str]]
"""Name, value, unit."""


def plain_rows(record: WindRecord, sand: Saltation) -> Rows:
    """Facts of a record and its speeds, whatever they blow over."""
    mean = float(np.average(record.speed, weights=record.duration))
    return [
        *((name, text, "") for name, text in record_facts(record, sand.height).items()),
        ("wind speed", f"mean {mean:.2f} m/s, highest {record.speed.max():.1f} m/s", ""),
    ]


def record_rows(record: WindRecord, sand: Saltation) -> Rows:
    """Facts of a record, and how often its winds move sand."""
    threshold, friction = sand.threshold_speed(), sand.threshold_friction_velocity()
    exceeds = sand.at_own_height(record.speed, record.height) > threshold
    blowing = float(record.duration[exceeds].sum()) / record.seconds
    return [
        *plain_rows(record, sand),
        ("flux law", f"{sand.law}, grains of {1e3 * sand.grain_diameter:g} mm", ""),
        ("threshold", f"{threshold:.2f} m/s at {sand.height:g} m, u* {friction:.3f} m/s", ""),
        ("exceeded", f"{100 * blowing:.1f} % of the time", ""),
    ]


def weather_rows(record: WindRecord) -> Rows:
    """The weather that comes with a record, where it has any."""
    return [(name, text, "") for name, text in weather_facts(record).items()]


def potential_rows(potential: Drift | None, threshold: float, annual: bool) -> Rows:
    """Drift potential (VU) above a threshold (knots), by its energy where it is that of a year."""
    if potential is None:
        return []
    total = potential.total
    kind = f"energy {energy(total)}" if annual else "not annual"
    told = f"DP {total:.0f} VU above {threshold:.3g} kn ({in_metres(total):.1f} by m/s), {kind}"
    return [
        ("drift potential", told, ""),
        ("resultant", f"RDP {potential.resultant:.0f} VU, RDP/DP {_number(potential.steadiness)}", ""),
        ("", f"RDD {toward(potential.toward)}", ""),
    ]


def drift_rows(found: Assessment) -> Rows:
    """The drift, its directions, and the crests and dunes to expect; nothing where no sand moves."""
    drift = found.drift
    if not found.moves:
        return []
    rows = [] if drift.unit == "-" else [("sand flux", f"{drift.total:.1f} {drift.unit} to all sides", "")]
    share = "" if drift.unit == "-" else f"{drift.resultant:.1f} {drift.unit}, "
    modes = ", ".join(f"{mode:.0f}°" for mode in found.variability.modes)
    return [
        *rows,
        ("resultant flux", f"{share}{drift.steadiness:.2f} of all, {toward(drift.toward)}", ""),
        ("directions", found.variability.name + (f", from {modes}" if modes else ""), ""),
        ("crests, gross transport", _crest(found.gross_transport), ""),
        ("crests, bed instability", _crest(found.bed_instability), ""),
        ("fingers of scarce sand", f"grow {toward(found.elongation)}", ""),
        ("dunes to expect", found.dunes, ""),
    ]


def _crest(crest: Crest) -> str:
    if math.isnan(crest.azimuth):
        return "none, no direction stands out"
    rivals = ", ".join(f"{rival:.0f}°" for rival in crest.rivals)
    return f"azimuth {crest.azimuth:.0f}°" + (f", ambiguous: as good are {rivals}" if rivals else "")


def toward(angle: float) -> str:
    """A direction in which sand goes (degrees), in words."""
    return "nowhere" if math.isnan(angle) else f"toward {angle:.0f}°"


def _number(value: float) -> str:
    return "–" if math.isnan(value) else f"{value:.2f}"
