"""Units of length that elevation models state."""

from barchan.ground.raster import UnreadableError

METRES = {
    "m": 1.0,
    "metre": 1.0,
    "metres": 1.0,
    "meter": 1.0,
    "meters": 1.0,
    "km": 1000.0,
    "kilometre": 1000.0,
    "dm": 0.1,
    "cm": 0.01,
    "mm": 0.001,
    "ft": 0.3048,
    "foot": 0.3048,
    "feet": 0.3048,
    "us-ft": 1200.0 / 3937.0,
    "ftus": 1200.0 / 3937.0,
    "us survey foot": 1200.0 / 3937.0,
    "us survey feet": 1200.0 / 3937.0,
}
"""Metres in a unit, by its names in lower case."""


def metres_in(unit: str) -> float:
    """Metres in a unit; raises UnreadableError for one that is no known length."""
    known = METRES.get(unit.strip().lower())
    if known is None:
        names = "m, km, dm, cm, mm, ft, US survey foot"
        raise UnreadableError(f"states its heights in '{unit}'; allowed: {names}")
    return known
