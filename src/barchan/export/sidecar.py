"""The file beside an export that tells what its numbers mean and where they come from (JSON)."""

import hashlib
import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.replacing import replacing

if TYPE_CHECKING:
    from barchan.export.formats import Format
    from barchan.export.source import Source
    from barchan.lattice import Lattice

Files = Sequence[tuple[Path, tuple[int, ...], tuple[str, ...]]]
"""Each file with its steps and its fields."""


def sidecar_path(target: Path) -> Path:
    """The side-car file of a target: its name with ``.json`` after it."""
    return target.with_name(target.name + ".json")


def sidecar_of(chosen: "Format", source: "Source", files: Files, facts: dict[str, Any]) -> dict[str, Any]:
    """What the side-car file of an export says; ``facts`` are those that its writer returned."""
    from barchan.version import __version__

    return {
        "format": chosen.name,
        "program": f"Barchan {__version__}",
        "scenario": {
            "id": _digest(source.scenario.data()),
            "title": source.scenario.title,
            "seed": source.scenario.run.seed,
            "citation": source.scenario.citation,
        },
        "files": [
            {
                "file": path.name,
                "frames": [{"step": step, "seconds": source.seconds(step)} for step in steps],
                "fields": list(fields),
            }
            for path, steps, fields in files
        ],
        "frame": _frame(source),
        "periodic": _periodic(source),
        "changes": _changes(source),
        "ranges": {name: {"lowest": low, "highest": high} for name, (low, high) in source.ranges.items()},
        **facts,
    }


def _digest(scenario: dict[str, Any]) -> str:
    """A name for a scenario by all its keys but the number of threads, which never changes a result."""
    scenario["run"].pop("threads", None)
    return hashlib.sha256(json.dumps(scenario, sort_keys=True).encode()).hexdigest()[:16]


def _frame(source: "Source") -> dict[str, Any]:
    grid = source.grid
    return {
        "rows": grid.rows,
        "columns": grid.columns,
        "cell_width_m": grid.width,
        "cell_height_m": grid.height,
        "west_edge_m": grid.west,
        "south_edge_m": grid.south,
        "crs": grid.crs,
        "axes": "x to the east, y to the north, z up; values stand at the centres of cells",
    }


def _periodic(source: "Source") -> dict[str, Any]:
    lattice, grid = source.scenario.lattice, source.grid
    south_north, west_east = lattice.periodic
    told = []
    for joined, way, length in (
        (west_east, "west to east", lattice.width),
        (south_north, "south to north", lattice.height),
    ):
        told.append(f"repeats every {length:g} m {way}" if joined else f"has open edges {way}")
    return {
        "west_east": west_east,
        "south_north": south_north,
        "tiles": " and ".join(told),
        "first_row_and_column_repeated": grid.closed,
    }


def _changes(source: "Source") -> dict[str, Any]:
    options, lattice = source.options, source.scenario.lattice
    cells = options.cells
    slabs = f"layers are whole slabs of {lattice.thickness:g} m, which make terraces"
    if options.smooth or cells:
        slabs = "layers were whole numbers of their quantum; their mean is kept but for rounding"
    return {
        "smoothed_over_cells": options.smooth or 0,
        "brought_from": None if cells is None else {"columns": lattice.columns, "rows": lattice.rows},
        "brought_from_hexagons": _hexagons(lattice) if lattice.hexagonal else None,
        "slabs": slabs,
    }


def _hexagons(lattice: "Lattice") -> dict[str, Any]:
    return {
        "rows": lattice.rows,
        "columns": lattice.columns,
        "width_m": lattice.cell_size,
        "row_spacing_m": lattice.row_spacing,
        "how": "heights lie on straight lines between the cells' centres, along the rows and then from row "
        "to row; counts, and yes and no, are those of the cell that covers the centre",
    }


def write_sidecar(target: Path, data: dict[str, Any]) -> Path:
    """Write the side-car file of a target; returns its path."""
    path = sidecar_path(target)
    with replacing(path) as partial:
        partial.write_text(json.dumps(data, indent=2) + "\n", "utf-8")
    return path
