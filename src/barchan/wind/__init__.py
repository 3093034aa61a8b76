"""The forcing: direction and speed of the wind at any moment. It knows nothing of models."""

from typing import Annotated

from pydantic import Field

from barchan.wind.clock import Clock
from barchan.wind.forcing import Forcing
from barchan.wind.interval import StepClock
from barchan.wind.mixed_axes import MixedAxes
from barchan.wind.recorded import Recorded
from barchan.wind.regimes import Regime, Regimes
from barchan.wind.segment import Segment
from barchan.wind.series import SeriesWind
from barchan.wind.steady import Steady
from barchan.wind.storms import Storms
from barchan.wind.weather_course import WeatherCourse

Wind = Annotated[Steady | Regimes | MixedAxes | Recorded | Storms, Field(discriminator="kind")]

__all__ = [
    "Clock",
    "Forcing",
    "MixedAxes",
    "Recorded",
    "Regime",
    "Regimes",
    "Segment",
    "SeriesWind",
    "Steady",
    "StepClock",
    "Storms",
    "WeatherCourse",
    "Wind",
]
