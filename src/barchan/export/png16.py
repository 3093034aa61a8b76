"""16-bit height map as PNG: one field of one frame."""

from pathlib import Path
from typing import Any

from barchan.export.numbers import northern_first, sixteen_bits
from barchan.export.source import Source


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a field as grey levels, linear and without a gamma."""
    from PIL import Image

    numbers, mapping = sixteen_bits(source, source.sheet())
    Image.fromarray(northern_first(source, numbers)).save(path, format="PNG", compress_level=6)
    return mapping
