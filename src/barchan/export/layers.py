"""The layers of a bed along a section, as a table."""

from pathlib import Path
from typing import Any

import numpy as np

from barchan.export.layer_table import layers_of
from barchan.export.source import Source
from barchan.export.tables import heading, write_table


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a row for each layer of each cell of the section, from the ground up, in every frame."""
    table = layers_of(source)
    columns = {heading(str(name), str(values.attrs["unit"])): values.values for name, values in table.items()}
    rows = zip(*(_plain(values) for values in columns.values()), strict=True)
    write_table(path, list(columns), rows)
    return {
        "section": {"at": table.attrs["at"]},
        "columns": {
            str(name): {"unit": values.attrs["unit"], "meaning": values.attrs["long_name"]}
            for name, values in table.items()
        },
    }


DIGITS = 6
"""Decimal places of tables: layers count in µm."""


def _plain(values: np.ndarray) -> list[Any]:
    """Values as tables write them; where there is no date the cell stays empty."""
    if values.dtype.kind == "f":
        values = values.round(DIGITS)
    if values.dtype.kind == "M":
        return ["" if np.isnat(date) else str(date) for date in values]
    return list(values.tolist())
