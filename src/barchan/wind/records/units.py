"""Units of what a record holds: how they are spelled, how large they are, which of them are of no use."""

import re
from dataclasses import dataclass
from typing import Literal

import numpy as np

from barchan.errors import Problem, RecordError

SpeedUnit = Literal["m/s", "0.1 m/s", "cm/s", "kn", "km/h", "mph", "ft/s"]
AngleUnit = Literal["deg", "10 deg", "rad", "gon"]

UNITS: dict[str, float] = {
    "m/s": 1.0,
    "0.1 m/s": 0.1,
    "cm/s": 0.01,
    "kn": 1852 / 3600,
    "km/h": 1 / 3.6,
    "mph": 0.44704,
    "ft/s": 0.3048,
}
"""Metres a second in one unit of speed."""

ANGLES: dict[str, float] = {"deg": 1.0, "10 deg": 10.0, "rad": 180.0 / np.pi, "gon": 0.9}
"""Degrees in one unit of angle."""

SECONDS: dict[str, float] = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}
"""Seconds in one unit of time."""

_SPEED_WORDS = {
    "m/s": "m/s ms ms-1 m/sec meter/second metre/second meters/second metres/second meter/sec mps",
    "0.1 m/s": "0.1m/s 0.1ms-1 1/10m/s m/s*10 10*m/s 10m/s dm/s tenthsm/s tenthsofm/s",
    "cm/s": "cm/s cms-1",
    "kn": "kn kt kts knot knots",
    "km/h": "km/h kmh kph kmh-1 km/hr km/hour kilometers/hour kilometres/hour",
    "mph": "mph mi/h mi/hr mp/h miles/hour mile/hour",
    "ft/s": "ft/s fts-1 fps feet/second",
}
_ANGLE_WORDS = {
    "deg": "deg degree degrees ° º ø degt degtrue degreetrue degreestrue °true °t degn degreesnorth "
    "degreenorth °n "
    "degreesclockwisefromnorth degreeclockwisefromnorth degfromnorth degreesfromnorth arcdeg arcdegree "
    "azimuthdegrees degaz",
    "10 deg": "10deg 10sdeg 10degrees 10°s 10° tensofdegrees tensdeg tensofdeg dadeg decadegrees",
    "rad": "rad rads radian radians",
    "gon": "gon gons gradian gradians grads",
}
_TIME_WORDS = {
    "s": "s sec secs second seconds",
    "min": "min mins minute minutes",
    "h": "h hr hrs hour hours",
    "d": "d day days",
}


@dataclass(frozen=True)
class Dimension:
    """A kind of quantity: its units, and those that are known but of no use for it."""

    name: str
    sizes: dict[str, float]
    """Size of each unit in the unit that Barchan counts in."""
    words: dict[str, frozenset[str]]
    """Spellings of each unit, lower case and without blanks."""
    useless: dict[str, str]
    """Patterns of spellings that are known and cannot be used, and why."""

    def unit_of(self, spelling: str) -> str | None:
        """The unit that a spelling stands for; None if it is none that is known."""
        plain = _plain(spelling)
        return next((unit for unit, known in self.words.items() if plain in known), None)

    def why_useless(self, spelling: str) -> str | None:
        """Why a unit that is known cannot be used; None where it can, or is not known."""
        words = spelling.lower()
        return next((why for pattern, why in self.useless.items() if re.search(pattern, words)), None)

    def required(self, spelling: str, column: str, source: str) -> str:
        """The unit that a spelling stands for; raises RecordError where it cannot be used."""
        why = self.why_useless(spelling)
        found = None if why else self.unit_of(spelling)
        if found is None:
            said = why or f"allowed: {', '.join(self.sizes)}"
            raise RecordError([Problem(f"column '{column}'", f"is in '{spelling}'; {said}")], source)
        return found


def _plain(spelling: str) -> str:
    text = spelling.lower().replace("⁻¹", "-1").replace("−", "-").replace("·", "")
    return re.sub(r"\s*per\s*", "/", re.sub(r"\*\*|\^|[_ \t]|(?<=[a-z])\.(?=[a-z])", "", text))


def _dimension(
    name: str, sizes: dict[str, float], words: dict[str, str], useless: dict[str, str]
) -> Dimension:
    return Dimension(name, sizes, {unit: frozenset(text.split()) for unit, text in words.items()}, useless)


SPEED = _dimension(
    "speed",
    UNITS,
    _SPEED_WORDS,
    {r"beaufort|\bbft\b": "a class of the Beaufort scale is no speed; state speeds"},
)
ANGLE = _dimension(
    "direction",
    ANGLES,
    _ANGLE_WORDS,
    {
        r"magnetic|degm\b|°\s*m\b": "directions from magnetic north; allowed: from true north (state "
        "direction_unit to take them as they are)",
        r"counter|anti-?clockwise|from east|cartesian|math": "angles counted from east; allowed: clockwise "
        "from north",
    },
)
TIME = _dimension("time", SECONDS, _TIME_WORDS, {})
TEMPERATURE = _dimension(
    "temperature",
    {"°C": 1.0, "K": 1.0, "°F": 5 / 9},
    {
        "°C": "°c c degc deg_c celsius degcelsius degreecelsius degreescelsius ℃",
        "K": "k kelvin degk kelvins",
        "°F": "°f f degf fahrenheit degreesfahrenheit",
    },
    {},
)
ZEROS = {"K": -273.15, "°F": -160 / 9}
"""The zero of a unit of temperature, in °C."""

FALL = _dimension(
    "snowfall",
    {
        "kg/m²/s": 1.0, "mm/s": 1.0, "kg/m²/h": 1 / 3600, "mm/h": 1 / 3600, "mm/d": 1 / 86400,
        "m/s": 1000.0, "mm": 1.0, "kg/m²": 1.0, "cm": 10.0, "m": 1000.0,
    },
    {
        "kg/m²/s": "kg/m²/s kg/m2/s kgm-2s-1 kgm²s-1 kg/(m2s) kg/m2s kgm-2/s",
        "mm/s": "mm/s mms-1",
        "kg/m²/h": "kg/m²/h kg/m2/h kgm-2h-1",
        "mm/h": "mm/h mmh-1 mm/hr mm/hour mmwe/h mmw.e./h",
        "mm/d": "mm/d mm/day mmd-1 mmday-1",
        "m/s": "mofwaterequivalent/s",
        "mm": "mm mmwe mmw.e. mmh2o mmofwaterequivalent",
        "kg/m²": "kg/m² kg/m2 kgm-2",
        "cm": "cmwe cmofwaterequivalent",
        "m": "m mofwaterequivalent mw.e. mwe",
    },
    {
        r"^in$|inch": "inches of water; allowed: mm",
        r"^cm$": "centimetres may be of snow or of water; allowed: mm of water",
    },
)  # fmt: skip
"""Snow or water that falls, as a mass per time, or as an amount since the row before."""

LENGTH = _dimension(
    "length",
    {"m": 1.0, "cm": 0.01, "mm": 0.001},
    {
        "m": "m metre metres meter meters",
        "cm": "cm centimetre centimetres centimeter centimeters",
        "mm": "mm millimetre millimetres millimeter millimeters",
    },
    {r"water equivalent|w\.?e\.?\b": "a depth of water; allowed: the depth of snow, in m, cm or mm"},
)
KIND = _dimension("kind", {"1": 1.0}, {"1": "1 - ~ code numeric codetable(4.201)"}, {})
"""Numbers that stand for a kind or a share."""

AMOUNTS = frozenset(["mm", "kg/m²", "cm", "m"])
"""Units of amounts since the row before."""
