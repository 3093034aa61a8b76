"""VTK image data in XML, the numbers appended as they are."""

from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from barchan.export.source import Source
from barchan.export.wind import WindOver

TYPES = {"f4": "Float32", "f8": "Float64", "u1": "UInt8", "i1": "Int8", "u2": "UInt16", "i2": "Int16",
         "i4": "Int32", "u4": "UInt32", "i8": "Int64", "u8": "UInt64"}  # fmt: skip
"""VTK's names of number types."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write one frame as point data at the cells' centres."""
    (step,) = source.steps
    wind = WindOver.of(source, step)
    write_image(path, source, wind.over(source.sheets(step)), wind.arrays)
    return wind.facts


def write_image(path: Path, source: Source, arrays: dict[str, NDArray], wind: dict[str, NDArray]) -> None:
    """Write arrays of the source's grid, and the wind as data of the whole field; three axes are vectors."""
    grid = source.grid
    extent = f"0 {grid.columns - 1} 0 {grid.rows - 1} 0 0"
    main = ' Scalars="elevation"' if "elevation" in arrays else ""
    declared, offset = [], 0
    for name, values in arrays.items():
        kind = TYPES[f"{values.dtype.kind}{values.dtype.itemsize}"]
        declared.append(
            f'<DataArray type="{kind}" Name={quoteattr(name)}{_parts(values, 2)} '
            f'format="appended" offset="{offset}"/>'
        )
        offset += values.nbytes + 8
    lines = "\n".join(declared)
    whole = "\n".join(
        f'<DataArray type="Float64" Name="{name}"{_parts(values, 0)} NumberOfTuples="1" format="ascii">'
        f"{' '.join(map(repr, values.tolist()))}</DataArray>"
        for name, values in wind.items()
    )
    head = f"""<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="{extent}" Origin="{float(grid.x[0])!r} {float(grid.y[0])!r} 0" \
Spacing="{grid.width!r} {grid.height!r} 1">
<FieldData>
{whole}
</FieldData>
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


def _parts(values: NDArray, axes: int) -> str:
    """How many numbers stand for a place, where values have an axis beyond those of places."""
    return f' NumberOfComponents="{values.shape[-1]}"' if values.ndim > axes else ""
