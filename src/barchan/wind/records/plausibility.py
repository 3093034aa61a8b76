"""Whether a record looks like wind in the units that it was read in."""

import numpy as np

from barchan.wind.records.record import WindRecord

STRONGEST_MEAN = 20.0
"""Mean speed (m/s) above which a record is doubted: that of Cape Denison, the windiest place at sea
level, is 19."""

STRONGEST = 75.0
"""Speed (m/s) above which a record is doubted: gusts of the strongest cyclones."""

STRONGEST_LASTING = 45.0
"""Mean speed (m/s) over ten minutes or more above which a record is doubted: that of the strongest storms
of the middle latitudes, and of hurricanes of the third category at sea."""

LASTING = 600.0
"""Duration (s) from which on a row is a mean and no gust."""

WEAKEST_HIGHEST = 1.0
"""Highest speed (m/s) below which a record is doubted."""

STUCK = 86_400.0
"""Duration (s) from which on one speed, to the last digit, is that of a sensor that is stuck; ours: means of
an hour that are rounded to 1 m/s repeat by chance for some hours."""

STUCK_ROWS = 12
"""Rows that it has at least: means of days repeat sooner."""

ENOUGH = 30
"""Winds from which on directions are judged."""

_WIDTHS = ((45.0, 4), (22.5, 5), (10.0, 3))
"""Steps in which directions are reported (degrees), and how many different ones show it."""


def warnings_of(record: WindRecord) -> tuple[str, ...]:
    """What makes a record implausible, as a wrong unit does."""
    mean = float(np.average(record.speed, weights=record.duration))
    highest = float(record.speed.max())
    found = []
    if mean > STRONGEST_MEAN:
        found.append(
            f"the mean speed is {mean:.1f} m/s; no place on Earth has more than {STRONGEST_MEAN:g} m/s: "
            "is the unit right (0.1 m/s, km/h, kn)?"
        )
    elif highest > STRONGEST:
        found.append(
            f"the highest speed is {highest:.1f} m/s, more than in the strongest cyclones: is the unit right?"
        )
    elif not record.unit_stated:
        found += lasting_doubts(record)
    if highest < WEAKEST_HIGHEST and len(record) >= ENOUGH:
        found.append(f"the highest speed is {highest:.2f} m/s, hardly a wind: is the unit right?")
    blows = record.direction[record.speed > 0]
    if len(blows) >= ENOUGH and len(np.unique(blows)) > 3:
        if blows.max() <= 2 * np.pi + 0.01:
            found.append(f"all winds come from 0 to {blows.max():.2f}°: are directions in radians?")
        elif blows.max() <= 36.0 and (blows == np.round(blows)).all():
            found.append(f"all winds come from 0 to {blows.max():g}°: are directions in tens of degrees?")
    return tuple(found)


def lasting_doubts(record: WindRecord) -> list[str]:
    """Doubt of a mean over ten minutes or more that hardly any storm has."""
    usual, highest = float(np.median(record.duration)), float(record.speed.max())
    if usual < LASTING or highest <= STRONGEST_LASTING:
        return []
    return [
        (
            f"the highest speed, a mean over {usual / 60:g} min, is {highest:.1f} m/s; more than "
            f"{STRONGEST_LASTING:g} m/s are winds of hurricanes: is the unit right (km/h, kn, mph)? State "
            "it as unit"
        )
    ]


def stuck(record: WindRecord) -> list[str]:
    """Doubt of the longest time for which the speed is the same, where that is a day or more and no calm."""
    starts = np.flatnonzero(np.concatenate([[True], np.diff(record.speed) != 0.0]))
    rows = np.diff(np.append(starts, len(record)))
    lasts = np.add.reduceat(record.duration, starts)
    lasts[(record.speed[starts] == 0.0) | (rows < STUCK_ROWS)] = 0.0
    longest = int(np.argmax(lasts))
    if lasts[longest] < STUCK or len(starts) == 1:
        return []
    first, share = starts[longest], lasts[longest] / record.duration.sum()
    when = (
        "" if record.start is None else f" from {record.start + np.timedelta64(int(record.time[first]), 's')}"
    )
    hours, speed = lasts[longest] / 3600, record.speed[first]
    said = f"the speed is {speed:.4g} m/s for {hours:.4g} hours on end{when}, {share:.1%} of the record"
    return [f"{said}: is the sensor stuck?"]


def direction_width(record: WindRecord) -> float:
    """Degrees that each direction stands for: the step in which all are reported; 0 where there is none."""
    blows = record.direction[record.speed > 0]
    if len(blows) < ENOUGH:
        return 0.0
    different = len(np.unique(blows))
    return next((width for width, least in _WIDTHS if different >= least and not np.any(blows % width)), 0.0)
