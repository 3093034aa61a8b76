"""ESRI ASCII grid: one field of one frame, north up."""

from pathlib import Path
from typing import Any

import numpy as np

from barchan.export.numbers import floats
from barchan.export.source import Source

MISSING = -9999
"""Stands for cells without a value."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a field with nine digits, which is all that 32-bit floats hold."""
    grid, sheet = source.grid, source.sheet()
    values = floats(sheet.values[::-1])
    rows = np.where(np.isfinite(values), values, MISSING).tolist()
    with path.open("w", encoding="ascii") as file:
        file.write(
            f"ncols {grid.columns}\nnrows {grid.rows}\nxllcorner {grid.west!r}\nyllcorner {grid.south!r}\n"
            f"cellsize {grid.cell_size!r}\nNODATA_value {MISSING}\n"
        )
        line = " ".join(["%.9g"] * grid.columns) + "\n"
        file.writelines(line % tuple(row) for row in rows)
    return {"first_row": "north"}
