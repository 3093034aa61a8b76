"""Plain TIFF of 32-bit floats, without coordinates: one field of one frame."""

from pathlib import Path
from typing import Any

from barchan.export.numbers import first_row, floats, northern_first
from barchan.export.source import Source


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a field in its own unit."""
    from PIL import Image

    values = northern_first(source, floats(source.sheet().values))
    Image.fromarray(values).save(path, format="TIFF")
    return {"first_row": first_row(source), "numbers": "32-bit floats"}
