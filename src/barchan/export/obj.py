"""Wavefront OBJ: the surface as text."""

from pathlib import Path
from typing import Any

from barchan.export.mesh import mesh_facts, surface_of
from barchan.export.source import Source


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the surface as squares, shaded smoothly, y up and north towards -z, as importers expect."""
    surface = surface_of(source)
    x, y, z = surface.vertices.T
    points = zip(x.tolist(), z.tolist(), (-y).tolist(), strict=True)
    with path.open("w", encoding="utf-8") as file:
        file.write(f"# {source.scenario.title or 'Run'}, step {source.steps[0]}, metres\no surface\ns 1\n")
        file.writelines(map("v %.9g %.9g %.9g\n".__mod__, points))
        file.writelines(map("f %d %d %d %d\n".__mod__, map(tuple, (surface.quads + 1).tolist())))
    return mesh_facts(source, "x to the east, y up, z to the south")
