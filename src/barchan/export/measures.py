"""The measures of a run over its frames, as a table."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from barchan.export.source import Source
from barchan.export.tables import heading, write_table


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a row for each chosen frame; the last column names measures that should not be quoted."""
    from barchan.analysis.time_series import measure_series

    series = measure_series(source.dataset, source.scenario)
    clocked = source.seconds(0) is not None
    headings = headings_of({str(name): v.attrs["unit"] for name, v in series.data_vars.items()}, clocked)
    rows = []
    for step in source.steps:
        row = series.sel(step=step)
        doubtful = [
            str(name) for name, values in series.data_vars.items() if step in values.attrs["doubtful"]
        ]
        values = [float(value) for value in row.data_vars.values()]
        rows.append(row_of(step, source.seconds(step), values, doubtful))
    write_table(path, headings, rows)
    return {"measures": {str(name): values.attrs["long_name"] for name, values in series.data_vars.items()}}


def headings_of(units: Mapping[str, str], clocked: bool) -> list[str]:
    """The headings of measures by their units; ``clocked`` where the run knows its time."""
    measures = [heading(name, unit) for name, unit in units.items()]
    return ["step", *(["time (s)"] if clocked else []), *measures, "doubtful"]


def row_of(
    step: int, seconds: float | None, values: Iterable[float | None], doubtful: Iterable[str]
) -> list[Any]:
    """The row of a step, with its time (s) where that is known, in the order of ``headings_of``."""
    return [step, *([] if seconds is None else [seconds]), *values, " ".join(doubtful)]
