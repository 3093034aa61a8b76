"""The measures of a run over its frames, as a table."""

from pathlib import Path
from typing import Any

from barchan.export.source import Source
from barchan.export.tables import heading, write_table


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a row for each chosen frame; the last column names measures that should not be quoted."""
    from barchan.analysis.time_series import measure_series

    series = measure_series(source.dataset, source.scenario)
    clocked = source.seconds(0) is not None
    headings = ["step", *(["time (s)"] if clocked else [])]
    headings += [heading(str(name), values.attrs["unit"]) for name, values in series.data_vars.items()]
    rows = []
    for step in source.steps:
        row = series.sel(step=step)
        doubtful = [
            str(name) for name, values in series.data_vars.items() if step in values.attrs["doubtful"]
        ]
        time = [source.seconds(step)] if clocked else []
        rows.append([step, *time, *(float(value) for value in row.data_vars.values()), " ".join(doubtful)])
    write_table(path, [*headings, "doubtful"], rows)
    return {"measures": {str(name): values.attrs["long_name"] for name, values in series.data_vars.items()}}
