"""A wind that blows as it was recorded."""

import math
from functools import lru_cache
from pathlib import Path
from typing import ClassVar, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.errors import Problem, RecordError, ScenarioError
from barchan.parameters import Parameters, parameter
from barchan.wind.blowing import Blowing
from barchan.wind.interval import StepClock, WindInterval
from barchan.wind.records import SAMPLE, RecordFormat, WindRecord, read_record
from barchan.wind.steady import FOR_EVER

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


class Recorded(Parameters):
    """The winds of a record, one after the other, at the speed of the run's clock.

    A wind has polls in proportion to the sand that it moves, by the clock's flux law; below the threshold
    time passes without polls. Where a step covers more winds than ``winds``, that many of them blow for
    equal shares of the step's sand: they are picked at equal distances of sand moved from a random start,
    so that each is picked in proportion to the sand it moves. Gaps of the record are skipped.
    """

    kind_key: ClassVar[str] = "kind"

    kind: Literal["record"] = parameter("record", unit="-", meaning="Winds as they were recorded.")
    path: str | None = parameter(
        None,
        unit="-",
        min_length=1,
        meaning="The record, CSV or NetCDF; by default the made-up one that ships with Barchan.",
    )
    columns: RecordFormat = Field(default_factory=RecordFormat, description="How the record is written.")
    repeat: bool = parameter(
        True, unit="-", meaning="Whether the record starts over at its end; else a calm follows."
    )
    winds: int = parameter(
        16, unit="-", ge=1, le=100_000, scale="log", meaning="The most winds that blow in one step."
    )

    @property
    def record(self) -> WindRecord:
        """The record; raises ScenarioError where it cannot be used."""
        return self._series.record

    @property
    def _series(self) -> "Series":
        source = SAMPLE if self.path is None else self.path
        file = Path(source)
        changed = file.stat().st_mtime_ns if self.path is not None and file.is_file() else 0
        try:
            return _read(source, self.columns, changed)
        except RecordError as error:
            found = [
                Problem("wind.path", f"{p.key}: {p.message}" if p.key else p.message) for p in error.problems
            ]
            raise ScenarioError(found, source) from None

    def lasts(self, step: int, clock: StepClock) -> int:
        """Number of steps from ``step`` on in which the wind stays the same."""
        edges, start = self._series.ends, self._start(step, clock)
        if start is None:
            return FOR_EVER
        row = int(np.searchsorted(edges, start, "right"))
        return max(int((edges[row] - start) / clock.seconds() + _ROUNDING), 1)

    def period(self, _step: int, clock: StepClock) -> float:
        """Steps after which the wind comes again: 0 if within a step, infinite if never."""
        if not self.repeat:
            return math.inf
        cycle = float(self._series.ends[-1]) / clock.seconds()
        return cycle if cycle >= 1.0 else 0.0

    def intervals(self, step: int, clock: StepClock) -> list[WindInterval]:
        """Intervals of a step, in order."""
        rows, record = self._rows(step, clock), self.record
        speeds, directions = record.speed[rows.numbers], record.direction[rows.numbers]
        strengths = np.ones(len(speeds)) if clock.strength is None else clock.strength(speeds)
        shares = rows.shares
        if clock.deviates and len(speeds) > self.winds:
            picked, shares = self._picked(step, shares * strengths, clock)
            strength = float(np.dot(rows.shares, strengths))
            speeds, directions, strengths = speeds[picked], directions[picked], np.full(len(picked), strength)
        columns = (shares, directions, speeds, strengths)
        found = [
            WindInterval(share, direction, None, speed, strength)
            for share, direction, speed, strength in zip(*(c.tolist() for c in columns), strict=True)
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
        start, whole = step * clock.seconds(), float(self._series.ends[-1])
        if not self.repeat and start >= whole:
            return None
        return start % whole

    def _rows(self, step: int, clock: StepClock) -> Rows:
        start = self._start(step, clock)
        if start is None:
            return Rows(np.zeros(0), np.zeros(0, np.intp))
        edges, length = self._series.ends, clock.seconds()
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

    def placed_parts(self) -> list[tuple[tuple[str | int, ...], Blowing]]:
        """The winds that it is made of, and under which keys they stand: none is stated."""
        return []

    def summary(self) -> str:
        """The wind in a few words."""
        return f"as in the record {'that ships with Barchan' if self.path is None else Path(self.path).name}"


def _covered(
    edges: NDArray[np.float64], start: float, end: float
) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """The rows between two times, and when each ends within them."""
    first = int(np.searchsorted(edges, start, "right"))
    last = min(int(np.searchsorted(edges, end, "left")), len(edges) - 1)
    numbers = np.arange(first, last + 1)
    return numbers, np.minimum(edges[numbers], end)


@lru_cache(maxsize=4)
def _read(source: str, columns: RecordFormat, _changed: int) -> Series:
    record = read_record(source, columns)
    return Series(record, np.cumsum(record.duration))
