"""The rows of made-up storms, drawn under numbers of their own: storm by storm, row by row."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.streams import Stream
from barchan.wind.clock import DAY
from barchan.wind.gusts import correlated, normal, uniform
from barchan.wind.records import WindRecord

if TYPE_CHECKING:
    from barchan.wind.storms import Storms

HOUR = 3600.0
"""An hour (s)."""

HEIGHT = 10.0
"""Height of the winds (m)."""

START = np.datetime64("2001-01-01T00:00:00")
"""Time of the first row: of no real year."""

WARMEST_HOUR = 14.0
"""Time of day at which the daily wave is warmest (h)."""

TURNING = 3 * HOUR
"""Time (s) after which deviations of the direction are independent of each other."""

_DRAWS = 8
"""Numbers kept for the draws of a storm."""


@dataclass(frozen=True)
class Storm:
    """A storm."""

    start: float
    """Time (s) since the series begins."""
    duration: float
    """How long it lasts (s)."""
    peak: float
    """Mean wind (m/s) at its height."""
    direction: float
    """Where it comes from on the average (degrees)."""
    snowfall: float
    """kg/m²/s while it snows."""
    temperature: float
    """Of its air on the average (°C)."""

    @property
    def end(self) -> float:
        """Time (s) since the series begins."""
        return self.start + self.duration


def storms_of(rules: "Storms", seed: int) -> list[Storm]:
    """The storms that begin in the time of the series, and the one after it."""
    stream = Stream(seed, "storms")
    found: list[Storm] = []
    end = 0.0
    while not found or found[-1].start < rules.days * DAY:
        first = _DRAWS * len(found)
        start = end - rules.quiet_days * DAY * math.log(uniform(stream, first))
        above = rules.peak_scale * (-math.log(uniform(stream, first + 2))) ** (1.0 / rules.peak_shape)
        snow = rules.least_snowfall
        snow += (rules.most_snowfall - rules.least_snowfall) * uniform(stream, first + 4)
        storm = Storm(
            start=start,
            duration=rules.storm_hours * HOUR * math.exp(rules.hours_spread * normal(stream, first + 1)),
            peak=rules.least_peak + above,
            direction=rules.direction + rules.storm_spread * normal(stream, first + 3),
            snowfall=snow / HOUR,
            temperature=rules.temperature + rules.temperature_spread * normal(stream, first + 5),
        )
        found.append(storm)
        end = storm.end
    return found


def storm_record(rules: "Storms", seed: int) -> WindRecord:
    """The storms as rows of equal length, each with its means."""
    storms = storms_of(rules, seed)
    rows = max(round(rules.days * DAY / rules.row_seconds), 2)
    time = np.arange(rows, dtype=np.float64) * rules.row_seconds
    middle = time + rules.row_seconds / 2
    speed = _speed(rules, storms, middle) * _gusts(rules, time, seed)
    turns = rules.spread * correlated(middle / TURNING, Stream(seed, "wind direction"))
    ends = np.array([storm.end for storm in storms])
    direction = np.array([storm.direction for storm in storms])[np.searchsorted(ends, middle)] + turns
    return WindRecord(
        time=time,
        duration=np.full(rows, rules.row_seconds),
        speed=speed,
        direction=np.where(speed == 0.0, 0.0, direction % 360.0),
        start=START,
        source=f"made-up storms, seed {seed}",
        height=HEIGHT,
        temperature=_temperature(rules, storms, middle),
        snowfall=_snowfall(rules, storms, time),
    )


def _speed(rules: "Storms", storms: list[Storm], moments: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean wind (m/s): the quiet one, and in storms a squared sine up to the peak."""
    speed = np.full(len(moments), rules.quiet_speed)
    for storm in storms:
        inside = (moments >= storm.start) & (moments < storm.end)
        rise = np.sin(np.pi * (moments[inside] - storm.start) / storm.duration) ** 2
        speed[inside] += (max(storm.peak, rules.quiet_speed) - rules.quiet_speed) * rise
    return speed


def _gusts(rules: "Storms", time: NDArray[np.float64], seed: int) -> NDArray[np.float64]:
    """The mean factor of gusts in each row."""
    if rules.gusts is None:
        return np.ones(len(time))
    stream = Stream(seed, "gusts")
    return np.array([rules.gusts.factors(t, rules.row_seconds, stream).mean() for t in time.tolist()])


def _snowfall(rules: "Storms", storms: list[Storm], time: NDArray[np.float64]) -> NDArray[np.float64]:
    """Snowfall (kg/m²/s) of each row, whose mass is that of the storms to rounding."""
    fallen = np.zeros(len(time) + 1)
    edges = np.append(time, time[-1] + rules.row_seconds)
    for storm in storms:
        snows = rules.snow_share * storm.duration
        fallen += storm.snowfall * np.clip(edges - storm.start, 0.0, snows)
    return np.diff(fallen) / rules.row_seconds


def _temperature(rules: "Storms", storms: list[Storm], moments: NDArray[np.float64]) -> NDArray[np.float64]:
    """Temperature of the air (°C): straight from the start to the end of each storm and on to the next."""
    times = [time for storm in storms for time in (storm.start, storm.end)]
    values = [v for s in storms for v in (s.temperature + rules.ahead, s.temperature - rules.behind)]
    hours = moments / HOUR
    wave = rules.daily_wave * np.cos(2 * np.pi * (hours - WARMEST_HOUR) / 24.0)
    return np.minimum(np.interp(moments, times, values) + wave, rules.warmest)
