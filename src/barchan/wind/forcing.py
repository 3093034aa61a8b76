"""From a wind to what models are told: segments of steps."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Protocol

from barchan.directions import bearing, downwind
from barchan.streams import GOLDEN, MASK
from barchan.wind.influx import Influx
from barchan.wind.interval import Pace, Stretch
from barchan.wind.segment import Segment
from barchan.wind.weather import Weather

_NOWHERE = 1e-9
"""Mean transport below this, over what all winds move, points nowhere."""


class Blows(Protocol):
    """What every kind of wind can tell."""

    def lasts(self, step: int, pace: Pace, /) -> int:
        """For how many steps from ``step`` on the wind stays the same."""
        ...

    def stretches(self, step: int, pace: Pace, /) -> list[Stretch]:
        """The winds of a step, in order."""
        ...


@dataclass(frozen=True)
class Forcing:
    """A wind over a lattice of ``cells`` cells, at the pace of a run."""

    wind: Blows
    pace: Pace
    cells: int
    influx: Influx | None = None
    """What enters across open edges from upwind."""

    def turns(self, step: int, steps: int) -> Iterator[list[Segment]]:
        """What happens in ``steps`` steps from ``step`` on, in order.

        Each list is one or more whole steps of a single segment, or the segments of one step.
        """
        for start, alike, stretches in self.spells(step, steps):
            if len(stretches) > 1:
                for now in range(start, start + alike):
                    yield self._step(now, stretches)
                continue
            for first, count, polls in self._runs(start, alike, stretches[0]):
                yield [self._segment(first, stretches[0], 0, polls, count)]

    def spells(self, step: int, steps: int) -> Iterator[tuple[int, int, list[Stretch]]]:
        """Steps in a row with the same winds: the first, how many, and the winds of each."""
        end = step + steps
        while step < end:
            alike = min(self.wind.lasts(step, self.pace), end - step)
            yield step, alike, self.wind.stretches(step, self.pace)
            step += alike

    def _runs(self, step: int, steps: int, stretch: Stretch) -> Iterator[tuple[int, int, int]]:
        """Steps in a row with equally many polls: the first, how many, and their polls."""
        wanted = stretch.share * stretch.strength * self.cells
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

    def _step(self, step: int, stretches: list[Stretch]) -> list[Segment]:
        """The segments of one step; their polls are whole, and right in their sums."""
        found = []
        total, before = _dither(step), 0
        for number, stretch in enumerate(stretches, start=1):
            total += stretch.share * stretch.strength * self.cells
            after = math.floor(total + 1e-9)
            ends = number == len(stretches)
            found.append(self._segment(step, stretch, before, after - before, 1, ends))
            before = after
        return found

    def _segment(
        self, step: int, stretch: Stretch, first: int, polls: int, steps: int, ends: bool = True
    ) -> Segment:
        seconds = self.pace.step_seconds
        return Segment(
            step,
            steps,
            first,
            polls,
            stretch.direction,
            stretch.hop_length,
            stretch.speed,
            stretch.share,
            seconds,
            ends,
            self.influx,
            stretch.weather,
        )

    def wind_of(self, step: int) -> Segment:
        """The winds of a step as one: where their mean transport comes from, their mean hop and speed.

        Deviations by chance from a wind's direction are left out.
        """
        stretches = self.wind.stretches(step, replace(self.pace, deviates=False))
        works = [s.share * s.strength * (1.0 if s.hop_length is None else s.hop_length) for s in stretches]
        x, y = (
            math.fsum(work * downwind(s.direction)[axis] for work, s in zip(works, stretches, strict=True))
            for axis in (0, 1)
        )
        total = math.fsum(works)
        strongest = stretches[max(range(len(works)), key=works.__getitem__)]
        drifts = math.hypot(x, y) > _NOWHERE * total
        only = len(stretches) == 1
        direction = strongest.direction if only or not drifts else bearing(x, y)
        return Segment(
            step,
            1,
            0,
            self.cells,
            direction,
            _mean([(s.share, s.hop_length) for s in stretches]),
            _mean([(s.share, s.speed) for s in stretches]),
            1.0,
            self.pace.step_seconds,
            weather=strongest.weather if only else _mean_weather(stretches),
        )


def _mean(values: list[tuple[float, float | None]]) -> float | None:
    """The mean of weighted values, where all are known."""
    if any(value is None for _, value in values):
        return None
    return math.fsum(share * value for share, value in values if value is not None)


def _mean_weather(stretches: list[Stretch]) -> Weather:
    """Mean air temperature and snowfall over a step, where all its winds state them."""
    return Weather(
        _mean([(s.share, s.weather.temperature) for s in stretches]),
        _mean([(s.share, s.weather.snowfall) for s in stretches]),
    )


def _dither(step: int) -> float:
    """A number in [0, 1), spread evenly over any steps in a row: multiples of the golden ratio."""
    return ((step * GOLDEN) & MASK) / 2.0**64
