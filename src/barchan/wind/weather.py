"""The weather that comes with a wind, for models of snow that falls, hardens and packs."""

from dataclasses import dataclass
from typing import Any

from barchan.parameters import Parameters, parameter

COLDEST, WARMEST = -90.0, 60.0
"""Air temperatures (°C) beyond all that were measured near the ground."""

TEMPERATURE: dict[str, Any] = {"unit": "°C", "ge": COLDEST, "le": WARMEST}
"""Declaration shared by all temperatures of the air."""

SNOWFALL: dict[str, Any] = {"unit": "kg/m²/s", "ge": 0, "le": 0.1}
"""Declaration shared by all rates of snowfall."""


@dataclass(frozen=True)
class Weather:
    """Air temperature and snowfall during a part of the forcing; None: not stated."""

    temperature: float | None = None
    """Of the air near the ground (°C)."""
    snowfall: float | None = None
    """Mass of snow that falls on the ground per time (kg/m²/s)."""

    def completed_by(self, other: "Weather") -> "Weather":
        """The same weather, with what it does not state taken from another one."""
        if self == UNKNOWN:
            return other
        return Weather(
            other.temperature if self.temperature is None else self.temperature,
            other.snowfall if self.snowfall is None else self.snowfall,
        )


UNKNOWN = Weather()
"""The weather where nothing is stated of it."""


class WithWeather(Parameters):
    """What a wind may state of the weather that comes with it."""

    temperature: float | None = parameter(
        None,
        live=True,
        meaning="Temperature of the air while this wind blows; unknown where not given.",
        **TEMPERATURE,
    )
    snowfall: float | None = parameter(
        None,
        live=True,
        meaning="Snow that falls on the ground while this wind blows: mass per area and time, 1 kg/m² being "
        "1 mm of water; unknown where not given.",
        **SNOWFALL,
    )

    @property
    def weather(self) -> Weather:
        """The weather stated here."""
        if self.temperature is None and self.snowfall is None:
            return UNKNOWN
        return Weather(self.temperature, self.snowfall)

    @property
    def temperatures(self) -> tuple[float, ...]:
        """The least and the greatest temperature (°C) stated here, or none."""
        return () if self.temperature is None else (self.temperature,)
