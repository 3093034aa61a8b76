"""Stanford PLY, binary: the surface with normals, colours and fields at its vertices."""

from pathlib import Path
from typing import Any

import numpy as np

from barchan.export.colours import colour_facts, colours_of
from barchan.export.mesh import mesh_facts, surface_of
from barchan.export.numbers import floats
from barchan.export.source import Source

NAMES = {"f4": "float", "u1": "uchar"}


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the surface, z up; each field is a property of the vertices, in its own unit."""
    surface = surface_of(source)
    sheets = source.sheets(source.steps[0])
    columns = [(name, "f4") for name in ("x", "y", "z", "nx", "ny", "nz")]
    columns += [(name, "u1") for name in ("red", "green", "blue")]
    columns += [(name, "f4") for name in sheets]
    points = np.empty(surface.z.size, [(name, f"<{kind}") for name, kind in columns])
    for names, values in (
        (("x", "y", "z"), surface.vertices),
        (("nx", "ny", "nz"), surface.normals),
        (("red", "green", "blue"), np.rint(colours_of(source) * 255.0)),
    ):
        for place, name in enumerate(names):
            points[name] = values[:, place]
    for name, sheet in sheets.items():
        points[name] = floats(sheet.values).ravel()
    corners = surface.triangles
    faces = np.empty(len(corners), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, corners
    properties = "".join(f"property {NAMES[kind]} {name}\n" for name, kind in columns)
    with path.open("wb") as file:
        file.write(
            f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{properties}"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n".encode()
        )
        file.write(points.tobytes())
        file.write(faces.tobytes())
    return {**mesh_facts(source, "x to the east, y to the north, z up"), **colour_facts(source)}
