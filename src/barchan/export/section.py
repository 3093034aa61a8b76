"""A section along the wind, as a table."""

from pathlib import Path
from typing import Any

from barchan.analysis.on_squares import on_squares
from barchan.export.source import Source
from barchan.export.tables import heading, write_table
from barchan.figures.section_lines import section_along_wind, through_highest


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a row for each cell of the section, from its upwind end: distance, place, fields."""
    frame, scenario = on_squares(source.frame(source.steps[0]), source.scenario)
    grid = source.grid
    at = source.options.at
    place = through_highest(frame, scenario) if at is None else at
    line = section_along_wind(scenario, float(frame["wind_direction"]), place)
    sheets = list(source.sheets(source.steps[0]).values())
    headings = ["distance (m)", "x (m)", "y (m)", *(heading(sheet.name, sheet.unit) for sheet in sheets)]
    columns = [line.distance, grid.x[line.cols], grid.y[line.rows]]
    columns += [sheet.values[line.rows, line.cols] for sheet in sheets]
    write_table(path, headings, zip(*(column.tolist() for column in columns), strict=True))
    return {
        "section": {"place": line.place, "wind_from_degrees": float(frame["wind_direction"]), "at": place},
        "columns": {sheet.name: {"unit": sheet.unit, "meaning": sheet.meaning} for sheet in sheets},
    }
