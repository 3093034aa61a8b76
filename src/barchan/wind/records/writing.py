"""Writing a record as a table of text that can be read again."""

import math
from pathlib import Path

import numpy as np

from barchan.wind.records.record import WindRecord


def write_record(record: WindRecord, path: Path) -> None:
    """Write a record with its weather as CSV, without loss: every number as it is."""
    lines = ["# Written by Barchan.", f"# {record.source}", ",".join(_headings(record))]
    direction = np.where(record.without_direction, np.nan, record.direction)
    columns = [_times(record), _numbers(record.speed), _numbers(direction)]
    columns += [_numbers(v) for v in (record.temperature, record.snowfall) if v is not None]
    lines += [",".join(row) for row in zip(*columns, strict=True)]
    path.write_text("\n".join(lines) + "\n", "utf-8")


def _headings(record: WindRecord) -> list[str]:
    tall = "" if record.height is None else f"_{record.height:g}m"
    found = ["time" if record.start is not None else "time (s)", f"wind_speed{tall} (m/s)", "wind_direction"]
    if record.temperature is not None:
        found.append("temperature (°C)")
    if record.snowfall is not None:
        found.append("snowfall (kg/m²/s)")
    return found


def _times(record: WindRecord) -> list[str]:
    if record.start is None:
        return _numbers(record.time)
    whole = np.rint(record.time).astype("timedelta64[s]")
    stamps = record.start.astype("datetime64[s]") + whole
    return np.datetime_as_string(stamps, unit="s", timezone="UTC" if record.utc else "naive").tolist()


def _numbers(values: np.ndarray) -> list[str]:
    """Numbers as short as they can be read back exactly; nothing where there is none."""
    return ["" if math.isnan(value) else repr(value) for value in values.tolist()]
