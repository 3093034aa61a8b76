"""Raw height maps: the numbers alone, in rows, little-endian; 16-bit whole numbers or 32-bit floats."""

from pathlib import Path
from typing import Any

from barchan.export.numbers import first_row, floats, northern_first, sixteen_bits
from barchan.export.source import Source


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write one field of one frame; files whose name ends with r32 get floats."""
    sheet = source.sheet()
    told: dict[str, Any] = {"byte_order": "little-endian"}
    if path.suffix.lower() == ".r32":
        path.write_bytes(northern_first(source, floats(sheet.values)).tobytes())
        return {**told, "first_row": first_row(source), "numbers": "32-bit floats"}
    numbers, mapping = sixteen_bits(source, sheet)
    path.write_bytes(northern_first(source, numbers).tobytes())
    return {**told, **mapping}
