"""glTF in one binary file: the surface with normals, texture coordinates and colours."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.export.gltf import Gltf
from barchan.export.mesh import Part, colours_of, mesh_facts, parts_of, quads, surface_of, triangles
from barchan.export.source import Source

AXES = "x to the east, y up, z to the south"


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the surface, y up and north towards -z, as the format wants it; the texture's top lies north."""
    surface = surface_of(source)
    shape = rows, columns = surface.z.shape
    u, v = np.meshgrid(np.linspace(0, 1, columns), np.linspace(1, 0, rows))
    arrays = {
        "POSITION": turned(surface.vertices),
        "NORMAL": turned(surface.normals),
        "TEXCOORD_0": np.stack([u, v], axis=-1).reshape(-1, 2).astype("<f4"),
        "COLOR_0": in_proportion_to_light(colours_of(source)),
    }
    scene = Gltf()
    parts = parts_of(shape, source.options.split)
    for part in parts:
        numbers = {
            name: scene.array(part.of(values, shape), extent=name == "POSITION")
            for name, values in arrays.items()
        }
        corners = scene.triangles(triangles(quads(part.shape)), part.vertices)
        scene.mesh(name_of(part, parts, source), numbers, corners)
    scene.write(path)
    return {**mesh_facts(source, AXES), **parts_facts(parts)}


def turned(vectors: NDArray[np.float32]) -> NDArray[np.float32]:
    """Vectors (east, north, up) as the format has them: (east, up, south)."""
    return vectors[:, (0, 2, 1)] * np.array([1.0, 1.0, -1.0], "<f4")


def in_proportion_to_light(colours: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Colours (red, green, blue as screens show them) as the format wants them: linear, four bytes each."""
    opaque = np.full((len(colours), 1), 255.0)
    return np.rint(np.concatenate([linear(colours) * 255.0, opaque], axis=1)).astype("u1")


def linear(colours: NDArray[np.float32]) -> NDArray[np.float64]:
    """Colours as screens show them, in proportion to light."""
    return np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)


def name_of(part: Part, parts: list[Part], source: Source) -> str:
    """The name of a part: the run's, with its place where there are several."""
    title = source.scenario.title or "Run"
    return title if len(parts) == 1 else f"{title}, row {part.row}, column {part.column}"


def parts_facts(parts: list[Part]) -> dict[str, Any]:
    """What the side-car file says of the parts of a mesh."""
    return {"parts": {"number": len(parts), "most_vertices": max(part.vertices for part in parts)}}
