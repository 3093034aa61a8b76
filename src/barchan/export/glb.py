"""glTF in one binary file: the surface with normals, texture coordinates and colours."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.export.colours import colour_facts, colours_of
from barchan.export.gltf import Gltf
from barchan.export.mesh import Part, Surface, mesh_facts, parts_of, quads, surface_of, triangles
from barchan.export.source import Source

AXES = "x to the east, y up, z to the south"


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the surface, y up and north towards -z, as the format wants it; the texture's top lies north."""
    surface, scene = surface_of(source), Gltf()
    parts = Parts(scene, source.grid.shape, source)
    parts.add(attributes_of(surface, source))
    scene.write(path)
    return {**mesh_facts(source, AXES), **parts_facts(parts.parts), **colour_facts(source)}


class Parts:
    """The parts of a surface in a scene; triangles and texture coordinates are those of all its frames."""

    def __init__(self, scene: Gltf, shape: tuple[int, int], source: Source) -> None:
        """Split a surface of rows and columns of points as the source's options ask for."""
        self.scene, self.source = scene, source
        self.shape = rows, columns = shape
        self.parts = parts_of(self.shape, source.options.split)
        u, v = np.meshgrid(np.linspace(0, 1, columns, dtype="<f4"), np.linspace(1, 0, rows, dtype="<f4"))
        texture = np.stack([u, v], axis=-1)
        self._common = [
            (
                scene.array(part.of(texture, self.shape)),
                scene.triangles(triangles(quads(part.shape)), part.vertices),
            )
            for part in self.parts
        ]

    def add(self, attributes: dict[str, NDArray]) -> list[int]:
        """Add the meshes of a frame with attributes of all its points; returns the numbers of their nodes."""
        nodes = []
        for part, (texture, corners) in zip(self.parts, self._common, strict=True):
            numbers = {
                name: self.scene.array(part.of(values, self.shape), extent=name == "POSITION")
                for name, values in attributes.items()
            }
            name = name_of(part, self.parts, self.source)
            nodes.append(self.scene.mesh(name, {**numbers, "TEXCOORD_0": texture}, corners))
        return nodes


def attributes_of(surface: Surface, source: Source) -> dict[str, NDArray]:
    """Places, normals and colours of the points of the only frame of a source."""
    return {
        "POSITION": turned(surface.vertices),
        "NORMAL": turned(surface.normals),
        "COLOR_0": in_proportion_to_light(colours_of(source)),
    }


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
