"""A wind record in few words: its file, columns, height, time and rows, and the height that was assumed."""

import numpy as np
from numpy.typing import NDArray

from barchan.wind.clock import DAY
from barchan.wind.records.gaps import all_rows
from barchan.wind.records.record import WindRecord
from barchan.wind.records.snowfall import HOUR
from barchan.words import counted


def record_facts(record: WindRecord, assumed: float) -> dict[str, str]:
    """File, columns, height, time and rows of a record, for people to read.

    ``assumed`` (m) is the height at which its speeds are taken to be where it states none.
    """
    whole = len(record) + record.missing
    tall = f"at {record.height:g} m" if record.height is not None else f"taken to be at {assumed:g} m"
    known = f", format of {record.format}" if record.format else ""
    missing = _share(record.missing, whole)
    calm = f"{100 * record.calm_share:.1f} % of the known time calm"
    found = {
        "record": f"{record.source}{known}",
        "read": f"{record.columns}, {tall}",
        "point": record.place,
        "time covered": f"{record.seconds / DAY:.6g} days{_span(record)}",
        "rows": f"{whole}, {missing} missing, {calm}, {_gaps(record)}",
    }
    return {name: text for name, text in found.items() if text}


def height_remarks(record: WindRecord, assumed: float, key: str) -> list[str]:
    """A remark where a record does not state the height of its speeds, with the ``key`` that states it.

    ``assumed`` (m) is the height at which they are taken to be.
    """
    if record.height is not None:
        return []
    taken = f"the record does not state the height of its speeds; taken to be at {assumed:g} m"
    return [f"{taken}; {key} states another"]


def weather_facts(record: WindRecord) -> dict[str, str]:
    """Temperature and snowfall of a record over its whole time, gaps included, for people to read."""
    rows = all_rows(record)
    found = {}
    if rows.temperature is not None and (known := ~np.isnan(rows.temperature)).any():
        values, lasting = rows.temperature[known], rows.duration[known]
        mean = float(np.average(values, weights=lasting))
        unknown = 1.0 - float(lasting.sum()) / rows.seconds
        text = f"mean {mean:.1f} °C, {values.min():.1f} to {values.max():.1f} °C"
        found["temperature"] = text + (f", unknown for {100 * unknown:.1f} % of the time" if unknown else "")
    if rows.snowfall is not None:
        found |= _snow_facts(rows, np.nan_to_num(rows.snowfall))
    return found


def weather_remarks(record: WindRecord) -> list[str]:
    """What a record's weather does that drift, crests, dunes and the models of snow leave out."""
    rows, said = all_rows(record), []
    if rows.snowfall is not None and np.nan_to_num(rows.snowfall).any():
        said.append("drift, crests and dunes are those of dry sand, not of the snow that falls")
    if rows.temperature is not None:
        known = ~np.isnan(rows.temperature)
        thaw = known & (rows.temperature > 0.0)
        if thaw.any():
            share = float(rows.duration[thaw].sum()) / float(rows.duration[known].sum())
            said.append(
                f"the air is above 0 °C for {100 * share:.2g} % of the time; melt of snow is left out"
            )
    return said


def _snow_facts(rows: WindRecord, rate: NDArray[np.float64]) -> dict[str, str]:
    """Mass, time and greatest rate of snowfall (kg/m²/s), and the measured wind that it falls in."""
    mass = rate * rows.duration
    total, hours = float(mass.sum()), float(rows.duration[rate > 0.0].sum()) / HOUR
    if total == 0.0:
        return {"snowfall": "none"}
    found = {"snowfall": f"{total:.4g} kg/m² in {hours:.4g} h, at most {HOUR * rate.max():.3g} kg/m² an hour"}
    known = ~np.isnan(rows.speed) & (True if rows.supposed is None else ~rows.supposed)
    if mass[known].any():
        mean = float(np.average(rows.speed[known], weights=mass[known]))
        found["wind while it snows"] = f"mean {mean:.2f} m/s, by the mass that falls"
    return found


def _gaps(record: WindRecord) -> str:
    if not record.gaps:
        return "no gaps"
    return counted(record.gaps, "gap")


def _span(record: WindRecord) -> str:
    if record.start is None:
        return ""
    last = record.start + np.timedelta64(int(record.time[-1]), "s")
    return f", {str(record.start)[:10]} to {str(last)[:10]}{', times in UTC' if record.utc else ''}"


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} %"
