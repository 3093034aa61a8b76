"""The measures of an ensemble as tables: one row a member, or one a frame."""

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.analysis.declared_measures import MEASURES, PER_YEAR
from barchan.ensembles.axes import value_label
from barchan.ensembles.plan import Plan, load_plan
from barchan.ensembles.reports import State, read_failure, read_report, state_of
from barchan.errors import ArchiveError
from barchan.replacing import replacing

if TYPE_CHECKING:
    import pandas as pd

TABLE, UNITS = "measures", "measures-units.csv"


TAKEN = {
    *("member", "realization", "seed", "state", "error", "steps", "reason", "seconds", "version", "host"),
    *("bed", "doubtful", "status", "step", "x", "y", "time", "point", "name", "kind"),
    *("ground", "sand", "elevation"),
    *(measure.name for measure in (*MEASURES, *PER_YEAR)),
}
"""Names in tables and datasets that no axis can have."""


def short_names(plan: Plan) -> list[str]:
    """A name for each axis: the last part of its key where nothing else is named like it, else the key."""
    lasts = [axis.key.rpartition(".")[2] for axis in plan.axes]
    return [
        axis.key if lasts.count(last) > 1 or last in TAKEN else last
        for axis, last in zip(plan.axes, lasts, strict=True)
    ]


def measure_table(folder: str | Path) -> "pd.DataFrame":
    """A row for each member: its values, realization, seed, state, how it ran, measures of its last frame.

    ``doubtful`` names the measures that should not be quoted. Measures of members that are not at their end
    are empty (NaN). The attribute ``units`` of the table holds the units of measures.
    """
    import pandas as pd

    folder = Path(folder)
    plan = load_plan(folder)
    names = short_names(plan)
    rows: list[dict[str, Any]] = []
    units: dict[str, str] = {}
    for member in plan.members:
        report, failure = read_report(folder, member.id), read_failure(folder, member.id)
        row = {
            "member": member.id,
            **_named(names, member.values),
            "realization": member.realization,
            "seed": member.seed,
            "state": str(state_of(folder, member.id)),
            "error": failure.message if failure else "",
        }
        if report is not None:
            measures = [name for name in report.series if name != "step"]
            units |= {name: report.units[name] for name in measures}
            row |= {"steps": report.steps, "reason": report.reason, "seconds": report.seconds}
            row |= {"version": report.version, "host": report.host, "bed": report.bed}
            row["doubtful"] = " ".join(name for name in measures if report.is_doubtful(name))
            row |= {name: report.last(name) for name in measures}
        rows.append(row)
    table = pd.DataFrame(rows)
    table.attrs["units"] = units
    return table


def _named(names: Sequence[str], values: Sequence[Any]) -> dict[str, Any]:
    """The values of the axes by name, whole groups in words."""
    return {
        name: value_label(value) if isinstance(value, dict | list) else value
        for name, value in zip(names, values, strict=True)
    }


def series_table(folder: str | Path) -> "pd.DataFrame":
    """A row for each frame of each finished member: its values, realization, seed, step and measures."""
    import pandas as pd

    folder = Path(folder)
    plan = load_plan(folder)
    names = short_names(plan)
    parts = []
    for member in plan.members:
        report = read_report(folder, member.id)
        if report is not None:
            about = {**_named(names, member.values), "realization": member.realization}
            parts.append(pd.DataFrame({"member": member.id, **about, "seed": member.seed, **report.series}))
    if not parts:
        raise ArchiveError(f"{folder}: no member is at its end yet")
    return pd.concat(parts, ignore_index=True)


def write_tables(folder: str | Path) -> list[Path]:
    """Write the table of measures as CSV, and as Parquet where pyarrow is installed; the files written.

    Raises ArchiveError where they cannot be written.
    """
    import pandas as pd

    folder = Path(folder)
    table = measure_table(folder)
    units = pd.DataFrame(table.attrs["units"].items(), columns=["measure", "unit"])
    written = [folder / f"{TABLE}.csv", folder / UNITS]
    try:
        for path, content in zip(written, (table, units), strict=True):
            with replacing(path) as partial:
                content.to_csv(partial, index=False)
        if find_spec("pyarrow") is not None:
            written.append(folder / f"{TABLE}.parquet")
            with replacing(written[-1]) as partial:
                _plain(table).to_parquet(partial, index=False)
    except OSError as error:
        raise ArchiveError(f"cannot write to {folder}: {error.strerror or error}") from error
    return written


def _plain(table: "pd.DataFrame") -> "pd.DataFrame":
    """The table with columns of one type each, as Parquet has them."""
    mixed: Sequence[str] = [name for name in table.columns if table[name].dtype == object]
    return table.astype(dict.fromkeys(mixed, str))


def failures(folder: str | Path) -> dict[str, str]:
    """Why members failed, by their names."""
    folder = Path(folder)
    found = {m.id: read_failure(folder, m.id) for m in load_plan(folder).members}
    return {
        name: failure.message
        for name, failure in found.items()
        if failure is not None and state_of(folder, name) == State.FAILED
    }
