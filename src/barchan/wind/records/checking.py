"""From the rows of a file to a record: ordered, checked, each wind with its duration."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.directionless import direction_before, undirected_remarks
from barchan.wind.records.durations import durations
from barchan.wind.records.plausibility import direction_width, lasting_doubts, stuck, warnings_of
from barchan.wind.records.record import Rows, WindlessRows, WindRecord
from barchan.words import counted

FASTEST = 150.0
"""Speed (m/s) that no wind near the ground exceeds: more is a wrong unit, or a code for a missing value."""

MOST_REPEATED = 0.01
"""Share of rows that may state another wind for a time that is already there, as at the end of summer
time."""


def checked(rows: Rows) -> WindRecord:
    """The record that rows make; raises RecordError with the first mistake of each kind."""
    problems = _value_problems(rows)
    if len(rows.time) < 2:
        problems.insert(0, Problem("", f"holds {counted(len(rows.time), 'wind')}; allowed: two or more"))
    if problems:
        raise RecordError(problems, rows.source)
    rows, ordered = _in_order(rows)
    rows, duplicates, repeated = _once(rows)
    if len(rows.time) < 2:
        raise RecordError([Problem("", "holds winds of one time only; allowed: two or more")], rows.source)
    usual, duration, gaps = durations(rows.time)
    direction = np.where(rows.speed == 0.0, 0.0, rows.direction) % 360.0
    usable = ~np.isnan(rows.speed)
    if not (usable & ~np.isnan(direction)).any():
        raise RecordError([Problem("", f"holds no wind; all of {len(usable)} rows are missing")], rows.source)
    remarks = [*ordered, *repeated, *rows.remarks]
    if gaps:
        remarks.append(
            f"gaps: {gaps}; the row before each stands for the usual step there, mostly {usual:g} s"
        )
    read = " and ".join(dict.fromkeys((rows.names["speed"], rows.names["direction"])))
    record = WindRecord(
        time=rows.time[usable],
        duration=duration[usable],
        speed=rows.speed[usable],
        direction=direction_before(direction[usable]),
        start=rows.start,
        missing=int(np.count_nonzero(~usable)),
        gaps=gaps,
        source=rows.source,
        remarks=tuple(remarks),
        height=rows.height,
        format=rows.format,
        columns=f"{read}, in {rows.unit[0]}",
        place=rows.place,
        duplicates=duplicates,
        temperature=_some(rows.temperature, usable),
        snowfall=_some(rows.snowfall, usable),
        windless=_windless(rows, duration, ~usable),
        unit_stated=rows.unit_stated,
        utc=rows.utc,
        undirected=undirected if (undirected := np.isnan(direction[usable])).any() else None,
    )
    doubts = lasting_doubts(record) if record.unit_stated else []
    record = replace(record, remarks=(*record.remarks, *undirected_remarks(record), *doubts, *stuck(record)))
    return replace(record, warnings=warnings_of(record), direction_width=direction_width(record))


def _some(values: NDArray[np.float64] | None, which: NDArray) -> NDArray[np.float64] | None:
    """Values of some rows, where there are any."""
    return None if values is None else values[which]


def _windless(rows: Rows, duration: NDArray[np.float64], which: NDArray[np.bool_]) -> WindlessRows | None:
    """The rows that hold weather and no wind."""
    if not which.any() or (rows.temperature is None and rows.snowfall is None):
        return None
    weather = _some(rows.temperature, which), _some(rows.snowfall, which)
    return WindlessRows(rows.time[which], duration[which], *weather)


def _in_order(rows: Rows) -> tuple[Rows, list[str]]:
    """The rows in the order of time, counted from the earliest, and whether they were not."""
    steps = np.diff(rows.time)
    if (steps >= 0).all():
        return rows, []
    order = np.argsort(rows.time, kind="stable")
    first = float(rows.time[order[0]])
    start = None if rows.start is None else rows.start + np.timedelta64(round(first), "s")
    picked = _picked(rows, order)
    return replace(picked, time=picked.time - first, start=start), [
        "rows were not in the order of time; sorted"
    ]


def _picked(rows: Rows, which: NDArray) -> Rows:
    return replace(
        rows,
        time=rows.time[which],
        speed=rows.speed[which],
        direction=rows.direction[which],
        numbers=rows.numbers[which],
        temperature=_some(rows.temperature, which),
        snowfall=_some(rows.snowfall, which),
    )


def _once(rows: Rows) -> tuple[Rows, int, list[str]]:
    """One row for each time, the number of rows dropped, and a remark on them.

    Of several the first with a speed and a direction is kept, else the first with a speed. Raises
    RecordError where many rows state another wind for the same time, as where stations are mixed.
    """
    again = np.append(False, np.diff(rows.time) == 0)
    if not again.any():
        return rows, 0, []
    group = np.cumsum(~again)
    lacking = np.isnan(rows.speed) * 2 + (np.isnan(rows.direction) & (rows.speed != 0.0))
    absent = lacking > 0
    order = np.lexsort((np.arange(len(group)), lacking, group))
    kept = np.sort(order[np.append(True, np.diff(group[order]) > 0)])
    heads = kept[group - 1]
    differs = (
        ~absent
        & ~absent[heads]
        & ~(
            np.isclose(rows.speed, rows.speed[heads])
            & np.isclose(rows.direction, rows.direction[heads], equal_nan=True)
        )
    )
    other = int(np.count_nonzero(differs))
    if other > max(MOST_REPEATED * len(group), 2) and not rows.several_reports:
        row = int(np.argmax(differs))
        message = (
            f"states another wind for the time of row {rows.numbers[heads[row]]} ({other} such rows): "
            f"are stations "
            "or heights mixed? Allowed: one wind for each time"
        )
        raise RecordError([Problem(f"row {rows.numbers[row]}", message)], rows.source)
    dropped = len(group) - len(kept)
    told = f"of several rows of one time the first with a wind is kept: {dropped} dropped" + (
        f", {other} of them with another wind" if other else ""
    )
    return _picked(rows, kept), dropped, [told]


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
            where = f"row {rows.numbers[row]}, column '{rows.names[quantity]}'"
            problems.append(Problem(where, f"is {values[row]:g}; {allowed}{others}"))
    return problems
