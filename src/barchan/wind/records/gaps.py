"""Gaps of a record with weather: time passes in them, for snow ages without wind too."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from barchan.wind.records.record import WindRecord

_ROUNDING = 1e-6
"""Time (s) below which rows follow one another."""


def with_gaps(record: WindRecord) -> WindRecord:
    """A record with weather, with a calm in each gap: no snow falls, temperature goes on straight.

    A record without weather stays as it is, and its gaps are skipped.
    """
    if record.temperature is None and record.snowfall is None:
        return record
    ends = record.time + record.duration
    before = np.flatnonzero(record.time[1:] - ends[:-1] > _ROUNDING)
    if not before.size:
        return record
    lasting = record.time[before + 1] - ends[before]
    calm = np.zeros(before.size)
    days = float(lasting.sum()) / 86_400.0
    told = f"in {before.size} gaps of {days:.3g} days in all no wind blows and no snow falls; time passes"
    return replace(
        record,
        time=_inserted(record.time, before, ends[before]),
        duration=_inserted(record.duration, before, lasting),
        speed=_inserted(record.speed, before, calm),
        direction=_inserted(record.direction, before, calm),
        temperature=_bridged(record, before, ends[before] + lasting / 2),
        snowfall=None if record.snowfall is None else _inserted(record.snowfall, before, calm),
        remarks=(*record.remarks, told),
    )


def _inserted(
    values: NDArray[np.float64], before: NDArray[np.intp], new: NDArray[np.float64]
) -> NDArray[np.float64]:
    return np.insert(values, before + 1, new)


def _bridged(
    record: WindRecord, before: NDArray[np.intp], middles: NDArray[np.float64]
) -> NDArray[np.float64] | None:
    """Temperatures, those in the gaps on a straight line between the rows around them."""
    if record.temperature is None:
        return None
    known = ~np.isnan(record.temperature)
    between = np.interp(middles, record.time[known], record.temperature[known])
    return _inserted(record.temperature, before, between)
