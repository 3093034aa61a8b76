"""Units that suit a value, for people to read: 3.2 mm rather than 0.0032 m."""

import math

from barchan.wind.clock import YEAR

_MINUTE = 60.0

FINE = 0.1
"""Cells (m) narrower than this are those of ripples, wider ones those of dunes; ours."""

LADDERS: dict[str, tuple[tuple[str, float, float], ...]] = {
    "m": (("km", 1e3, 1e4), ("m", 1.0, 0.1), ("cm", 1e-2, 1e-2), ("mm", 1e-3, 1e-3), ("µm", 1e-6, 0.0)),
    "m³": (("m³", 1.0, 0.1), ("cm³", 1e-6, 1e-6), ("mm³", 1e-9, 0.0)),
    "degrees": (("°", 1.0, 0.0),),
    "fraction": (("%", 1e-2, 0.0),),
}
"""For a unit, the units that values are shown in, the largest first: size, and least value shown in each."""

RATES: dict[str, tuple[tuple[str, float], tuple[str, float]]] = {
    "m/step": (("m/step", 1.0), ("mm/step", 1e-3)),
    "m/yr": (("m/yr", 1.0), ("cm/min", 1e-2 * YEAR / _MINUTE)),
    "m²/step": (("m²/step", 1.0), ("cm²/step", 1e-4)),
    "m²/yr": (("m²/yr", 1.0), ("cm²/s", 1e-4 * YEAR)),
}
"""For a unit of migration or flux, the unit and its size over cells of dunes, and over those of ripples.

They do not follow the value, so that runs on lattices of one kind can be compared at a glance.
"""


HOUR = 3600.0

HOURLY = {"m/yr": ("m/h", YEAR / HOUR), "m²/yr": ("m²/h", YEAR / HOUR)}
"""For a unit of migration or flux, the unit of runs of short steps, as those of storms, and its size."""

SHORT = HOUR
"""Duration of a step (s) below which a run is one of hours and not of years; ours."""


def suited(value: float, unit: str, cell_size: float, step_seconds: float | None = None) -> tuple[float, str]:
    """A value in the unit that suits it, and that unit; 0 and NaN keep their own, "-" has none.

    Migration and flux have one unit for all lattices of dunes and one for those of ripples, by the
    ``cell_size`` (m); those of dunes whose steps last ``step_seconds`` below an hour are by the hour.
    """
    if unit in HOURLY and cell_size >= FINE and step_seconds is not None and step_seconds < SHORT:
        name, size = HOURLY[unit]
        return value / size, name
    if unit in RATES:
        name, size = RATES[unit][cell_size < FINE]
        return value / size, name
    ladder = LADDERS.get(unit)
    if ladder is None:
        return value, "" if unit == "-" else unit
    if len(ladder) > 1 and (value == 0.0 or math.isnan(value)):
        return value, unit
    name, size = next(
        (name, size) for name, size, least in ladder if math.isnan(value) or abs(value) >= least
    )
    return value / size, name


def number(value: float) -> str:
    """A value with four digits; a dash where there is none."""
    if math.isnan(value):
        return "–"
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:.0f}"


def spoken(value: float, unit: str, cell_size: float, step_seconds: float | None = None) -> str:
    """A value with the unit that suits it; see ``suited``."""
    shown, name = suited(value, unit, cell_size, step_seconds)
    gap = "" if name in {"", "°", "%"} else " "
    return f"{number(shown)}{gap}{name}"
