"""VTK image data in XML, the numbers appended as they are."""

from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from barchan.export.numbers import plain
from barchan.export.source import Source

TYPES = {"f4": "Float32", "f8": "Float64", "u1": "UInt8", "i1": "Int8", "u2": "UInt16", "i2": "Int16",
         "i4": "Int32", "u4": "UInt32", "i8": "Int64", "u8": "UInt64"}  # fmt: skip
"""VTK's names of number types."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write one frame as point data at the cells' centres."""
    sheets = source.sheets(source.steps[0])
    write_image(path, source, {name: plain(sheet.values) for name, sheet in sheets.items()})
    return {}


def write_image(path: Path, source: Source, arrays: dict[str, NDArray]) -> None:
    """Write arrays of the source's grid."""
    grid = source.grid
    extent = f"0 {grid.columns - 1} 0 {grid.rows - 1} 0 0"
    main = ' Scalars="elevation"' if "elevation" in arrays else ""
    declared, offset = [], 0
    for name, values in arrays.items():
        kind = TYPES[f"{values.dtype.kind}{values.dtype.itemsize}"]
        declared.append(
            f'<DataArray type="{kind}" Name={quoteattr(name)} format="appended" offset="{offset}"/>'
        )
        offset += values.nbytes + 8
    lines = "\n".join(declared)
    head = f"""<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="{extent}" Origin="{float(grid.x[0])!r} {float(grid.y[0])!r} 0" \
Spacing="{grid.width!r} {grid.height!r} 1">
<Piece Extent="{extent}">
<PointData{main}>
{lines}
</PointData>
</Piece>
</ImageData>
<AppendedData encoding="raw">
_"""
    with path.open("wb") as file:
        file.write(head.encode())
        for values in arrays.values():
            file.write(np.uint64(values.nbytes).astype("<u8").tobytes())
            file.write(np.ascontiguousarray(values).tobytes())
        file.write(b"\n</AppendedData>\n</VTKFile>\n")
