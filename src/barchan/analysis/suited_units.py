"""Units that suit a value, for people to read: 3.2 mm rather than 0.0032 m."""

import math

from barchan.wind.clock import YEAR

_MINUTE = 60.0

LADDERS: dict[str, tuple[tuple[str, float, float], ...]] = {
    "m": (("km", 1e3, 1e4), ("m", 1.0, 0.1), ("cm", 1e-2, 1e-2), ("mm", 1e-3, 1e-3), ("µm", 1e-6, 0.0)),
    "m/step": (
        ("m/step", 1.0, 0.1),
        ("cm/step", 1e-2, 1e-2),
        ("mm/step", 1e-3, 1e-3),
        ("µm/step", 1e-6, 0.0),
    ),
    "m/yr": (
        ("m/s", YEAR, YEAR),
        ("cm/min", 1e-2 * YEAR / _MINUTE, 1e-3 * YEAR / _MINUTE),
        ("m/yr", 1.0, 0.1),
        ("cm/yr", 1e-2, 1e-2),
        ("mm/yr", 1e-3, 0.0),
    ),
    "m²/step": (("m²/step", 1.0, 0.1), ("cm²/step", 1e-4, 1e-4), ("mm²/step", 1e-6, 0.0)),
    "m²/yr": (("cm²/s", 1e-4 * YEAR, 1e-5 * YEAR), ("m²/yr", 1.0, 0.1), ("cm²/yr", 1e-4, 0.0)),
    "m³": (("m³", 1.0, 0.1), ("cm³", 1e-6, 1e-6), ("mm³", 1e-9, 0.0)),
    "degrees": (("°", 1.0, 0.0),),
    "fraction": (("%", 1e-2, 0.0),),
}
"""For a unit, the units that values are shown in, the largest first: size, and least value shown in each."""


def suited(value: float, unit: str) -> tuple[float, str]:
    """A value in the unit that suits it, and that unit; 0 and NaN keep their own, "-" has none."""
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


def spoken(value: float, unit: str) -> str:
    """A value with the unit that suits it."""
    shown, name = suited(value, unit)
    gap = "" if name in {"", "°", "%"} else " "
    return f"{number(shown)}{gap}{name}"
