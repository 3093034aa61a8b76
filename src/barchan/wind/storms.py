"""Made-up weather of a winter: storms with snow, and quiet days between them."""

from functools import lru_cache
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from barchan.parameters import parameter
from barchan.wind.gusts import Gusts
from barchan.wind.records import WindRecord
from barchan.wind.series import Series, SeriesWind
from barchan.wind.storm_series import storm_record

OURS = "ours: made up"
OPEN_GROUND = "ours: a winter over open ground, made up"


class Storms(SeriesWind):
    """Storms that the run's seed makes up: wind, temperature and snowfall at 10 m, in rows of equal length.

    After a quiet time, exponential with the mean ``quiet_days``, a storm lasts for a lognormal time. Its wind
    rises from the quiet wind to a peak and falls again as a squared sine; the peak is a Weibull number
    above ``least_peak``. It comes from its own side of ``direction`` and turns about it. Snow falls in its
    first part at a constant rate. Each storm brings air of its own temperature; ahead of its front the air is
    warmer, behind it colder, and changes evenly from storm to storm. A daily wave comes on top.
    """

    kind_key: ClassVar[str] = "kind"

    kind: Literal["storms"] = parameter(
        "storms", unit="-", meaning="Made-up storms with snow, different for each seed."
    )
    days: float = parameter(
        60.0, unit="days", ge=1, le=3660, meaning="Length of the series.", source=OURS, scale="log"
    )
    row_seconds: float = parameter(
        600.0, unit="s", ge=60, le=21_600, meaning="Length of a row.", source=OURS, scale="log"
    )
    direction: float = parameter(
        270.0,
        unit="degrees",
        ge=0,
        lt=360,
        meaning="Where storms come from on the average, clockwise from north.",
        source=OURS,
    )
    storm_spread: float = parameter(
        60.0,
        unit="degrees",
        ge=0,
        le=180,
        meaning="Standard deviation of the mean directions of storms.",
        source=OPEN_GROUND,
    )
    spread: float = parameter(
        15.0,
        unit="degrees",
        ge=0,
        le=180,
        meaning="Standard deviation of the direction within a storm, where it changes within hours.",
        source=OPEN_GROUND,
    )
    quiet_days: float = parameter(
        4.0, unit="days", gt=0, le=365, meaning="Mean time from a storm to the next.", source=OPEN_GROUND
    )
    quiet_speed: float = parameter(
        3.0, unit="m/s", ge=0, le=50, meaning="Wind between storms, at 10 m.", source=OPEN_GROUND
    )
    storm_hours: float = parameter(
        18.0, unit="h", gt=0, le=240, meaning="Median duration of a storm.", source=OPEN_GROUND
    )
    hours_spread: float = parameter(
        0.5,
        unit="-",
        ge=0,
        le=2,
        meaning="Standard deviation of the logarithm of the duration of storms.",
        source=OPEN_GROUND,
    )
    least_peak: float = parameter(
        4.0, unit="m/s", ge=0, le=50, meaning="Peak of the weakest storm, at 10 m.", source=OPEN_GROUND
    )
    peak_scale: float = parameter(
        11.0,
        unit="m/s",
        ge=0,
        le=50,
        meaning="Weibull scale of the peaks of storms above that of the weakest.",
        source=OPEN_GROUND,
    )
    peak_shape: float = parameter(
        2.0, unit="-", ge=0.5, le=10, meaning="Weibull shape of the peaks of storms.", source=OPEN_GROUND
    )
    gusts: Gusts | None = Field(
        default_factory=lambda: Gusts(intensity=0.15, correlation_time=600.0),
        description="Gusts of the wind; each row has their mean over its length.",
    )
    least_snowfall: float = parameter(
        0.5, unit="kg/m²/h", ge=0, le=30, meaning="Snowfall of the driest storm.", source=OPEN_GROUND
    )
    most_snowfall: float = parameter(
        2.0,
        unit="kg/m²/h",
        ge=0,
        le=30,
        meaning="Snowfall of the wettest storm; all between are as likely.",
        source=OPEN_GROUND,
    )
    snow_share: float = parameter(
        0.6,
        unit="-",
        ge=0,
        le=1,
        meaning="Part of a storm, from its start, in which it snows.",
        source=OPEN_GROUND,
    )
    temperature: float = parameter(
        -8.0, unit="°C", ge=-60, le=0, meaning="Mean temperature of storms.", source=OPEN_GROUND
    )
    temperature_spread: float = parameter(
        5.0,
        unit="K",
        ge=0,
        le=20,
        meaning="Standard deviation of the temperature from storm to storm.",
        source=OPEN_GROUND,
    )
    ahead: float = parameter(
        4.0, unit="K", ge=0, le=20, meaning="How much warmer a storm begins.", source=OPEN_GROUND
    )
    behind: float = parameter(
        6.0, unit="K", ge=0, le=20, meaning="How much colder a storm ends.", source=OPEN_GROUND
    )
    daily_wave: float = parameter(
        3.0,
        unit="K",
        ge=0,
        le=20,
        meaning="Amplitude of the daily wave of temperature, warmest at 14 h.",
        source=OPEN_GROUND,
    )
    warmest: float = parameter(
        0.0,
        unit="°C",
        ge=-60,
        le=5,
        meaning="Temperature that the air does not exceed, for what falls is snow.",
        source=OURS,
    )

    def record(self, seed: int) -> WindRecord:
        """The storms of a seed, as a record."""
        return self.series(seed).record

    def series(self, seed: int) -> Series:
        """The storms of a seed, and when their rows end."""
        return _made_up(self, seed)

    def summary(self) -> str:
        """The wind in a few words."""
        return f"made-up storms in {self.days:g} days, from {self.direction:g}° on the average"


@lru_cache(maxsize=4)
def _made_up(rules: Storms, seed: int) -> Series:
    record = storm_record(rules, seed)
    return Series(record, np.cumsum(record.duration))
