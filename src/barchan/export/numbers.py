"""Number types and order of rows that formats want."""

import numpy as np
from numpy.typing import NDArray

from barchan.errors import ExportError
from barchan.export.source import Sheet, Source


def plain(values: NDArray) -> NDArray:
    """Values in types that every reader knows: 32-bit floats, bytes for yes and no, or whole numbers."""
    if values.dtype.kind == "f":
        return values.astype("<f4")
    return values.astype("u1") if values.dtype.kind == "b" else values.astype(values.dtype.newbyteorder("<"))


def floats(values: NDArray) -> NDArray[np.float32]:
    """Values as little-endian 32-bit floats."""
    return values.astype("<f4")


def northern_first(source: Source, values: NDArray) -> NDArray:
    """Rows from north to south, as pictures have them; from south to north where that is asked for."""
    return np.ascontiguousarray(values if source.options.flip else values[::-1])


def first_row(source: Source) -> str:
    """The edge at which the first row of a file lies."""
    return "south" if source.options.flip else "north"


LARGEST = 65535
"""The largest whole number of 16 bits."""


def sixteen_bits(source: Source, sheet: Sheet) -> tuple[NDArray[np.uint16], dict[str, object]]:
    """A field as whole numbers of 16 bits, and what they stand for.

    0 is the lowest value and 65535 the highest, of all exported frames or as the option ``limits`` says.
    Raises ExportError for values beyond these limits and for cells without a value.
    """
    low, high = limits_of(source, sheet)
    values = sheet.values.astype(np.float64)
    if not np.isfinite(values).all():
        raise ExportError(
            f"{sheet.name} has cells without a value, which 16 bits cannot tell; choose a 32-bit format"
        )
    scaled = np.rint((values - low) / (high - low) * LARGEST)
    mapping = {
        "lowest": low,
        "highest": high,
        "unit": sheet.unit,
        "meaning": sheet.meaning,
        "value": f"lowest + number × {(high - low) / LARGEST!r}",
        "per_unit": (high - low) / LARGEST,
        "first_row": first_row(source),
    }
    return scaled.astype("<u2"), {"numbers": {sheet.name: mapping}}


def limits_of(source: Source, sheet: Sheet) -> tuple[float, float]:
    """The values that 0 and the largest number stand for."""
    low, high = source.ranges[sheet.name]
    if source.options.limits is not None:
        least, most = source.options.limits
        if low < least or high > most:
            raise ExportError(
                f"--limits {least:g} {most:g}: {sheet.name} lies between {low:g} and {high:g} {sheet.unit}; "
                "allowed: limits that hold all values"
            )
        return least, most
    if sheet.values.dtype.kind == "b":
        return 0.0, 1.0
    return low, high if high > low else low + source.scenario.lattice.thickness
