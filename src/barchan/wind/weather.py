"""The weather that comes with a wind, for models of snow that falls, hardens and packs."""

from dataclasses import dataclass

from barchan.parameters import Parameters, parameter

COLDEST, WARMEST = -90.0, 60.0
"""Air temperatures (°C) beyond all that were measured near the ground."""


@dataclass(frozen=True)
class Weather:
    """Air temperature and snowfall during a part of the forcing; None: not stated."""

    temperature: float | None = None
    """Of the air near the ground (°C)."""
    snowfall: float | None = None
    """Mass of snow that falls on the ground per time (kg/m²/s)."""


UNKNOWN = Weather()
"""The weather where nothing is stated of it."""


class WithWeather(Parameters):
    """What a wind may state of the weather that comes with it."""

    temperature: float | None = parameter(
        None,
        unit="°C",
        ge=COLDEST,
        le=WARMEST,
        live=True,
        meaning="Temperature of the air while this wind blows; unknown where not given.",
    )
    snowfall: float | None = parameter(
        None,
        unit="kg/m²/s",
        ge=0,
        le=0.1,
        live=True,
        meaning="Snow that falls on the ground while this wind blows: mass per area and time, 1 kg/m² being "
        "1 mm of water; unknown where not given.",
    )

    @property
    def weather(self) -> Weather:
        """The weather stated here."""
        if self.temperature is None and self.snowfall is None:
            return UNKNOWN
        return Weather(self.temperature, self.snowfall)
