"""A wind record: speed and direction over time, checked."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError

FASTEST = 150.0
"""Speed (m/s) that no wind near the ground exceeds: more is a wrong unit, or a code for a missing value."""

GAP = 3.0
"""A row stands until the next one; rows further apart than this many usual steps have a gap between them."""


@dataclass(frozen=True)
class WindRecord:
    """Winds in the order of time, each with its duration; missing rows are left out and counted."""

    time: NDArray[np.float64]
    """Beginning of each wind (s) since ``start``."""
    duration: NDArray[np.float64]
    """How long it stands for (s)."""
    speed: NDArray[np.float64]
    """m/s."""
    direction: NDArray[np.float64]
    """Where it comes from, degrees clockwise from north in [0, 360); 0 in a calm."""
    start: np.datetime64 | None = None
    """Time of the first row (UTC or local, as the file has it), where the file has dates."""
    missing: int = 0
    """Rows without a speed, or without a direction while the air moved."""
    gaps: int = 0
    """Times at which rows are absent from the file."""
    source: str = ""
    """Where it is from."""
    remarks: tuple[str, ...] = field(default=())
    """Assumptions made in reading it."""

    @property
    def calms(self) -> int:
        """Rows without wind."""
        return int(np.count_nonzero(self.speed == 0.0))

    @property
    def seconds(self) -> float:
        """Time that the record covers (s), missing rows left out."""
        return float(self.duration.sum())

    def __len__(self) -> int:
        """Number of winds."""
        return len(self.time)


@dataclass(frozen=True)
class Rows:
    """The rows of a file, not yet checked; NaN where a value is missing."""

    source: str
    time: NDArray[np.float64]
    """Seconds since ``start``."""
    start: np.datetime64 | None
    speed: NDArray[np.float64]
    """m/s."""
    direction: NDArray[np.float64]
    names: dict[str, str]
    """Names of time, speed and direction in the file."""
    numbers: NDArray[np.int64]
    """Number of each row in the file."""
    unit: tuple[str, float] = ("m/s", 1.0)
    """Unit of the file's speeds and how many m/s it is."""
    remarks: tuple[str, ...] = ()

    def text(self, row: int) -> str:
        """The time of a row, as people write it."""
        if self.start is None:
            return f"{self.time[row]:g} s"
        return str(self.start + np.timedelta64(round(self.time[row]), "s"))


def checked(rows: Rows) -> WindRecord:
    """The record that rows make; raises RecordError with the first mistake of each kind."""
    problems = [*_time_problems(rows), *_value_problems(rows)]
    if problems:
        raise RecordError(problems, rows.source)
    step, duration, gaps = _durations(rows.time)
    direction = np.where(rows.speed == 0.0, 0.0, rows.direction) % 360.0
    usable = ~(np.isnan(rows.speed) | np.isnan(direction))
    if not usable.any():
        raise RecordError([Problem("", f"holds no wind; all of {len(usable)} rows are missing")], rows.source)
    remarks = list(rows.remarks)
    if gaps:
        remarks.append(f"gaps: {gaps}; the row before each stands for the usual step, {step:g} s")
    return WindRecord(
        time=rows.time[usable],
        duration=duration[usable],
        speed=rows.speed[usable],
        direction=direction[usable],
        start=rows.start,
        missing=int(np.count_nonzero(~usable)),
        gaps=gaps,
        source=rows.source,
        remarks=tuple(remarks),
    )


def _durations(time: NDArray[np.float64]) -> tuple[float, NDArray[np.float64], int]:
    """The usual step, how long each row stands for, and the number of gaps."""
    steps = np.diff(time)
    usual = float(np.median(steps))
    gap = steps > GAP * usual
    return usual, np.append(np.where(gap, usual, steps), usual), int(np.count_nonzero(gap))


def _time_problems(rows: Rows) -> list[Problem]:
    if len(rows.time) < 2:
        return [Problem("", f"holds {len(rows.time)} winds; allowed: two or more")]
    back = np.flatnonzero(np.diff(rows.time) <= 0)
    if not back.size:
        return []
    row = int(back[0]) + 1
    message = f"is {rows.text(row)} after {rows.text(row - 1)}; allowed: times that increase"
    return [_problem(rows, "time", row, message)]


def _value_problems(rows: Rows) -> list[Problem]:
    problems = []
    unit, metres = rows.unit
    wrong = {
        "speed": (
            rows.speed / metres,
            (rows.speed < 0) | (rows.speed > FASTEST),
            f"allowed: speeds from 0 to {FASTEST / metres:.0f} {unit}",
        ),
        "direction": (
            rows.direction,
            (rows.direction < 0) | (rows.direction > 360),
            "allowed: directions from 0 to 360 degrees",
        ),
    }
    for quantity, (values, bad, allowed) in wrong.items():
        if bad.any():
            row = int(np.argmax(bad))
            count = int(np.count_nonzero(bad))
            others = f" ({count} rows in all)" if count > 1 else ""
            problems.append(_problem(rows, quantity, row, f"is {values[row]:g}; {allowed}{others}"))
    return problems


def _problem(rows: Rows, quantity: str, row: int, message: str) -> Problem:
    return Problem(f"row {rows.numbers[row]}, column '{rows.names[quantity]}'", message)
