"""Gaps of a record with weather: time passes in them, for snow falls and ages without a known wind too."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from barchan.wind.records.record import WindlessRows, WindRecord

SHORT = 3 * 3600.0
"""Longest gap (s) in which the wind of the row before goes on; in longer ones it is calm."""

LONGEST_BRIDGE = SHORT
"""Longest time (s) over which a missing temperature is taken from its neighbours."""

_ROUNDING = 1e-6
"""Time (s) below which rows follow one another."""


def with_gaps(record: WindRecord) -> WindRecord:
    """A record with weather, without gaps; a record without weather stays as it is, and its gaps are skipped.

    Rows without a wind keep their snowfall. Where rows are absent no snow falls, and temperature goes on
    straight. The wind is that of the row before for three hours or less; in longer gaps it is calm.
    """
    if record.temperature is None and record.snowfall is None:
        return record
    rows = joined_rows(all_rows(record), holes(record))
    known = ~np.isnan(rows.speed)
    if known.all():
        return record
    days = float(rows.duration[~known].sum()) / 86_400.0
    told = f"time passes in {days:.3g} days without a wind, in gaps over {SHORT / 3600:g} hours as a calm"
    return replace(filled(rows, known), remarks=(*record.remarks, told))


def all_rows(record: WindRecord) -> WindRecord:
    """The rows of a record and those without a wind (NaN)."""
    return record if record.windless is None else joined_rows(record, record.windless)


def holes(record: WindRecord) -> WindlessRows:
    """What is missing between the rows of a record, with no snowfall and no temperature."""
    rows = all_rows(record)
    ends = rows.time + rows.duration
    before = np.flatnonzero(rows.time[1:] - ends[:-1] > _ROUNDING)
    unknown = np.full(before.size, np.nan)
    return WindlessRows(ends[before], rows.time[before + 1] - ends[before], unknown, np.zeros(before.size))


def joined_rows(record: WindRecord, more: WindlessRows) -> WindRecord:
    """The rows of both in the order of time."""
    time = np.append(record.time, more.time)
    order = np.argsort(time, kind="stable")
    unknown = np.full(len(more.time), np.nan)

    def merged(
        values: NDArray[np.float64] | None, others: NDArray[np.float64] | None
    ) -> NDArray[np.float64] | None:
        return None if values is None else np.append(values, unknown if others is None else others)[order]

    return replace(
        record,
        time=time[order],
        duration=np.append(record.duration, more.duration)[order],
        speed=np.append(record.speed, unknown)[order],
        direction=np.append(record.direction, unknown)[order],
        temperature=merged(record.temperature, more.temperature),
        snowfall=merged(record.snowfall, more.snowfall),
        windless=None,
        undirected=None
        if record.undirected is None
        else np.append(record.undirected, np.zeros(len(more.time), bool))[order],
    )


def filled(rows: WindRecord, known: NDArray[np.bool_]) -> WindRecord:
    """The rows, those without a wind (not ``known``) with a supposed one and with a temperature."""
    last = np.maximum.accumulate(np.where(known, np.arange(len(known)), 0))
    run = np.cumsum(known)
    lasting = np.bincount(run, np.where(known, 0.0, rows.duration))[run]
    goes_on = known | (known[last] & (lasting <= SHORT))
    temperature = rows.temperature
    if temperature is not None:
        there = ~np.isnan(temperature)
        middles = rows.time + rows.duration / 2
        between = np.interp(middles, middles[there], temperature[there])
        temperature = np.where(there | known, temperature, between)
    return replace(
        rows,
        speed=np.where(goes_on, rows.speed[last], 0.0),
        direction=np.where(goes_on, rows.direction[last], 0.0),
        temperature=temperature,
        supposed=None if known.all() else ~known,
    )


def bridged(values: NDArray[np.float64], time: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Temperatures, those missing for a short time on a straight line between their neighbours.

    None where all are missing.
    """
    if np.isnan(values).all():
        return None
    known = ~np.isnan(values)
    order = np.argsort(time[known], kind="stable")
    at, there = time[known][order], values[known][order]
    after = np.clip(np.searchsorted(at, time), 1, len(at) - 1) if len(at) > 1 else np.zeros(len(time), int)
    inside = (time >= at[0]) & (time <= at[-1])
    short = inside & (at[after] - at[np.maximum(after - 1, 0)] <= LONGEST_BRIDGE)
    return np.where(known, values, np.where(short, np.interp(time, at, there), np.nan))
