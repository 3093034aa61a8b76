"""From a wind to the segments that models work on."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Protocol

from barchan.directions import bearing, downwind
from barchan.streams import GOLDEN, MASK
from barchan.wind.influx import Influx
from barchan.wind.interval import StepClock, WindInterval
from barchan.wind.segment import Segment
from barchan.wind.weather import Weather
from barchan.wind.weather_course import WeatherCourse

_NOWHERE = 1e-9
"""Fraction of the total transport below which the mean transport has no direction."""


class Blows(Protocol):
    """A wind of any kind."""

    def lasts(self, step: int, clock: StepClock, /) -> int:
        """Number of steps from ``step`` on in which the wind stays the same."""
        ...

    def intervals(self, step: int, clock: StepClock, /) -> list[WindInterval]:
        """Intervals of a step, in order."""
        ...

    def period(self, step: int, clock: StepClock, /) -> float:
        """Steps after which the wind of ``step`` comes again: 0 if it stays the same, infinite if never."""
        ...


@dataclass(frozen=True)
class Forcing:
    """A wind over a lattice of ``cells`` cells, with the clock of a run."""

    wind: Blows
    clock: StepClock
    cells: int
    influx: Influx | None = None
    """What enters across open edges from upwind."""
    weather: WeatherCourse | None = None
    """The weather where the wind states none."""

    def segments(self, step: int, steps: int) -> Iterator[list[Segment]]:
        """Segments of ``steps`` steps from ``step`` on, in order.

        Each list is one or more whole steps of a single segment, or the segments of one step.
        """
        for start, count, intervals in self.constant_intervals(step, steps):
            if len(intervals) > 1:
                for now in range(start, start + count):
                    yield self._step(now, intervals)
                continue
            for first, steps_of, polls in self._runs(start, count, intervals[0]):
                yield [self._segment(first, intervals[0], 0, polls, steps_of)]

    def constant_intervals(self, step: int, steps: int) -> Iterator[tuple[int, int, list[WindInterval]]]:
        """Runs of steps with the same intervals: first step, number of steps, intervals of each step."""
        end = step + steps
        while step < end:
            count = min(self.wind.lasts(step, self.clock), end - step)
            if self.weather is not None:
                count = min(self.weather.lasts(step, self.clock), count)
            yield step, count, self._intervals(step, self.clock)
            step += count

    def _intervals(self, step: int, clock: StepClock) -> list[WindInterval]:
        """The wind's intervals of a step, with the weather."""
        found = self.wind.intervals(step, clock)
        if self.weather is None:
            return found
        weather = self.weather.at(step, clock)
        return [replace(interval, weather=interval.weather.completed_by(weather)) for interval in found]

    def _runs(self, step: int, steps: int, interval: WindInterval) -> Iterator[tuple[int, int, int]]:
        """Runs of steps with the same number of polls: first step, number of steps, polls of each step."""
        wanted = interval.share * interval.strength * self.cells
        if wanted == math.floor(wanted):
            yield step, steps, int(wanted)
            return
        first, polls = step, math.floor(wanted + _dither(step))
        for now in range(step + 1, step + steps):
            here = math.floor(wanted + _dither(now))
            if here != polls:
                yield first, now - first, polls
                first, polls = now, here
        yield first, step + steps - first, polls

    def _step(self, step: int, intervals: list[WindInterval]) -> list[Segment]:
        """Segments of one step; polls are whole numbers whose sums are exact on average."""
        found = []
        total, before = _dither(step), 0
        for number, interval in enumerate(intervals, start=1):
            total += interval.share * interval.strength * self.cells
            after = math.floor(total + 1e-9)
            ends = number == len(intervals)
            found.append(self._segment(step, interval, before, after - before, 1, ends))
            before = after
        return found

    def _segment(
        self, step: int, interval: WindInterval, first: int, polls: int, steps: int, ends: bool = True
    ) -> Segment:
        seconds = self.clock.step_seconds
        return Segment(
            step,
            steps,
            first,
            polls,
            interval.direction,
            interval.hop_length,
            interval.speed,
            interval.share,
            seconds,
            ends,
            self.influx,
            interval.driving_speed,
            interval.weather,
        )

    def wind_of(self, step: int) -> Segment:
        """The step's intervals as one segment: direction of the mean transport, mean hop length, mean speed.

        Random deviations from a wind's direction are left out.
        """
        intervals = self._intervals(step, replace(self.clock, deviates=False))
        works = [s.share * s.strength * (1.0 if s.hop_length is None else s.hop_length) for s in intervals]
        x, y = (
            math.fsum(work * downwind(s.direction)[axis] for work, s in zip(works, intervals, strict=True))
            for axis in (0, 1)
        )
        total = math.fsum(works)
        strongest = intervals[max(range(len(works)), key=works.__getitem__)]
        drifts = math.hypot(x, y) > _NOWHERE * total
        only = len(intervals) == 1
        direction = strongest.direction if only or not drifts else bearing(x, y)
        return Segment(
            step,
            1,
            0,
            self.cells,
            direction,
            _mean([(s.share, s.hop_length) for s in intervals]),
            _mean([(s.share, s.speed) for s in intervals]),
            1.0,
            self.clock.step_seconds,
            weather=strongest.weather if only else _mean_weather(intervals),
        )


def _mean(values: list[tuple[float, float | None]]) -> float | None:
    """Mean of weighted values, or None if one is unknown."""
    if any(value is None for _, value in values):
        return None
    return math.fsum(share * value for share, value in values if value is not None)


def _mean_weather(intervals: list[WindInterval]) -> Weather:
    """Mean air temperature and snowfall over a step, where all its winds state them."""
    return Weather(
        _mean([(s.share, s.weather.temperature) for s in intervals]),
        _mean([(s.share, s.weather.snowfall) for s in intervals]),
    )


def _dither(step: int) -> float:
    """A number in [0, 1), uniform over successive steps: multiples of the golden ratio."""
    return ((step * GOLDEN) & MASK) / 2.0**64
