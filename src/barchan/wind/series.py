"""Winds of a series of rows, recorded or made up, one after the other at the speed of the run's clock."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.wall import REFERENCE_HEIGHT
from barchan.errors import Problem, ScenarioError
from barchan.parameters import Parameters, parameter
from barchan.wind.blowing import Blowing
from barchan.wind.interval import FOR_EVER, StepClock, WindInterval
from barchan.wind.records import WindRecord
from barchan.wind.weather import UNKNOWN, Weather

_ROUNDING = 1e-9
"""Slack, in steps, for times that are those of a row's end but for rounding."""


class Rows(NamedTuple):
    """The winds that blow within a step."""

    shares: NDArray[np.float64]
    """Of the step's time."""
    numbers: NDArray[np.intp]
    """Their rows in the record."""


class Series(NamedTuple):
    """A record and when its rows end."""

    record: WindRecord
    ends: NDArray[np.float64]
    """Time (s) since the first row, as if nothing were missing between rows."""


class SeriesWind(Parameters):
    """The winds of a series of rows, one after the other.

    A wind has polls in proportion to the sand that it moves, by the clock's flux law; below the threshold
    time passes without polls. Speeds at a height that the series states are brought to the clock's. Where a
    step covers more winds than ``winds``, that many of them blow for equal shares of the step's sand: they
    are picked at equal distances of sand moved from a random start, so that each is picked in proportion to
    the sand it moves, and all have the step's mean weather. Gaps of a record are skipped.
    """

    repeat: bool = parameter(
        True, unit="-", meaning="Whether the series starts over at its end; else a calm follows."
    )
    winds: int = parameter(
        16, unit="-", ge=1, le=100_000, scale="log", meaning="The most winds that blow in one step."
    )

    def series(self, seed: int) -> Series:
        """The series, in a run with a seed."""
        raise NotImplementedError

    def lasts(self, step: int, clock: StepClock) -> int:
        """Number of steps from ``step`` on in which the wind stays the same."""
        edges, start = self.series(clock.seed).ends, self._start(step, clock)
        if start is None:
            return FOR_EVER
        row = int(np.searchsorted(edges, start, "right"))
        return max(int((edges[row] - start) / clock.seconds() + _ROUNDING), 1)

    def period(self, _step: int, clock: StepClock) -> float:
        """Steps after which the wind comes again: 0 if within a step, infinite if never."""
        if not self.repeat:
            return math.inf
        cycle = float(self.series(clock.seed).ends[-1]) / clock.seconds()
        return cycle if cycle >= 1.0 else 0.0

    def transport(self, clock: StepClock) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Polls of each row of the series, over those of a step, and their directions (degrees)."""
        record = self.series(clock.seed).record
        _, strengths = _speeds_and_strengths(record, slice(None), clock)
        return record.duration / clock.seconds() * strengths, record.direction

    def intervals(self, step: int, clock: StepClock) -> list[WindInterval]:
        """Intervals of a step, in order."""
        rows, record = self._rows(step, clock), self.series(clock.seed).record
        speeds, strengths = _speeds_and_strengths(record, rows.numbers, clock)
        directions = record.direction[rows.numbers]
        shares = rows.shares
        weather = _weather_of(record, rows.numbers)
        if clock.deviates and len(speeds) > self.winds:
            picked, shares = self._picked(step, shares * strengths, clock)
            strength = float(np.dot(rows.shares, strengths))
            speeds, directions, strengths = speeds[picked], directions[picked], np.full(len(picked), strength)
            weather = [_mean_weather(record, rows)] * len(picked)
        columns = (shares.tolist(), directions.tolist(), speeds.tolist(), strengths.tolist(), weather)
        found = [
            WindInterval(share, direction, None, speed, strength, now)
            for share, direction, speed, strength, now in zip(*columns, strict=True)
        ]
        after = 1.0 - float(shares.sum())
        return [*found, WindInterval(after, 0.0, None, 0.0, 0.0)] if after > _ROUNDING else found

    def _picked(
        self, step: int, works: NDArray[np.float64], clock: StepClock
    ) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
        """Winds that represent all winds of a step, in proportion to the sand they move, and their shares."""
        total = np.cumsum(works)
        if total[-1] == 0.0:
            return np.zeros(1, np.intp), np.ones(1)
        first = float(clock.samples.draws(step, 1)[0] >> np.uint64(11)) * 2.0**-53
        at = (np.arange(self.winds) + first) / self.winds * total[-1]
        picked, counts = np.unique(np.searchsorted(total, at, "right"), return_counts=True)
        return picked, counts / self.winds

    def _start(self, step: int, clock: StepClock) -> float | None:
        """Time of the record (s) at which a step starts; None after the end of the record."""
        start, whole = step * clock.seconds(), float(self.series(clock.seed).ends[-1])
        if not self.repeat and start >= whole:
            return None
        return start % whole

    def _rows(self, step: int, clock: StepClock) -> Rows:
        start = self._start(step, clock)
        if start is None:
            return Rows(np.zeros(0), np.zeros(0, np.intp))
        edges, length = self.series(clock.seed).ends, clock.seconds()
        whole = float(edges[-1])
        if length >= whole and self.repeat:
            return Rows(np.diff(edges, prepend=0.0) / whole, np.arange(len(edges)))
        numbers, ends = _covered(edges, start, min(start + length, whole))
        if start + length > whole and self.repeat:
            more, later = _covered(edges, 0.0, start + length - whole)
            numbers, ends = np.append(numbers, more), np.append(ends, later + whole)
        shares = np.diff(ends, prepend=start) / length
        kept = shares > _ROUNDING
        return Rows(shares[kept], numbers[kept])

    def off_axes(self, _hexagonal: bool = False) -> bool:
        """Whether it ever blows off the axes of a lattice: taken as true of any series."""
        return True

    def placed_parts(self) -> list[tuple[tuple[str | int, ...], Blowing]]:
        """The winds that it is made of, and under which keys they stand: none is stated."""
        return []


def _speeds_and_strengths(
    record: WindRecord, rows: NDArray[np.intp] | slice, clock: StepClock
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Speeds of some rows at the clock's height, and the polls that they have over those of a step."""
    speeds = _at_clock_height(record.speed[rows], record.height, clock)
    return speeds, np.ones(len(speeds)) if clock.strength is None else clock.strength(speeds)


def _at_clock_height(
    speeds: NDArray[np.float64], height: float | None, clock: StepClock
) -> NDArray[np.float64]:
    """Speeds of a height (m) as they are at the clock's height, or without a clock at 10 m."""
    if clock.raised is None:
        if height in {None, REFERENCE_HEIGHT}:
            return speeds
        text = f"is {height:g} m; allowed without a clock: winds at {REFERENCE_HEIGHT:g} m"
        raise ScenarioError([Problem("wind.columns.height", text)])
    try:
        return clock.raised(speeds, height)
    except ValueError as error:
        raise ScenarioError([Problem("wind.columns.height", str(error))]) from None


def _covered(
    edges: NDArray[np.float64], start: float, end: float
) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """The rows between two times, and when each ends within them."""
    first = int(np.searchsorted(edges, start, "right"))
    last = min(int(np.searchsorted(edges, end, "left")), len(edges) - 1)
    numbers = np.arange(first, last + 1)
    return numbers, np.minimum(edges[numbers], end)


def _weather_of(record: WindRecord, numbers: NDArray[np.intp]) -> list[Weather]:
    """The weather of each of some rows."""
    if record.temperature is None and record.snowfall is None:
        return [UNKNOWN] * len(numbers)
    columns = [
        [None] * len(numbers)
        if values is None
        else [None if math.isnan(v) else v for v in values[numbers].tolist()]
        for values in (record.temperature, record.snowfall)
    ]
    return [Weather(*values) for values in zip(*columns, strict=True)]


def _mean_weather(record: WindRecord, rows: Rows) -> Weather:
    """The mean weather of the rows of a step, of those that state it."""
    means = []
    for values in (record.temperature, record.snowfall):
        known = rows.numbers[:0] if values is None else np.flatnonzero(~np.isnan(values[rows.numbers]))
        found = None
        if values is not None and known.size:
            found = float(np.average(values[rows.numbers[known]], weights=rows.shares[known]))
        means.append(found)
    return Weather(*means)
