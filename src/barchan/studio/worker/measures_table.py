"""The measures of a run as the table that ``barchan export --format measures`` writes."""

from typing import Any

from barchan.analysis.declared_measures import measures_of
from barchan.export.measures import headings_of, row_of
from barchan.export.tables import cell
from barchan.scenario import Scenario
from barchan.studio.worker.measuring import Row


def measures_table(scenario: Scenario, rows: list[Row]) -> dict[str, list[Any]]:
    """``headings``, and the ``rows`` below them, each a list of texts."""
    units = {measure.name: measure.unit for measure in measures_of(scenario)}
    clock = scenario.step_seconds
    table = [
        row_of(
            row["step"],
            None if clock is None else clock * row["step"],
            [row["values"].get(name) for name in units],
            [name for name in units if row["doubts"].get(name)],
        )
        for row in rows
    ]
    return {
        "headings": headings_of(units, clock is not None),
        "rows": [[str(cell(value)) for value in row] for row in table],
    }
