"""A wind record in few words: its file, columns, height, time and rows, and the height that was assumed."""

import numpy as np

from barchan.wind.clock import DAY
from barchan.wind.records.record import WindRecord


def record_facts(record: WindRecord, assumed: float) -> dict[str, str]:
    """File, columns, height, time and rows of a record, for people to read.

    ``assumed`` (m) is the height at which its speeds are taken to be where it states none.
    """
    whole = len(record) + record.missing
    tall = f"at {record.height:g} m" if record.height is not None else f"taken to be at {assumed:g} m"
    known = f", format of {record.format}" if record.format else ""
    missing, calm = _share(record.missing, whole), _share(record.calms, whole)
    found = {
        "record": f"{record.source}{known}",
        "read": f"{record.columns}, {tall}",
        "point": record.place,
        "time covered": f"{record.seconds / DAY:.6g} days{_span(record)}",
        "rows": f"{whole}, {missing} missing, {calm} calm, {_gaps(record)}",
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


def _gaps(record: WindRecord) -> str:
    if not record.gaps:
        return "no gaps"
    return "1 gap" if record.gaps == 1 else f"{record.gaps} gaps"


def _span(record: WindRecord) -> str:
    if record.start is None:
        return ""
    last = record.start + np.timedelta64(int(record.time[-1]), "s")
    return f", {str(record.start)[:10]} to {str(last)[:10]}"


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} %"
