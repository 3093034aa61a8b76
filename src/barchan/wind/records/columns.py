"""Which column is which, by its name, and the unit that its heading states."""

import re
from collections.abc import Iterable

from barchan.wind.records.format import UNITS

NAMES: dict[str, tuple[str, ...]] = {
    "time": (
        "time",
        "datetime",
        "date_time",
        "timestamp",
        "valid_time",
        "valid",
        "mess_datum",
        "utc",
        "date",
    ),
    "speed": ("speed", "wind_speed", "windspeed", "wind_spd", "ws", "wspd", "sknt", "ff", "f"),
    "direction": (
        "direction",
        "wind_direction",
        "winddirection",
        "wind_dir",
        "winddir",
        "wd",
        "wdir",
        "drct",
        "dir",
        "dd",
        "d",
    ),
    "u": ("u10", "u", "u_component_of_wind", "eastward_wind", "10u"),
    "v": ("v10", "v", "v_component_of_wind", "northward_wind", "10v"),
}
"""Names that each quantity goes by, the likeliest first, in lower case without units and heights."""

_SPELLINGS = {
    "m/s": ("m/s", "m s-1", "ms-1", "m s**-1", "m s^-1", "meter/second", "metre/second", "mps"),
    "kn": ("kn", "kt", "kts", "knot", "knots"),
    "km/h": ("km/h", "kmh", "kph", "km h-1", "km/hr"),
    "mph": ("mph", "mi/h", "mp/h", "miles/hour"),
}

UNIT_OF_NAME = {"sknt": "kn"}
"""Names that contain the unit."""


def split(heading: str) -> tuple[str, str]:
    """A heading as name and unit: ``Wind speed (kn)`` is ``wind_speed`` in ``kn``."""
    found = re.fullmatch(r"\s*(.*?)\s*(?:[(\[]\s*(.*?)\s*[)\]])?\s*", heading)
    name, unit = (found[1], found[2] or "") if found else (heading, "")
    return re.sub(r"[\s\-]+", "_", name.strip().lower()), unit


def guess(headings: Iterable[str], quantity: str) -> str | None:
    """The heading that most likely names a quantity; a height, as in ``wind_speed_10m``, may follow."""
    plain = {re.sub(r"_?(\d+_?m)$", "", split(heading)[0]): heading for heading in reversed([*headings])}
    return next((plain[name] for name in NAMES[quantity] if name in plain), None)


def speed_unit(spelling: str) -> str | None:
    """The unit of speed that a spelling stands for; nothing if it is none that is known."""
    plain = " ".join(spelling.lower().replace("⁻¹", "-1").replace("−", "-").split())
    return next((unit for unit, known in _SPELLINGS.items() if plain in known), None)


def allowed_units() -> str:
    """The units that are known, in words."""
    return ", ".join(UNITS)
